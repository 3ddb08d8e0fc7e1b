#pragma once

#include <vector>

#include "host-sim/surface/grid_draft.hpp"

namespace sim::surface {

/// Returns the indices of outliers. A point inside the grid is an outlier if its height differs
/// from the median of its eight neighbours by many times the spread. The spread is the greater one
/// of
/// - the difference from that median that nine of ten points of the grid stay within, converted to
///   a standard deviation, and
/// - the range of the neighbours' heights; of eight neighbours the greatest and the least are left
///   out.
///
/// A point with two neighbours near its height is not an outlier: it belongs to an edge. Missing
/// points are neither outliers nor neighbours. Clusters of bad points are not found.
[[nodiscard]] std::vector<std::size_t> outliers_of(const GridDraft& grid);

}  // namespace sim::surface
