#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "host-sim/measure/path_deviation.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// Energy per length divided by the energy per length that S and F require; 1 if the beam works as
/// programmed.
struct EnergyFigures {
  double least = 0.0;
  double mean = 0.0;  ///< Sum of the measured light divided by the sum of the programmed light.
  double greatest = 0.0;
  /// Position of the greatest value along the programmed path: the end of its window, mm.
  double greatest_at_mm = 0.0;
  double min_at_mm = 0.0;
  std::size_t windows = 0;  ///< Number of windows; 0 if nothing was measured.
};

/// Integrates the beam along the programmed path, in windows of 0.05 mm.
///
/// A step is due where its axis crosses half a step. Thus each edge shows, to the tick, when the
/// machine was at one point of the curve. Between edges, the speed counts as constant. Edges of an
/// axis are ignored if the path crosses its steps at a flat angle, because then their time is
/// inaccurate. A run of lit pieces is measured separately, from its start to its end. A run shorter
/// than a window is not measured. Light outside of a run counts at the nearest end of the run.
class EnergyMeter final : public TraceSink {
 public:
  static constexpr double kWindow = 0.05;  ///< Length of a window, mm.

  struct Options {
    double max_speed = 1000.0;  ///< S of full power ($30).
    double min_speed = 0.0;     ///< S of the least power ($31).
    /// Returns the light for a duty of the output, as a share 0…1 of the greatest light. If it is
    /// empty, the light is the duty itself.
    std::function<double(float)> light{};
    /// Called at the end of each window with the window's seconds of full power per mm.
    std::function<void(double)> on_window{};
  };

  /// Begins the measurement.
  /// @param deviation follows the same trace on `path`, and must receive each row first. It and
  /// `path` must outlive the meter.
  EnergyMeter(const ProgrammedPath& path,
              const PathDeviation& deviation,
              const cnc::AxisArray<double>& steps_per_mm,
              Options options);

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;

  /// Returns the figures. They are complete after on_end().
  [[nodiscard]] EnergyFigures figures() const;

 private:
  /// A point on the path, with the sum of the light and of the programmed light up to it.
  struct Sample {
    double place = 0.0;
    double light = 0.0;
    double programmed = 0.0;
  };

  /// A step of a motor, at which its axis crosses a position.
  struct Edge {
    std::size_t axis = 0;
    double place = 0.0;      ///< Position that the axis crosses, mm.
    double direction = 1.0;  ///< Direction of the step: 1 or −1.
  };

  void pass_to(std::uint64_t time_ns);
  void look(const cnc::AxisArray<std::int32_t>& position);
  [[nodiscard]] bool lit(std::size_t piece) const { return density_[piece] > 0.0; }
  [[nodiscard]] std::optional<double> fraction_at(
      const PathFollower::Match& match, const cnc::AxisArray<std::int32_t>& position) const;
  [[nodiscard]] static double crossing(const Curve& curve, double near, const Edge& edge);
  void begin_run(std::size_t piece);
  void end_run();
  void add(const Sample& sample);
  [[nodiscard]] Sample at_start_of(std::size_t piece) const;

  const ProgrammedPath* path_;
  const PathDeviation* deviation_;
  Point step_{};
  Options options_;
  std::vector<double> density_;  ///< Programmed light of each piece, seconds of full power per mm.
  /// Positions on the path of the start of each piece, and of the end of the path, mm.
  std::vector<double> place_before_;
  std::vector<double> programmed_before_;

  std::uint64_t time_ns_ = 0;
  float duty_ = 0.0F;
  double light_ = 0.0;       ///< Sum of the light, seconds of full power.
  double light_dark_ = 0.0;  ///< Value of light_ at the last time when the output was off.
  cnc::AxisArray<std::int32_t> position_{};
  std::size_t run_first_ = 0;
  /// One past the index of the run's last piece. There is no run while it equals run_first_.
  std::size_t run_end_ = 0;
  std::deque<Sample> samples_;
  EnergyFigures figures_{};
  double sum_light_ = 0.0;
  double sum_programmed_ = 0.0;
};

}  // namespace sim
