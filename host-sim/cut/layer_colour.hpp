#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace sim::cut {

/// Reads a colour and returns it as 0xRRGGBB. It reads `#rgb`, `#rrggbb`, `rgb(r, g, b)` with
/// numbers or percentages, the 16 basic names of SVG with a few more, and `ACI 1` to `ACI 9` of
/// DXF. Returns nothing for other texts.
[[nodiscard]] std::optional<std::uint32_t> colour_from(std::string_view text);

/// Returns whether a name means this colour of a drawing. The name may be the same colour in
/// another notation, or a colour of the LightBurn palette by its number (`C00` to `C29`, `T1`,
/// `T2`). It may also be the name of a basic colour, which means the colour of the palette as well:
/// `green` is #008000 and #00E000, and `orange` is #FFA500 and #FF8000.
[[nodiscard]] bool is_colour_named(std::string_view colour, std::string_view name);

}  // namespace sim::cut
