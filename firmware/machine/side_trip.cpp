#include "firmware/machine/side_trip.hpp"

#include "firmware/machine/feed_segments.hpp"

namespace cnc {

void SideTrip::begin(const AxisArray<StepPosition>& place) {
  segmenter_.reset(place);
  segmenter_.go_on();
}

void SideTrip::go(std::size_t axis,
                  StepPosition to,
                  float feed_mm_s,
                  const motion::BeamCommand& beam) {
  AxisArray<StepPosition> end = place();
  end[axis] = to;
  go(end, feed_mm_s, beam);
}

/// Moves all axes. The limits of the block are computed from whole steps, the nearest to its two
/// end points. Then the end of the block is set to the exact position.
void SideTrip::go(const AxisArray<StepPosition>& to,
                  float feed_mm_s,
                  const motion::BeamCommand& beam) {
  motion::MotionRequest request{.feed_mm_s = feed_mm_s, .beam = beam, .fixed_feed = true};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const AxisScale& scale = limits_.scale[axis];
    request.element.start[axis] = scale.place_of(place()[axis].nearest_step());
    request.element.end[axis] = scale.place_of(to[axis].nearest_step());
  }
  auto block = motion::build_block(request, limits_);
  if (!block.ok()) return;
  motion::Block exact = block.value();
  exact.end = to;
  queue_.push(exact);
}

void SideTrip::feed_drive() {
  if (segmenter_.idle() && motors_.at_rest()) return;  // Usually there is no trip.
  feed_segments(drive_, [this](motion::Segment& segment) {
    return motion::next_segment(segmenter_, motors_, segment);
  });
}

}  // namespace cnc
