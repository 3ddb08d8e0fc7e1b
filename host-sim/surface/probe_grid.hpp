#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>

namespace sim::surface {

/// One direction of a grid to probe, in work coordinates, mm.
struct ProbeSpan {
  double from_mm = 0.0;
  double to_mm = 0.0;
  std::size_t count = 0;  ///< Points, both ends included.

  [[nodiscard]] double pitch_mm() const {
    return (to_mm - from_mm) / static_cast<double>(count - 1);
  }
  /// Returns the coordinate of a point, from 0; that of the last is `to_mm` exactly.
  [[nodiscard]] double at(std::size_t index) const;
};

/// A regular grid of places to probe. Its rows run along X, the first at the least Y; they are
/// driven as a serpentine: even ones with X rising, odd ones with X falling.
struct ProbeGrid {
  ProbeSpan x;  ///< Columns.
  ProbeSpan y;  ///< Rows.

  [[nodiscard]] std::size_t size() const { return x.count * y.count; }
  /// Returns the place of a point whose index counts row by row, each with X rising.
  [[nodiscard]] Eigen::Vector2d place(std::size_t index) const {
    return {x.at(index % x.count), y.at(index / x.count)};
  }
  /// Returns the index of the point that is driven to as the `turn`th, from 0.
  [[nodiscard]] std::size_t driven(std::size_t turn) const;
  /// Returns the index of the point nearest to a place.
  [[nodiscard]] std::size_t nearest(const Eigen::Vector2d& place) const;
  /// Returns the lesser distance of neighbours, mm.
  [[nodiscard]] double least_pitch_mm() const;
  /// Returns `row 2, column 7 (X 30, Y 5)`, counted from 1 at the least X and Y.
  [[nodiscard]] std::string name(std::size_t index) const;
};

/// Points of a grid at most: probing takes a second for each, at least.
inline constexpr std::size_t kMaxProbePoints = 1'000'000;

/// Returns the span with neighbours that are at most `pitch_mm` apart, spread evenly. Throws
/// std::invalid_argument for a pitch that is no length, or too many points.
[[nodiscard]] ProbeSpan span_of_pitch(double from_mm, double to_mm, double pitch_mm);

/// Throws std::invalid_argument unless the grid has two rows and columns of finite places at
/// least, rising, and no more than kMaxProbePoints.
void require_probe_grid(const ProbeGrid& grid);

}  // namespace sim::surface
