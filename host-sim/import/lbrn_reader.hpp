#pragma once

#include <string>
#include <string_view>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Returns whether a file begins like a project of LightBurn (`.lbrn`, `.lbrn2`).
/// @param start beginning of the file, after blanks and byte order mark
[[nodiscard]] bool is_lbrn(std::string_view start);

/// Reads a project of LightBurn, in mm. Supports rectangles, ellipses, paths, groups of these,
/// pictures, and letters if the project contains their outlines. The layers of the drawing get the
/// settings of the project (Layer::offered).
///
/// Letters without outlines, and layers that the project does not send to the laser, are left out
/// with a note. Polygons are faults, because the file does not contain their corners, and so are
/// all other shapes. Tabs, kerf offsets and sub-layers are ignored, with a note. A project whose
/// coordinates are mirrored is mirrored back, with a note.
void read_lbrn(const std::string& text, Sketch& sketch);

}  // namespace sim::drawing
