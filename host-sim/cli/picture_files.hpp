#pragma once

#include <string>

#include "host-sim/import/drawing.hpp"

namespace sim {

/// Returns the path of a file from its path relative to the drawing that names it.
[[nodiscard]] std::string file_beside(const std::string& drawing, const std::string& name);

/// Returns the function that reads the pictures next to a drawing; empty for standard input, which
/// has no folder.
[[nodiscard]] drawing::ReadBeside reader_beside(const std::string& drawing);

}  // namespace sim
