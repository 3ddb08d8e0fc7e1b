#pragma once

#include "host-sim/surface/grid_draft.hpp"

namespace sim::surface {

/// Gives each missing point the mean height of its neighbours in row and column. Finds these means
/// by sweeps over all missing points. The sweeps end when no height changes by more than a
/// millionth of the range of heights, or after 1,000 sweeps. Throws std::invalid_argument if more
/// than half of the points are missing.
void fill_missing(GridDraft& grid);

}  // namespace sim::surface
