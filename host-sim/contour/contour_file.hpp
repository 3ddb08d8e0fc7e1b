#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/contour/outline.hpp"

namespace sim {

/// Reports the faults of a drawing, one fault per line.
class FaultyDrawing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns whether the content of a file is not a drawing, but begins like the contours of
/// contour_text.hpp: with a number, after comments and blank lines.
[[nodiscard]] bool is_contour_text(std::string_view text);

/// The loops of one part of a file.
struct ContourPart {
  Contour contour;
  /// One layer for each loop. Contours from text have no layers and no names in `contour`.
  std::vector<drawing::Layer> layers;
};

/// The treatment of contours of a drawing that cross each other or run along each other.
enum class Crossing : std::uint8_t {
  /// They are replaced by the outline of the area that they fill, and a note reports it.
  kFilled,
  kRefused,  ///< They are a fault, because it would be a guess which of their areas is meant.
};

/// The contours of a file.
struct ContourFile {
  /// One entry for each part of a file of parts, otherwise one entry.
  std::vector<ContourPart> parts{};
  /// Contours that are read differently from the drawing, with their points.
  std::vector<std::string> notes{};
};

/// Reads closed contours from the text of a file. The content decides how it is read: SVG, DXF or
/// JSON as drawing.hpp reads them, with curves fitted as in outline.hpp; otherwise text as in
/// contour_text.hpp. Parts may lie on top of each other. Material is on the left of every loop.
/// @param file name of the file, for messages
/// @throw ContourTextError
/// @throw FaultyDrawing if a drawing has any error, or if letters are left out
[[nodiscard]] ContourFile contours_of(const std::string& text,
                                      const std::string& file,
                                      const OutlineOptions& options,
                                      Crossing crossing);

}  // namespace sim
