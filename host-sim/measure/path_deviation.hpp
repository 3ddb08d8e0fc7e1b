#pragma once

#include <cstdint>
#include <limits>

#include "host-sim/measure/path_follower.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// Something greatest, and where it was.
struct DeviationPeak {
  double value = 0.0;
  std::uint64_t time_ns = 0;
  Point position{};  ///< Of the motors, mm and degrees.
  int line = 0;      ///< Of the program; 0 before the first piece.
};

/// How far the motors ever stood from the programmed path, edge by edge.
///
/// Two measures. The distance is Euclidean over the axes; an ideal machine has
/// up to half the diagonal of a step, for its motors stand on whole steps. The
/// axis excess takes this away: by how much an axis is farther than half a step
/// from the best point of the path. At most 0 for an ideal machine.
///
/// Rows must begin at the start of the path. A position off the path by many
/// steps is measured well, too, but the place of a machine that leaves out a
/// part of the path can only be guessed.
class PathDeviation final : public TraceSink {
 public:
  /// `path` must outlive this; steps per degree for A, B and C. An axis excess of
  /// no more than `floor` mm is not looked for, which saves most of the work.
  PathDeviation(const ProgrammedPath& path,
                const cnc::AxisArray<double>& steps_per_mm,
                double floor = -std::numeric_limits<double>::infinity());
  PathDeviation(ProgrammedPath&& path,
                const cnc::AxisArray<double>& steps_per_mm,
                double floor = 0.0) = delete;

  void on_row(const TraceRow& row) override;
  /// Takes a place in mm and degrees in place of a row's.
  void stand(std::uint64_t time_ns, const Point& place);

  [[nodiscard]] const DeviationPeak& greatest_distance() const { return distance_; }
  /// mm, or degrees where a rotary axis decides; the floor, if it was never above.
  [[nodiscard]] const DeviationPeak& greatest_axis_excess() const { return excess_; }
  /// Where on the path the machine is, as far as can be told; null on an empty path.
  [[nodiscard]] const PathPiece* present_piece() const;
  /// The nearest point of the path to the last row's position; meaningless on an empty path.
  [[nodiscard]] const PathFollower::Match& present_match() const { return match_; }
  /// From the last row's position to the end of the path, mm.
  [[nodiscard]] double distance_to_end() const;
  /// The machine came to the last piece of the path.
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
