#pragma once

#include <string>

#include "host-sim/sheet/sheet_file.hpp"

namespace sim::sheet {

/// Makes a sheet that has a drawing as its only part. The part moves only as far as it must to be
/// at least `margin_mm` inside the left and lower edges of the stock. The stock is the box of the
/// part, with the margin around it.
/// @param target name of the sheet file to write; the drawing is named relative to its folder
/// @param margin_mm 0 or more
[[nodiscard]] Sheet sheet_of(const drawing::Drawing& drawn,
                             const std::string& target,
                             double margin_mm);

/// Returns the sheet for writing to the file `target`: its drawings are named relative to the
/// folder of this file.
[[nodiscard]] Sheet moved_to(const Sheet& sheet, const std::string& target);

}  // namespace sim::sheet
