#pragma once

#include <string>

#include "host-sim/import/drawing.hpp"

namespace sim {

/// Returns the path of a file that a drawing names by its path from the drawing.
[[nodiscard]] std::string file_beside(const std::string& drawing, const std::string& name);

/// Returns what reads the pictures beside a drawing; nothing for standard input, which has no
/// folder.
[[nodiscard]] drawing::ReadBeside reader_beside(const std::string& drawing);

}  // namespace sim
