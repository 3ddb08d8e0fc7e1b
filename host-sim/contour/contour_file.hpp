#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/contour/outline.hpp"

namespace sim {

/// What is wrong with a drawing, one fault to a line.
class FaultyDrawing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether the content of a file is no drawing, but begins like contours as contour_text.hpp has
/// them: with a number, after comments and blank lines.
[[nodiscard]] bool is_contour_text(std::string_view text);

/// The loops of one part of a file.
struct ContourPart {
  Contour contour;
  std::vector<drawing::Layer> layers;  ///< One for each loop; text has none, and no names in it.
};

/// The treatment of contours of a drawing that cross each other or run along each other.
enum class Crossing : std::uint8_t {
  kFilled,   ///< They are read as what they fill, and a note says so.
  kRefused,  ///< They are a fault: which of their areas is meant is a guess.
};

/// The contours of a file.
struct ContourFile {
  std::vector<ContourPart> parts{};  ///< One for each part of a file of parts, else one.
  std::vector<std::string> notes{};  ///< Contours that are read otherwise than drawn, with places.
};

/// Reads closed contours from the text of a file: SVG, DXF or JSON as drawing.hpp has them, curves
/// fitted as outline.hpp does, else text as contour_text.hpp has it; told by content. Parts may lie
/// on each other. Material is on the left of every loop.
/// @param file its name, for messages
/// @throw ContourTextError
/// @throw FaultyDrawing if there is any error in a drawing, or letters are left out
[[nodiscard]] ContourFile contours_of(const std::string& text,
                                      const std::string& file,
                                      const OutlineOptions& options,
                                      Crossing crossing);

}  // namespace sim
