#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "host-sim/measure/path_deviation.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// Energy per length over what S and F ask for: 1 where the beam does as programmed.
struct EnergyFigures {
  double least = 0.0;
  double mean = 0.0;  ///< Of all light over all that was programmed.
  double greatest = 0.0;
  double greatest_at_mm = 0.0;  ///< Along the programmed path, end of the window.
  double least_at_mm = 0.0;
  std::size_t windows = 0;  ///< 0: nothing was measured.
};

/// Integrates the beam along the programmed path, in windows of 0.05 mm.
///
/// A step is due where its axis crosses half a step, so each edge says to the tick when
/// the machine was at one place of the curve; between them it goes evenly. Edges of
/// axes that the path crosses flatly are left out: their time says little. A run of
/// lit pieces is measured by itself, from its start to its end; one shorter than
/// a window is not. Light that falls outside a run counts to its ends.
class EnergyMeter final : public TraceSink {
 public:
  static constexpr double kWindow = 0.05;  ///< mm.

  struct Options {
    double most_speed = 1000.0;  ///< $30: S of full power.
    double least_speed = 0.0;    ///< $31.
    /// Light of an output duty, 0…1 of the greatest; the duty itself when empty.
    std::function<double(float)> light{};
    /// Told of each window that ends now: seconds of full power per mm.
    std::function<void(double)> on_window{};
  };

  /// `deviation` follows the same trace on `path` and sees each row first; both must
  /// outlive the meter.
  EnergyMeter(const ProgrammedPath& path,
              const PathDeviation& deviation,
              const cnc::AxisArray<double>& steps_per_mm,
              Options options);

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;

  /// Complete after on_end.
  [[nodiscard]] EnergyFigures figures() const;

 private:
  /// A place on the path, the light up to it, and what was programmed up to it.
  struct Sample {
    double place = 0.0;
    double light = 0.0;
    double programmed = 0.0;
  };

  /// A motor's step: the axis crosses a place.
  struct Edge {
    std::size_t axis = 0;
    double place = 0.0;      ///< mm.
    double direction = 1.0;  ///< Or −1.
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
  std::vector<double> density_;       ///< Of each piece, s of full power per mm.
  std::vector<double> place_before_;  ///< Of each piece and of the end, mm.
  std::vector<double> programmed_before_;

  std::uint64_t time_ns_ = 0;
  float duty_ = 0.0F;
  double light_ = 0.0;       ///< s of full power.
  double light_dark_ = 0.0;  ///< When the output was last off.
  cnc::AxisArray<std::int32_t> position_{};
  std::size_t run_first_ = 0;
  std::size_t run_end_ = 0;  ///< Behind its last piece; no run while both are the same.
  std::deque<Sample> samples_;
  EnergyFigures figures_{};
  double sum_light_ = 0.0;
  double sum_programmed_ = 0.0;
};

}  // namespace sim
