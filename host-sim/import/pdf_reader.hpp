#pragma once

#include <string>
#include <string_view>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Returns true where a file begins as PDF does; drawings of Illustrator do, as a rule.
/// @param start without blanks and byte order mark
[[nodiscard]] bool is_pdf(std::string_view start);

/// Reads the first page of a PDF file, in mm: what it strokes and fills, letters included, as
/// paths, 0.0001 mm off what the file says at most. A layer is a colour; layers of the PDF itself
/// are not kept.
///
/// Further pages are a note. A file that is broken, or locked by a password, is refused. Faults
/// have no line: the paths of a page are not lines of its file.
void read_pdf(const std::string& text, Sketch& sketch);

}  // namespace sim::drawing
