#include "planner/motion/jerk/motion_filter.hpp"

#include <algorithm>

#include "planner/base/contract.hpp"

namespace cnc::motion {
namespace {

/// Shortest duration of the last stretch of a motion, in ns. Driving a single remaining path unit
/// within a nanosecond would require more acceleration than axes have.
constexpr std::uint32_t kShortestEndNs = 4'000;

}  // namespace

void MotionFilter::begin(const TimeWindow& window) {
  *this = {};
  window_ = window;
}

void MotionFilter::add(const Stretch& stretch) {
  const auto duration_ns = static_cast<std::uint32_t>(stretch.duration_ns);
  CNC_ASSERT(duration_ns <= room_ns());
  const float sum = stretch.start_speed + stretch.end_speed;
  // Mean over time of the distance driven since the start of the stretch, as a share of the whole
  // distance of the stretch. The formula is exact, because the acceleration is constant.
  const float mean =
      sum > 0.0F ? (2.0F * stretch.start_speed + stretch.end_speed) / (3.0F * sum) : 0.5F;
  const float way = to_mm(place_ - from_) + mean * to_mm(stretch.way);
  const float share = static_cast<float>(duration_ns) / static_cast<float>(window_.cell_ns);
  mean_way_ += way * share;
  place_ += stretch.way;
  used_ns_ += duration_ns;
  moved_ns_ = used_ns_;
}

void MotionFilter::rest() {
  const float share = static_cast<float>(room_ns()) / static_cast<float>(window_.cell_ns);
  mean_way_ += to_mm(place_ - from_) * share;
  used_ns_ = window_.cell_ns;
}

Stretch MotionFilter::take() {
  CNC_ASSERT(room_ns() == 0);
  const bool stood = place_ == from_;
  const Cell newest{
      .mean = stood ? place_ : from_ + to_units(mean_way_), .end = place_, .moved_ns = moved_ns_};
  Cell& oldest = cells_[oldest_];
  const PathUnits window_way = place_ - oldest.end;
  const float seconds = window_.seconds();
  const std::uint32_t last_ns = oldest.moved_ns > 0 ? std::max(oldest.moved_ns, kShortestEndNs) : 0;
  Stretch motion{.way = next_way(newest, oldest),
                 .duration_ns = window_way > 0 ? window_.cell_ns : last_ns,
                 .start_speed = speed_,
                 .end_speed = to_mm(window_way) / seconds};
  // Computed from the difference between the plan's distances in the newest and in the oldest cell,
  // because the difference of two nearly equal speeds has no exact digits.
  motion.acceleration = window_way > 0
                            ? to_mm(window_way - window_way_) / (seconds * window_.cell_seconds())
                            : -speed_ / (static_cast<float>(last_ns) * 1.0e-9F);
  oldest = newest;
  oldest_ = oldest_ + 1 == window_.cells ? 0 : oldest_ + 1;
  window_way_ = window_way;
  speed_ = motion.end_speed;
  from_ = place_;
  mean_way_ = 0.0F;
  used_ns_ = 0;
  moved_ns_ = 0;
  return motion;
}

/// Returns the distance, in path units, that the motion drives in the cell. The position of the
/// motion is the mean position over all cells. So it grows by (newest mean − oldest mean) / number
/// of cells.
PathUnits MotionFilter::next_way(const Cell& newest, const Cell& oldest) {
  const PathUnits sum = remainder_ + (newest.mean - oldest.mean);
  const PathUnits way = sum / static_cast<PathUnits>(window_.cells);
  remainder_ = sum - way * static_cast<PathUnits>(window_.cells);
  return way;
}

}  // namespace cnc::motion
