#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Says what is wrong where: `file:line: reason`.
class ContourTextError : public std::runtime_error {
 public:
  ContourTextError(std::string_view file, std::size_t line, std::string_view reason);
};

/// Contours as text, one vertex to a line: `x y` or `x y bulge`, mm, the bulge
/// being tan(sweep / 4) of the arc to the next vertex. `closed` or a blank line
/// ends a loop, which always leads back to its first vertex; `#` begins a
/// comment. Throws ContourTextError, naming `file`.
[[nodiscard]] Contour contour_from_text(std::string_view text, std::string_view file);

/// The same, with as many digits as each number needs to come back unchanged.
[[nodiscard]] std::string text_of_contour(const cnc::contour::ContourView<double>& contour);

}  // namespace sim
