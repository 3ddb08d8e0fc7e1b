#include "firmware/machine/motion_control.hpp"

#include <algorithm>

#include "firmware/machine/feed_segments.hpp"

namespace cnc {
namespace {

/// A sender that is silent for so long while the machine stands has no more to say.
constexpr std::int32_t kAtRestUs = 5'000;

/// mm/s², of the axes that the block moves.
float least_acceleration(const motion::Limits& limits, const motion::Block& block) {
  const std::uint8_t axes = motion::moving_axes(block);
  float least = 1.0e9F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if ((axes >> axis & 1U) != 0) least = std::min(least, limits.acceleration_mm_s2[axis]);
  }
  return least;
}

}  // namespace

Result<bool, motion::MotionError> MotionControl::append(const path::PathItem& item) {
  const PathElement& element = item.request.element;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    // It was an end: one that is out of reach now has changed in memory.
    CNC_ASSERT(limits_.scale[axis].reaches(element.start[axis]));
    const bool within = limits_.scale[axis].reaches(element.end[axis]);
    if (!within) return motion::MotionError::kBeyondMotorRange;
  }
  if (element.start == element.end) return false;
  silence_us_ = 0;
  ++elements_taken_;
  stage_.put(item);
  // As many lines to a row as half the blocks that are planned: what is held back is little
  // beside it, and few lines are known in small rows, many in large ones.
  if (2 * stage_.gathered() >= queue_.size()) stage_.end_row();
  target_ = element.end;
  pump();
  return true;
}

/// From the path to blocks, as far as there is room.
void MotionControl::pump() {
  while (!queue_.full()) {
    const path::PathPiece* const piece = stage_.next();
    if (piece == nullptr) return;
    take(*piece);
  }
}

/// Apart from pump(), which goes deep for its pieces: a block is large.
void MotionControl::take(const path::PathPiece& piece) {
  // Else memory has changed, and a way that is long on paper would be driven on one place.
  CNC_ASSERT(joins(piece.request.element.start));
  const auto block = motion::build_block(piece.request, limits_);
  // Pieces lie between ends that were within reach, to a tolerance.
  CNC_ASSERT(block.ok() || block.error() == motion::MotionError::kNothingToMove);
  if (!block.ok()) return;
  queue_.push(block.value(), piece.joint);
  ++blocks_taken_;
}

/// Whether a piece that starts here goes on where the one before it ends, to a step.
bool MotionControl::joins(const Position& start) const {
  constexpr std::uint64_t kStep = std::uint64_t{1} << 32;
  const AxisArray<StepPosition>& end =
      queue_.empty() ? segmenter_.place() : queue_.at(queue_.size() - 1).end;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto steps = limits_.scale[axis].steps_at(start[axis]);
    if (!steps) return false;
    const auto apart = static_cast<std::uint64_t>(steps->q32() - end[axis].q32());
    if (apart + kStep > 2 * kStep) return false;
  }
  return true;
}

void MotionControl::flush() {
  stage_.flush();
  pump();
  queue_.leave_none_out();
  if (stage_.empty()) queue_.expect_no_more();
}

/// Whether the plan would soon have to brake for what is not planned yet: its way ends
/// within twice the way that braking takes, what goes by until the next turns, and
/// where jerk is limited what the plan is ahead by and goes level for before it brakes.
bool MotionControl::runs_dry() const {
  constexpr float kTurnsAheadS = 0.05F;
  constexpr float kWindows = 1.5F;
  if (segmenter_.idle()) return true;
  const float speed = std::max(segmenter_.speed(), segmenter_.planned_speed());
  const float ahead_s = kTurnsAheadS + kWindows * segmenter_.window().seconds();
  const float acceleration = std::min(least_acceleration(limits_, queue_.front()),
                                      least_acceleration(limits_, queue_.at(queue_.size() - 1)));
  const float reach = speed * (speed / acceleration + ahead_s);
  float way = segmenter_.left_of_block();
  for (std::size_t i = 1; i < queue_.size() && way <= reach; ++i) way += queue_.at(i).length;
  return way <= reach;
}

/// A sender that has more to say says it within a few milliseconds.
void MotionControl::attend(std::int32_t elapsed_us) {
  constexpr std::int32_t kPatienceUs = 20'000;
  // From the first of what is held: a weld of few lines is a poor start.
  constexpr std::int32_t kGatheringUs = 10'000;
  // With so many blocks longer welds are worth more than more blocks.
  constexpr std::size_t kPlenty = 16;
  paid_for_ += std::min(work_owed(), kSpansInATurn);
  silence_us_ = std::min(silence_us_ + elapsed_us, kPatienceUs);
  held_us_ = stage_.empty() ? 0 : std::min(held_us_ + elapsed_us, kGatheringUs);
  const bool idle = segmenter_.idle();
  const bool silent = silence_us_ >= (idle ? kAtRestUs : kPatienceUs);
  if (silent) queue_.leave_none_out();
  const bool waits = idle ? held_us_ < kGatheringUs : queue_.size() >= kPlenty;
  if (stage_.empty() || (waits && !silent) || !runs_dry()) return;
  if (silent) {
    stage_.flush();
  } else {
    stage_.hurry(idle);
  }
}

void MotionControl::feed_drive() {
  pump();
  follow_tool();
  if (stage_.empty() && silence_us_ >= kAtRestUs) queue_.expect_no_more();
  feed_segments(drive_, segmenter_, motors_);
}

AxisArray<std::int32_t> MotionControl::tool_steps() const {
  AxisArray<std::int32_t> steps = drive_.position();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    steps[axis] = motors_.backlash(axis).moved_by(steps[axis], tool_[axis]);
  }
  return steps;
}

/// Between two looks an axis may have turned round, so that at rest, where all that is known
/// is certain, it is set right.
void MotionControl::follow_tool() {
  tool_ = tool_steps();
  if (drive_.running() || !motors_.at_rest() || !motors_.settled()) return;
  const AxisArray<std::int32_t> steps = drive_.position();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    tool_[axis] = tool_at_contact(axis, steps[axis]);
  }
}

void MotionControl::set_tool(std::size_t axis, std::int32_t steps) {
  drive_.set_position(axis, steps);
  motors_.rebase(axis);
  tool_[axis] = steps;
}

void MotionControl::configure(const motion::MotorStageSetting& setting) {
  if (setting == motor_setting_) return;
  motor_setting_ = setting;
  const AxisArray<std::int32_t> steps = tool_steps();
  motors_.configure(setting);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) set_tool(axis, steps[axis]);
  motors_.reset(segmenter_.place(), {});
}

void MotionControl::follow_kerf(const kerf::KerfCourse* course) {
  // Else the stage was not told of the motions so far.
  if (!motors_.active()) motors_.reset(segmenter_.place(), {});
  segmenter_.follow_kerf(course);
}

void MotionControl::drop_rest() {
  follow_tool();
  const AxisArray<std::int32_t> motors = drive_.position();
  target_ = place_of(tool_);
  stage_.clear();
  pixels_.clear();
  AxisArray<StepPosition> place{};
  AxisArray<std::int32_t> ahead{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    place[axis] = StepPosition::whole(tool_[axis]);
    ahead[axis] = motors[axis] - tool_[axis];
  }
  segmenter_.reset(place);
  motors_.reset(place, ahead);
}

Position MotionControl::place_of(const AxisArray<std::int32_t>& steps) const {
  Position place;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    place[axis] = limits_.scale[axis].place_of(steps[axis]);
  }
  return place;
}

}  // namespace cnc
