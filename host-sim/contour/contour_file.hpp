#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/contour/outline.hpp"

namespace sim {

/// Exception for a drawing that has faults. Its message lists the faults, one on each line.
class FaultyDrawing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns whether the content of a file is not a drawing, but contours in text as in
/// contour_text.hpp. Such a text begins with a number, after comments and blank lines.
[[nodiscard]] bool is_contour_text(std::string_view text);

/// The loops of one part of a file.
struct ContourPart {
  Contour contour;
  /// Layer of each loop. Empty for contours from text, which have no layers and no names.
  std::vector<drawing::Layer> layers;
};

/// The treatment of contours of a drawing that cross each other or run along each other.
enum class Crossing : std::uint8_t {
  /// The contours are replaced by the outlines of the area that they fill, and a note reports it.
  kFilled,
  /// The contours are a fault, because it would be a guess which of their areas is meant.
  kRefused,
};

/// The contours of a file.
struct ContourFile {
  /// The parts. A file that does not describe parts has one entry.
  std::vector<ContourPart> parts{};
  /// Notes about contours that were changed when the drawing was read, with their positions.
  std::vector<std::string> notes{};
};

/// Reads closed contours from the text of a file. The content determines the format: a drawing is
/// read by drawing.hpp, and its curves are fitted by outline.hpp. Other content is read as text by
/// contour_text.hpp. Parts may lie on top of each other. The material is on the left of each loop.
/// @param file name of the file, for messages
/// @throw ContourTextError
/// @throw FaultyDrawing if a drawing has any error, or if letters are left out
[[nodiscard]] ContourFile contours_of(const std::string& text,
                                      const std::string& file,
                                      const OutlineOptions& options,
                                      Crossing crossing);

}  // namespace sim
