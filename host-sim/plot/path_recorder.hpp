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
/// Rows are gathered over windows of some milliseconds, which give the speed. PathSimplifier then
/// thins the path to a distance of 0.01 mm or two motor steps, whichever is greater, and to a 64th
/// of the greatest speed. A path with more than `kMaxVertices` vertices is thinned again with
/// twice the distance, so that memory and picture are bounded. Even such a path is far finer than
/// the picture.
class PathRecorder final : public TraceSink {
 public:
  /// These vertices take about 1.5 MB of SVG.
  static constexpr std::size_t kMaxVertices = 50'000;

  /// @param steps_per_mm steps per mm of X, Y and Z, all > 0; motions of A, B and C are not shown
  explicit PathRecorder(const cnc::AxisArray<float>& steps_per_mm, Shown shown = Shown::kSpeed);

  /// Sets how the rows from now on are driven. Until the first call, motion with the beam off
  /// counts as travel.
  void on_motion_kind(bool rapid) { is_rapid_ = rapid; }

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;

  /// Returns the vertices of the path that are final so far. New vertices are appended at the end.
  /// When the path is thinned, it is replaced by a shorter one.
  [[nodiscard]] const std::vector<PathVertex>& settled() const { return simplifier_.vertices(); }

  /// Returns the path.
  /// @pre on_end() was called
  [[nodiscard]] const Path& path() const { return path_; }

 private:
  using Position = cnc::AxisArray<std::int32_t>;  ///< Position in steps.
  struct Sample {
    double x_mm;
    double y_mm;
    Move move;
    float value;  ///< Height or output. The speed is that of the window.
  };

  [[nodiscard]] Move move_of_stretch() const;
  [[nodiscard]] SpeedWindow::Point point_between(const Position& before,
                                                 const Position& after) const;
  void start(const TraceRow& row);
  void add_sample(const SpeedWindow::Point& point);
  /// Ends the path, or makes it pause, exactly at the position of the motors.
  void come_to_rest();
  /// Sets the speed of the samples in the window, and starts the next window.
  void close_window();
  /// Converts heights to depths, once the highest cut is known.
  void measure_depths();

  cnc::AxisArray<double> mm_per_step_{};
  Shown shown_;
  std::optional<bool> is_rapid_;
  Position position_{};             ///< Position in the last row.
  float duty_ = 0.0F;               ///< Output since the last row.
  Move last_move_ = Move::kTravel;  ///< Kind of the stretch that ended in the last row.
  bool has_started_ = false;
  SpeedWindow window_;
  std::vector<Sample> samples_;  ///< Samples in the window.
  PathSimplifier simplifier_;
  float last_speed_mm_s_ = 0.0F;
  float greatest_speed_mm_s_ = 0.0F;
  Path path_;
};

}  // namespace sim
