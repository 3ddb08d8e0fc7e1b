#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace sim::cut {

/// Returns a colour as 0xRRGGBB: `#rgb`, `#rrggbb`, `rgb(r, g, b)` with numbers or percents, the
/// 16 basic names of SVG with a few more, and `ACI 1` to `ACI 9` of DXF; nothing for other texts.
[[nodiscard]] std::optional<std::uint32_t> colour_from(std::string_view text);

/// Returns whether a colour of a drawing is the one that a name means: the same colour written in
/// another form, a colour of the LightBurn palette by its number (`C00` to `C29`, `T1`, `T2`), or
/// by the name of a basic colour, which means the palette's one as well: `green` is #008000 and
/// #00E000, as `orange` is #FFA500 and #FF8000.
[[nodiscard]] bool is_colour_named(std::string_view colour, std::string_view name);

}  // namespace sim::cut
