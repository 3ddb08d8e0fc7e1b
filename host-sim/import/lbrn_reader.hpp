#pragma once

#include <string>
#include <string_view>

#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Returns whether a file begins as a project of LightBurn does (`.lbrn`, `.lbrn2`).
/// @param start beginning of the file, after blanks and byte order mark
[[nodiscard]] bool is_lbrn(std::string_view start);

/// Reads a project of LightBurn, in mm: rectangles, ellipses and paths, groups of them, pictures,
/// and letters if the project contains their outlines. The layers of the drawing offer the settings
/// of the project.
///
/// Letters without outlines, and layers that the project does not send to the laser, are left out
/// with a note. Polygons, whose corners the file does not contain, and all other shapes are faults.
/// Tabs, kerf offsets and sub-layers are not followed, with a note. A project whose origin is
/// mirrored is mirrored back, with a note.
void read_lbrn(const std::string& text, Sketch& sketch);

}  // namespace sim::drawing
