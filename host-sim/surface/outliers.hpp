#pragma once

#include <vector>

#include "host-sim/surface/grid_draft.hpp"

namespace sim::surface {

/// Returns the indices of points whose height is off the median of their neighbours, eight inside
/// the grid, by many times the spread. Spread is the greater one of
/// - the distance that nine of ten points of the grid are within, as a standard deviation, and
/// - the range of the neighbours' heights, of eight without the greatest and the least.
///
/// A point with two neighbours near its height is none: it belongs to an edge. Missing points are
/// neither outliers nor neighbours. Clusters of bad points are not found.
[[nodiscard]] std::vector<std::size_t> outliers_of(const GridDraft& grid);

}  // namespace sim::surface
