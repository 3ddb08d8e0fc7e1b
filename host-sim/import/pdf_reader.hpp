#pragma once

#include <string>
#include <string_view>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Returns whether a file begins like a PDF. Drawings of Illustrator usually are PDFs.
/// @param start beginning of the file, after blanks and byte order mark
[[nodiscard]] bool is_pdf(std::string_view start);

/// Reads the first page of a PDF file, in mm. All strokes and fills of the page, including letters,
/// become paths. Their points are within 0.0001 mm of the points in the file. Each colour becomes a
/// layer; layers of the PDF itself are not kept.
///
/// A note reports that further pages are not read. A file that is broken or protected by a password
/// is refused. Faults have no line, because the paths of a page are not lines of its file.
void read_pdf(const std::string& text, Sketch& sketch);

}  // namespace sim::drawing
