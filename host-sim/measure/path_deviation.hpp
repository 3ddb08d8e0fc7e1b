#pragma once

#include <cstdint>
#include <limits>

#include "host-sim/measure/path_follower.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// A greatest value, and where it was measured.
struct DeviationPeak {
  double value = 0.0;
  std::uint64_t time_ns = 0;
  Point position{};  ///< Position of the motors, mm and degrees.
  int line = 0;      ///< Line of the program; 0 before the first piece.
};

/// Measures the greatest distance of the motors from the programmed path, edge by edge.
///
/// There are two measures. The distance is Euclidean over the axes; an ideal machine has up to half
/// the diagonal of a step, because its motors rest on whole steps. The axis excess removes this
/// share: it is the amount by which an axis is farther than half a step from the best point of the
/// path, and at most 0 for an ideal machine.
///
/// Rows must begin at the start of the path. A position off the path by many steps is measured
/// well, too. If a machine leaves out a part of the path, its position on the path can only be
/// guessed.
class PathDeviation final : public TraceSink {
 public:
  /// Begins the measurement.
  /// @param path must outlive this object
  /// @param steps_per_mm steps per degree for A, B and C
  /// @param floor axis excess in mm up to which none is searched for, which saves most of the work
  PathDeviation(const ProgrammedPath& path,
                const cnc::AxisArray<double>& steps_per_mm,
                double floor = -std::numeric_limits<double>::infinity());
  PathDeviation(ProgrammedPath&& path,
                const cnc::AxisArray<double>& steps_per_mm,
                double floor = 0.0) = delete;

  void on_row(const TraceRow& row) override;
  /// Takes a position in mm and degrees instead of a row.
  void stand(std::uint64_t time_ns, const Point& place);

  [[nodiscard]] const DeviationPeak& greatest_distance() const { return distance_; }
  /// Returns the greatest axis excess in mm, or in degrees where a rotary axis decides. It is the
  /// floor if no excess was above it.
  [[nodiscard]] const DeviationPeak& greatest_axis_excess() const { return excess_; }
  /// Returns the piece on which the machine most likely is; null on an empty path.
  [[nodiscard]] const PathPiece* present_piece() const;
  /// Returns the nearest point of the path to the last row's position; meaningless on an empty
  /// path.
  [[nodiscard]] const PathFollower::Match& present_match() const { return match_; }
  /// Returns the distance from the last row's position to the end of the path, mm.
  [[nodiscard]] double distance_to_end() const;
  /// Returns whether the machine came to the last piece of the path.
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
