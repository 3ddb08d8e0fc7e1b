#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Exception for a fault in a text of contours, with the message `file:line: reason`.
class ContourTextError : public std::runtime_error {
 public:
  ContourTextError(std::string_view file, std::size_t line, std::string_view reason);
};

/// Reads contours from text with one vertex per line: `x y` or `x y bulge`, in mm. The bulge is
/// tan(sweep / 4) of the arc to the next vertex. `closed` or a blank line ends a loop, which always
/// leads back to its first vertex. `#` begins a comment. Throws ContourTextError, which names
/// `file`.
[[nodiscard]] Contour contour_from_text(std::string_view text, std::string_view file);

/// Returns a contour as text in the format that contour_from_text() reads. Each number has as many
/// digits as are needed to read it back unchanged.
[[nodiscard]] std::string text_of_contour(const cnc::contour::ContourView<double>& contour);

}  // namespace sim
