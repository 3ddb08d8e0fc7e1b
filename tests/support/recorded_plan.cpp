#include "tests/support/recorded_plan.hpp"

#include <algorithm>

namespace proof {

double TimedSlice::fraction_at(double within) const {
  constexpr double kWhole = 4294967296.0;
  const double from = static_cast<double>(slice.from_fraction) / kWhole;
  const double to = static_cast<double>(slice.to_fraction) / kWhole;
  const auto duration = static_cast<double>(slice.duration);
  const double time = std::clamp(within, 0.0, duration);
  const double way = 0.5 * (static_cast<double>(slice.start_speed) + end_speed()) * duration;
  const double driven = 0.5 * (static_cast<double>(slice.start_speed) + speed_at(time)) * time;
  return from + (to - from) * (way > 0.0 ? driven / way : time / duration);
}

double RecordedPlan::steps_at(std::size_t index,
                              double time_s,
                              std::size_t axis,
                              const cnc::motion::Limits& limits) const {
  const TimedSlice& slice = slices[index];
  const double fraction = slice.fraction_at(time_s - slice.start_s);
  const double mm = blocks[slice.slice.block].exact.place_at(fraction)[axis];
  return mm * static_cast<double>(limits.scale[axis].steps_per_mm());
}

}  // namespace proof
