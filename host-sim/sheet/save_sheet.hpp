#pragma once

#include <string>

#include "host-sim/sheet/sheet_file.hpp"

namespace sim::sheet {

/// Makes a sheet of a drawing: one part, where it is if it is at least the margin from both axes,
/// else moved there; the stock is the box of the drawing and the margin beyond it.
/// @param target name of the sheet file that is to be written; the drawing is named from its folder
/// @param margin_mm 0 or more
[[nodiscard]] Sheet sheet_of(const drawing::Drawing& drawn,
                             const std::string& target,
                             double margin_mm);

/// Returns the sheet with its drawings named from the folder of another file.
[[nodiscard]] Sheet moved_to(const Sheet& sheet, const std::string& target);

}  // namespace sim::sheet
