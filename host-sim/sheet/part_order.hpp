#pragma once

#include "host-sim/sheet/sheet_file.hpp"

namespace sim::sheet {

/// Sets the rank (`turn`) of each part of a sheet in the order of cutting. The rank is 0 if the
/// part comes after no other part. Otherwise it is one more than the greatest rank of the parts
/// before it. Names that no part has, and parts that wait for each other in a circle, become faults
/// of the sheet at a pointer such as `/parts/2/after`.
void give_turns(Sheet& sheet);

}  // namespace sim::sheet
