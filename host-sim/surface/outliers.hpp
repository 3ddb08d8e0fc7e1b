#pragma once

#include <vector>

#include "host-sim/surface/grid_draft.hpp"

namespace sim::surface {

/// Returns the indices of outliers. A point has up to eight known neighbours. The point is an
/// outlier if its height differs from their median height by many times the spread. The spread is
/// the greater of
/// - the difference from the median that nine of ten points of the grid do not exceed, converted to
///   a standard deviation, and
/// - the range of the neighbours' heights. Of eight neighbours, the highest and the lowest are left
///   out.
///
/// A point with two neighbours near its height belongs to an edge and is not an outlier. A point
/// with fewer than three known neighbours is not checked. Clusters of bad points are not found.
[[nodiscard]] std::vector<std::size_t> outliers_of(const GridDraft& grid);

}  // namespace sim::surface
