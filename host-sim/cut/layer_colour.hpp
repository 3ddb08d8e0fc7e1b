#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace sim::cut {

/// Returns the colour that a text means, as 0xRRGGBB. The text may be `#rgb`, `#rrggbb`, `rgb(r, g,
/// b)` with numbers or percentages, one of the 16 basic names of SVG and a few more, or `ACI 1` to
/// `ACI 9` of DXF. Returns nothing for any other text.
[[nodiscard]] std::optional<std::uint32_t> colour_from(std::string_view text);

/// Returns whether `name` means the colour `colour` of a drawing. The name may be the same colour
/// in another notation, or the number of a colour of the LightBurn palette (`C00` to `C29`, `T1`,
/// `T2`). It may also be the name of a basic colour. This name also means the colour with the same
/// name in the palette: `green` is #008000 and #00E000, and `orange` is #FFA500 and #FF8000.
[[nodiscard]] bool is_colour_named(std::string_view colour, std::string_view name);

}  // namespace sim::cut
