#include "firmware/machine/side_trip.hpp"

#include "firmware/machine/feed_segments.hpp"

namespace cnc {

void SideTrip::begin(const AxisArray<StepPosition>& place) {
  segmenter_.reset(place);
  segmenter_.go_on();
}

/// The block is built between the nearest steps, for its limits, and then given
/// the exact places.
void SideTrip::go(std::size_t axis,
                  StepPosition to,
                  float feed_mm_s,
                  const motion::BeamCommand& beam) {
  const AxisScale& scale = limits_.scale[axis];
  motion::MotionRequest request{.feed_mm_s = feed_mm_s, .beam = beam, .fixed_feed = true};
  request.element.start[axis] = scale.place_of(place()[axis].nearest_step());
  request.element.end[axis] = scale.place_of(to.nearest_step());
  auto block = motion::build_block(request, limits_);
  if (!block.ok()) return;
  motion::Block exact = block.value();
  exact.end = place();
  exact.end[axis] = to;
  queue_.push(exact);
}

void SideTrip::feed_drive() {
  if (segmenter_.idle() && motors_.at_rest()) return;  // Most of the time.
  feed_segments(drive_, [this](motion::Segment& segment) {
    return motion::next_segment(segmenter_, motors_, segment);
  });
}

}  // namespace cnc
