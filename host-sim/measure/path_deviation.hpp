#pragma once

#include <cstdint>
#include <limits>

#include "host-sim/measure/path_follower.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// A greatest value, with the time and the position at which it was measured.
struct DeviationPeak {
  double value = 0.0;
  std::uint64_t time_ns = 0;
  Point position{};  ///< Position of the motors, mm or degrees.
  int line = 0;      ///< Line of the program; 0 before the first piece.
};

/// Measures the greatest distance of the motors from the programmed path, edge by edge.
///
/// There are two measures. The distance is Euclidean over the axes. On an ideal machine, it is up
/// to half the diagonal of a step, because the motors rest on full steps. The axis excess removes
/// this part. At each point of the path, it takes the greatest distance of an axis from this point
/// minus half a step. The axis excess is the least of these values over the path. On an ideal
/// machine, it is at most 0.
///
/// The rows must begin at the start of the path. A position many steps away from the path is also
/// measured well. If a machine skips a part of the path, its position on the path is only an
/// estimate.
class PathDeviation final : public TraceSink {
 public:
  /// Begins the measurement.
  /// @param path must outlive this object
  /// @param steps_per_mm steps per mm; steps per degree for A, B and C
  /// @param floor axis excess up to which the search is omitted, mm; a high value saves most of the
  /// work
  PathDeviation(const ProgrammedPath& path,
                const cnc::AxisArray<double>& steps_per_mm,
                double floor = -std::numeric_limits<double>::infinity());
  PathDeviation(ProgrammedPath&& path,
                const cnc::AxisArray<double>& steps_per_mm,
                double floor = 0.0) = delete;

  void on_row(const TraceRow& row) override;
  /// Measures a position in mm and degrees instead of a row.
  void stand(std::uint64_t time_ns, const Point& place);

  [[nodiscard]] const DeviationPeak& greatest_distance() const { return distance_; }
  /// Returns the greatest axis excess, in mm, or in degrees if a rotary axis has the greatest
  /// excess. The result is the floor if no excess is above it.
  [[nodiscard]] const DeviationPeak& greatest_axis_excess() const { return excess_; }
  /// Returns the piece on which the machine most likely is; null for an empty path.
  [[nodiscard]] const PathPiece* present_piece() const;
  /// Returns the point of the path nearest to the position of the last row. The result is
  /// meaningless for an empty path.
  [[nodiscard]] const PathFollower::Match& present_match() const { return match_; }
  /// Returns the distance from the position of the last row to the end of the path, mm.
  [[nodiscard]] double distance_to_end() const;
  /// Returns whether the machine reached the last piece of the path.
  [[nodiscard]] bool reached_last_piece() const;

 private:
  [[nodiscard]] int line_of(std::size_t piece) const;

  const ProgrammedPath* path_;
  Point step_{};
  PathFollower follower_;
  Point last_;
  PathFollower::Match match_{};
  DeviationPeak distance_{};
  DeviationPeak excess_{};
};

}  // namespace sim
