#pragma once

#include <string>
#include <string_view>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Returns true where a file begins as a project of LightBurn does (`.lbrn`, `.lbrn2`).
/// @param start without blanks and byte order mark
[[nodiscard]] bool is_lbrn(std::string_view start);

/// Reads a project of LightBurn, in mm: rectangles, ellipses and paths, groups of them, and letters
/// where the project keeps their outlines. Its layers offer their settings.
///
/// Pictures, letters without outlines, and layers that the project does not send to the laser are
/// left out with a note; polygons, whose corners the file does not have, and everything else that
/// is a shape are faults. Tabs, kerf offsets and sub-layers are not taken, with a note. A project
/// whose origin is mirrored is mirrored back, with a note.
void read_lbrn(const std::string& text, Sketch& sketch);

}  // namespace sim::drawing
