#pragma once

#include <string>

#include "host-sim/sheet/sheet_file.hpp"

namespace sim::sheet {

/// Makes a sheet with a drawing as its only part. The part keeps its position if it is at least the
/// margin away from both axes; else it is moved to that distance. The stock is the box of the part,
/// with the margin around it.
/// @param target name of the sheet file to write; the drawing is named relative to its folder
/// @param margin_mm 0 or more
[[nodiscard]] Sheet sheet_of(const drawing::Drawing& drawn,
                             const std::string& target,
                             double margin_mm);

/// Returns the sheet with its drawings named relative to the folder of another file.
[[nodiscard]] Sheet moved_to(const Sheet& sheet, const std::string& target);

}  // namespace sim::sheet
