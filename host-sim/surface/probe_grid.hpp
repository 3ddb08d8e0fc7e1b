#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>

namespace sim::surface {

/// Coordinates of a probing grid along one axis, in work coordinates, mm.
struct ProbeSpan {
  double from_mm = 0.0;
  double to_mm = 0.0;
  std::size_t count = 0;  ///< Number of points, including both ends.

  [[nodiscard]] double pitch_mm() const {
    return (to_mm - from_mm) / static_cast<double>(count - 1);
  }
  /// Returns the coordinate of the point `index`, counted from 0. The last point is at `to_mm`
  /// exactly.
  [[nodiscard]] double at(std::size_t index) const;
};

/// A regular grid of points to probe. Its rows run along X, and the first row has the lowest Y. The
/// machine drives the rows as a serpentine: even rows with rising X, odd rows with falling X.
struct ProbeGrid {
  ProbeSpan x;  ///< X coordinates of the columns.
  ProbeSpan y;  ///< Y coordinates of the rows.

  [[nodiscard]] std::size_t size() const { return x.count * y.count; }
  /// Returns X and Y of a point. `index` counts row by row, with rising X in each row.
  [[nodiscard]] Eigen::Vector2d place(std::size_t index) const {
    return {x.at(index % x.count), y.at(index / x.count)};
  }
  /// Returns the index of the point that the machine probes at position `turn` of its serpentine,
  /// counted from 0.
  [[nodiscard]] std::size_t driven(std::size_t turn) const;
  /// Returns the index of the point that is nearest to `place`.
  [[nodiscard]] std::size_t nearest(const Eigen::Vector2d& place) const;
  /// Returns the smaller of the two pitches, between columns and between rows, mm.
  [[nodiscard]] double min_pitch_mm() const;
  /// Returns the name of a point for messages: `row 2, column 7 (X 30, Y 5)`, counted from 1 at the
  /// lowest X and Y.
  [[nodiscard]] std::string name(std::size_t index) const;
};

/// Maximum number of points of a grid. Probing a larger grid would take more than eleven days,
/// because a point takes at least a second.
inline constexpr std::size_t kMaxProbePoints = 1'000'000;

/// Returns a span of evenly spaced points whose distance is at most `pitch_mm`.
/// Throws std::invalid_argument if `pitch_mm` is not a length above 0, or gives too many points.
[[nodiscard]] ProbeSpan span_of_pitch(double from_mm, double to_mm, double pitch_mm);

/// Throws std::invalid_argument unless the grid has at least two rows and two columns, finite and
/// rising coordinates, and at most kMaxProbePoints points.
void require_probe_grid(const ProbeGrid& grid);

}  // namespace sim::surface
