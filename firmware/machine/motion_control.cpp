#include "firmware/machine/motion_control.hpp"

#include <algorithm>
#include <cmath>

namespace cnc {

Result<bool, motion::MotionError> MotionControl::append(const path::PathItem& item) {
  const PathElement& element = item.request.element;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const bool within = limits_.scale[axis].steps_at(element.end[axis]).has_value();
    if (!within) return motion::MotionError::kBeyondMotorRange;
  }
  if (element.start == element.end) return false;
  silence_us_ = 0;
  stage_.put(item);
  target_ = element.end;
  pump();
  return true;
}

/// From the path to blocks, as far as there is room.
void MotionControl::pump() {
  path::PathPiece piece;
  while (!queue_.full() && stage_.next(piece)) {
    const auto block = motion::build_block(piece.request, limits_);
    // Pieces lie between ends that were within reach, to a tolerance.
    CNC_ASSERT(block.ok() || block.error() == motion::MotionError::kNothingToMove);
    if (!block.ok()) continue;
    queue_.push(block.value(), piece.joint);
    ++blocks_taken_;
  }
}

void MotionControl::flush() {
  stage_.flush();
  pump();
}

/// What is left of the plan, mm: of the block being driven at least its chord.
/// @pre !segmenter_.idle()
float MotionControl::way_left() const {
  float square = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const std::int64_t left = queue_.front().end[axis].q32() - segmenter_.place()[axis].q32();
    const float steps = static_cast<float>(left >> 16) * (1.0F / 65'536.0F);
    const float mm = steps / limits_.scale[axis].steps_per_mm();
    square += mm * mm;
  }
  float way = std::sqrt(square);
  for (std::size_t i = 1; i < queue_.size(); ++i) way += queue_.at(i).length;
  return way;
}

/// With twice the way that braking takes, and what goes by until the next turns.
bool MotionControl::runs_dry() const {
  constexpr float kTurnsAhead_s = 0.05F;
  constexpr std::size_t kPlenty = 16;
  if (queue_.size() >= kPlenty) return false;
  if (segmenter_.idle()) return true;
  const float speed = segmenter_.speed();
  const float acceleration = *std::ranges::min_element(limits_.acceleration_mm_s2);
  return way_left() <= speed * (speed / acceleration + kTurnsAhead_s);
}

/// A sender that has more to say says it within a few milliseconds.
void MotionControl::attend(std::int32_t elapsed_us) {
  constexpr std::int32_t kPatience_us = 20'000;
  constexpr std::int32_t kAtRest_us = 5'000;
  silence_us_ = std::min(silence_us_ + elapsed_us, kPatience_us);
  if (stage_.empty() || !runs_dry()) return;
  if (!segmenter_.idle()) stage_.hurry();
  if (silence_us_ >= (segmenter_.idle() ? kAtRest_us : kPatience_us)) stage_.flush();
}

void MotionControl::feed_drive() {
  pump();
  motion::Segment segment;
  while (!drive_.full() && drive_.ticks_waiting() < drive_.ticks_ahead() &&
         segmenter_.next(segment)) {
    drive_.push(segment);
  }
}

void MotionControl::drop_rest() {
  const AxisArray<std::int32_t> steps = drive_.position();
  target_ = place_of(steps);
  stage_.clear();
  AxisArray<StepPosition> place{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    place[axis] = StepPosition::whole(steps[axis]);
  }
  segmenter_.reset(place);
}

Position MotionControl::place_of(const AxisArray<std::int32_t>& steps) const {
  Position place;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    place[axis] = limits_.scale[axis].place_of(steps[axis]);
  }
  return place;
}

}  // namespace cnc
