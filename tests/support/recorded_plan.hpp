#pragma once

#include <vector>

#include "planner/motion/segment/segmenter.hpp"
#include "tests/support/exact_block.hpp"

namespace proof {

/// A slice of the plan with its start time.
struct TimedSlice {
  cnc::motion::Slice slice{};
  double start_s = 0.0;

  [[nodiscard]] double end_s() const { return start_s + static_cast<double>(slice.duration); }
  [[nodiscard]] double end_speed() const { return speed_at(static_cast<double>(slice.duration)); }
  /// Returns the speed at a time within the slice, mm/s. @param within time since the slice's
  /// start, s
  [[nodiscard]] double speed_at(double within) const {
    return static_cast<double>(slice.start_speed) +
           static_cast<double>(slice.acceleration) * within;
  }
  /// Returns the fraction of the block's length that is driven, in proportion to the planned
  /// distance.
  [[nodiscard]] double fraction_at(double within) const;
};

/// A block as it was planned, with its exact geometry.
struct PlannedBlock {
  cnc::motion::Block block{};
  ExactBlock exact;
  cnc::Position end{};
  bool from_rest = false;  ///< The program requires a stop before this block.
  cnc::PathElement element{};
};

/// Record of the blocks, slices and segments that the segmenter planned.
class RecordedPlan final : public cnc::motion::SliceObserver {
 public:
  void on_slice(const cnc::motion::Slice& slice) override {
    slices.push_back({slice, seconds});
    seconds += static_cast<double>(slice.duration);
  }

  /// Returns the motor position of an axis at a time in slice `index`, in unrounded steps.
  [[nodiscard]] double steps_at(std::size_t index,
                                double time_s,
                                std::size_t axis,
                                const cnc::motion::Limits& limits) const;

  std::vector<PlannedBlock> blocks;
  std::vector<TimedSlice> slices;
  std::vector<cnc::motion::Segment> segments;
  double seconds = 0.0;
};

}  // namespace proof
