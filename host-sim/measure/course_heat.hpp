#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>

#include "host-sim/measure/edge_track.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// The light on each millimetre by the motors' own course in X and Y, whatever path they are on:
/// the output over the speed, which is the way from a millisecond before to a millisecond after.
/// For motors that leave their path, where the EnergyMeter has no places; it sees nothing
/// shorter than its two milliseconds, and nothing slower than 2.5 mm/s.
class CourseHeat final : public TraceSink {
 public:
  /// mm, and seconds of full output per mm there.
  using OnPlace = std::function<void(const std::array<double, 2>&, double)>;

  /// @param on_place told of every row of which the output is lit, some 0.2 s later
  CourseHeat(const cnc::AxisArray<double>& steps_per_mm, OnPlace on_place);

  void on_row(const TraceRow& row) override;
  void on_end(std::uint64_t time_ns) override;

 private:
  static constexpr double kWindow = 0.002;  ///< s, of the courses.
  static constexpr double kHalf = 0.001;    ///< s.

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
