#pragma once

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

/// Reads closed contours from a file, `-` being standard input: SVG, DXF or JSON as
/// drawing.hpp has them, curves fitted as outline.hpp does, else text as contour_text.hpp has it;
/// told by content. One contour for each part of a file of parts, which may lie on each other; else
/// one. Material is on the left of every loop. Throws std::system_error naming the
/// file, ContourTextError, and FaultyDrawing if there is any error in a drawing.
[[nodiscard]] std::vector<ContourPart> read_contour_parts(const std::string& file,
                                                          const OutlineOptions& options);

/// Returns the same of a file that has been read.
/// @param file its name, for messages
[[nodiscard]] std::vector<ContourPart> contour_parts_of(const std::string& text,
                                                        const std::string& file,
                                                        const OutlineOptions& options);

/// Reads the same without the layers.
[[nodiscard]] std::vector<Contour> read_contour_file(const std::string& file,
                                                     const OutlineOptions& options);

}  // namespace sim
