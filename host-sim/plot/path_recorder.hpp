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

/// Collects the path for a picture from the rows of the trace, in bounded memory.
///
/// Rows are collected over windows of some milliseconds, over which the speed is measured.
/// PathSimplifier then thins the path. Its distance tolerance is the greater of 0.01 mm and two
/// motor steps. Its speed tolerance is a 64th of the greatest speed. A path with more than
/// `kMaxVertices` vertices is thinned again with twice the distance tolerance, so that memory and
/// picture are bounded. Even such a path is much finer than the picture.
class PathRecorder final : public TraceSink {
 public:
  /// Greatest number of vertices. A path with this number of vertices takes about 1.5 MB of SVG.
  static constexpr std::size_t kMaxVertices = 50'000;

  /// @param steps_per_mm steps per mm of X, Y and Z, all > 0; motions of A, B and C are ignored
  explicit PathRecorder(const cnc::AxisArray<float>& steps_per_mm, Shown shown = Shown::kSpeed);

  /// Sets whether the following rows belong to a rapid. Before the first call, motion with the beam
  /// off counts as travel.
  void on_motion_kind(bool rapid) { is_rapid_ = rapid; }

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;

  /// Returns the vertices of the path so far. Later vertices are appended at the end, but when the
  /// path is thinned, fewer vertices replace all of them.
  [[nodiscard]] const std::vector<PathVertex>& settled() const { return simplifier_.vertices(); }

  /// Returns the path.
  /// @pre on_end() was called
  [[nodiscard]] const Path& path() const { return path_; }

 private:
  using Position = cnc::AxisArray<std::int32_t>;  ///< Position of the motors, in steps.
  struct Sample {
    double x_mm;
    double y_mm;
    Move move;
    /// Height or output, if the picture shows depth or power. The speed is computed when the window
    /// ends.
    float value;
  };

  [[nodiscard]] Move move_of_stretch() const;
  [[nodiscard]] SpeedWindow::Point point_between(const Position& before,
                                                 const Position& after) const;
  void start(const TraceRow& row);
  void add_sample(const SpeedWindow::Point& point);
  /// Adds a sample exactly at the position of the motors, at the end of the path or before a pause.
  void come_to_rest();
  /// Ends the window: passes its samples on with the speed of the window, and starts the next
  /// window.
  void close_window();
  /// Converts heights to depths, after the highest cut is known.
  void measure_depths();

  cnc::AxisArray<double> mm_per_step_{};
  Shown shown_;
  std::optional<bool> is_rapid_;
  Position position_{};             ///< Position in the last row.
  float duty_ = 0.0F;               ///< Output of beam or spindle since the last row, 0…1.
  Move last_move_ = Move::kTravel;  ///< Kind of the stretch that ended at the last row.
  bool has_started_ = false;
  SpeedWindow window_;
  std::vector<Sample> samples_;  ///< Samples in the present window.
  PathSimplifier simplifier_;
  float last_speed_mm_s_ = 0.0F;
  float greatest_speed_mm_s_ = 0.0F;
  Path path_;
};

}  // namespace sim
