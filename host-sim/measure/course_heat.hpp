#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>

#include "host-sim/measure/edge_track.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// Measures the light on each millimetre along the motors' own path in X and Y. This path may
/// differ from the programmed path. The light per millimetre is the output divided by the speed.
/// The speed is measured from a millisecond before to a millisecond after the position. Use
/// CourseHeat for motors that leave the programmed path, because EnergyMeter measures only on that
/// path. CourseHeat does not resolve times below two milliseconds or speeds below 2.5 mm/s.
class CourseHeat final : public TraceSink {
 public:
  /// Receives a position in mm, and the seconds of full output per mm at this position.
  using OnPlace = std::function<void(const std::array<double, 2>&, double)>;

  /// Begins the measurement.
  /// @param on_place called about 0.2 s later for every row whose output is on
  CourseHeat(const cnc::AxisArray<double>& steps_per_mm, OnPlace on_place);

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;

 private:
  static constexpr double kWindow = 0.002;  ///< Window of the axes' courses (EdgeTrack), s.
  static constexpr double kHalf = 0.001;  ///< Half of the time over which the speed is measured, s.

  struct Lit {
    double time_s = 0.0;
    std::array<double, 2> place{};
    double light = 0.0;
  };

  void tell_until(double time_s);

  std::array<double, 2> step_mm_;
  OnPlace on_place_;
  std::array<EdgeTrack, 2> behind_{EdgeTrack{kWindow, 0.0}, EdgeTrack{kWindow, 0.0}};
  std::array<EdgeTrack, 2> ahead_{EdgeTrack{kWindow, 0.0}, EdgeTrack{kWindow, 0.0}};
  std::array<std::int32_t, 2> steps_{};
  float duty_ = 0.0F;
  std::deque<Lit> lit_;
};

}  // namespace sim
