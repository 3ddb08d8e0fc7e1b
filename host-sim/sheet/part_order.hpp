#pragma once

#include "host-sim/sheet/sheet_file.hpp"

namespace sim::sheet {

/// Gives each part of a sheet its turn by the parts that it comes after: 0 where there are none,
/// else one more than the greatest of theirs. Names that no part has, and parts that wait for each
/// other in a circle, become faults of the sheet, at `/parts/2/after`.
void give_turns(Sheet& sheet);

}  // namespace sim::sheet
