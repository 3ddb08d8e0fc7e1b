#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Reports a fault and its line: `file:line: reason`.
class ContourTextError : public std::runtime_error {
 public:
  ContourTextError(std::string_view file, std::size_t line, std::string_view reason);
};

/// Reads contours from text with one vertex per line: `x y` or `x y bulge`, in mm. The bulge is
/// tan(sweep / 4) of the arc to the next vertex. `closed` or a blank line ends a loop, which always
/// leads back to its first vertex. `#` begins a comment. Throws ContourTextError, which names
/// `file`.
[[nodiscard]] Contour contour_from_text(std::string_view text, std::string_view file);

/// Returns a contour in the format of contour_from_text(). Each number has as many digits as it
/// needs to be read back unchanged.
[[nodiscard]] std::string text_of_contour(const cnc::contour::ContourView<double>& contour);

}  // namespace sim
