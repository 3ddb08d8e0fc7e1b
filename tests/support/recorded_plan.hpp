#pragma once

#include <vector>

#include "planner/motion/segment/segmenter.hpp"
#include "tests/support/exact_block.hpp"

namespace proof {

/// A slice of the plan with the time at which it begins.
struct TimedSlice {
  cnc::motion::Slice slice{};
  double start_s = 0.0;

  [[nodiscard]] double end_s() const { return start_s + static_cast<double>(slice.duration); }
  [[nodiscard]] double end_speed() const { return speed_at(static_cast<double>(slice.duration)); }
  /// @param within s since its start.
  [[nodiscard]] double speed_at(double within) const {
    return static_cast<double>(slice.start_speed) +
           static_cast<double>(slice.acceleration) * within;
  }
  /// Of the block's length, in proportion to the planned way.
  [[nodiscard]] double fraction_at(double within) const;
};

/// A block as it was planned, beside its exact geometry.
struct PlannedBlock {
  cnc::motion::Block block{};
  ExactBlock exact;
  cnc::Position end{};
  bool from_rest = false;  ///< Something made the machine stop before it.
  cnc::PathElement element{};
};

/// What the segmenter planned, all of it.
class RecordedPlan final : public cnc::motion::SliceObserver {
 public:
  void on_slice(const cnc::motion::Slice& slice) override {
    slices.push_back({slice, seconds});
    seconds += static_cast<double>(slice.duration);
  }

  /// Motor positions in steps, unrounded, while slice `index` is driven.
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
