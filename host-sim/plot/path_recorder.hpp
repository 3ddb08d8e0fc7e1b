#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/plot/path.hpp"
#include "host-sim/plot/path_simplifier.hpp"
#include "host-sim/plot/speed_window.hpp"
#include "host-sim/trace/trace_row.hpp"
#include "planner/base/axes.hpp"

namespace sim {

/// Collects the path for the picture from the motion itself, in bounded memory.
///
/// Rows are gathered over windows of some milliseconds, which give the speed,
/// and thinned by PathSimplifier to 0.01 mm or two motor steps, whichever is
/// more, and a 64th of the greatest speed. A job that still has more than
/// `kMostVertices` is thinned again with twice the tolerance, so neither memory
/// nor picture grows without end; such a job is far finer than the picture.
class PathRecorder final : public TraceSink {
 public:
  /// About 1.5 MB of SVG.
  static constexpr std::size_t kMostVertices = 50'000;

  /// Steps per mm of X, Y and Z, all > 0; motions of A, B and C do not show.
  explicit PathRecorder(const cnc::AxisArray<float>& steps_per_mm, Shown shown = Shown::kSpeed);

  /// Says how the rows from now on are driven. Until the first call, whatever
  /// moves with the beam off is taken for travel.
  void on_motion_kind(bool rapid) { is_rapid_ = rapid; }

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;

  /// What is settled of the path so far. It grows at its end, and begins anew,
  /// shorter, when it is thinned.
  [[nodiscard]] const std::vector<PathVertex>& settled() const { return simplifier_.vertices(); }

  /// @pre on_end was called.
  [[nodiscard]] const Path& path() const { return path_; }

 private:
  using Position = cnc::AxisArray<std::int32_t>;  ///< Steps.
  struct Sample {
    double x_mm;
    double y_mm;
    Move move;
    float value;  ///< Height or output; the speed is that of the window.
  };

  [[nodiscard]] Move move_of_stretch() const;
  [[nodiscard]] SpeedWindow::Point point_between(const Position& before,
                                                 const Position& after) const;
  void start(const TraceRow& row);
  void add_sample(const SpeedWindow::Point& point);
  /// The path ends, or pauses, exactly where the motors are.
  void come_to_rest();
  /// Gives the samples of the window their speed and starts the next window.
  void close_window();
  /// Heights become depths, now that the highest cut is known.
  void measure_depths();

  cnc::AxisArray<double> mm_per_step_{};
  Shown shown_;
  std::optional<bool> is_rapid_;
  Position position_{};             ///< Of the last row.
  float duty_ = 0.0F;               ///< Since the last row.
  Move last_move_ = Move::kTravel;  ///< Of the stretch that ended in the last row.
  bool has_started_ = false;
  SpeedWindow window_;
  std::vector<Sample> samples_;  ///< Of the window.
  PathSimplifier simplifier_;
  float last_speed_mm_s_ = 0.0F;
  float greatest_speed_mm_s_ = 0.0F;
  Path path_;
};

}  // namespace sim
