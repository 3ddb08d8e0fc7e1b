#pragma once

#include "host-sim/surface/grid_draft.hpp"

namespace sim::surface {

/// Gives each missing point the mean height of its neighbours in row and column. The sweeps end
/// when all these means agree to a millionth of the range of heights, or after 1,000 sweeps. Throws
/// std::invalid_argument if more than half of the points are missing.
void fill_missing(GridDraft& grid);

}  // namespace sim::surface
