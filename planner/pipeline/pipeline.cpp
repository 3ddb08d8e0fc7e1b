#include "planner/pipeline/pipeline.hpp"

#include <algorithm>

#include "planner/base/contract.hpp"
#include "planner/motion/block/axis_limits.hpp"

namespace cnc {
namespace {

/// Returns the smallest acceleration limit of the axes that the block moves, mm/s².
float min_acceleration(const motion::Limits& limits, const motion::Block& block) {
  const std::uint8_t axes = motion::moving_axes(block);
  float least = 1.0e9F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if ((axes >> axis & 1U) != 0) least = std::min(least, limits.acceleration_mm_s2[axis]);
  }
  return least;
}

/// Returns whether, on each axis, `start` is less than a step from the end of the motion before it.
bool joins(const motion::Limits& limits,
           const Position& start,
           const AxisArray<StepPosition>& end) {
  constexpr std::uint64_t kStep = std::uint64_t{1} << 32;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto steps = limits.scale[axis].steps_at(start[axis]);
    if (!steps) return false;
    const auto apart = static_cast<std::uint64_t>(steps->q32() - end[axis].q32());
    if (apart + kStep > 2 * kStep) return false;
  }
  return true;
}

/// Returns whether the chord of an element, after a rotation by 90 degrees, can be counted in steps
/// of the axes along which it is then directed. Oblique arcs need no check, because only the path
/// stage makes them, from shorter lines.
bool turns_within(const motion::Limits& limits, const PathElement& element) {
  if (element.bulge == 0.0F || element.plane.oblique()) return true;
  const PlaneAxes axes = axes_of(element.plane);
  return limits.scale[axes.first].reaches(element.end[axes.second] - element.start[axes.second]) &&
         limits.scale[axes.second].reaches(element.end[axes.first] - element.start[axes.first]);
}

}  // namespace

/// Returns whether an element moves, or an error if its end is out of the motors' range.
Result<bool, motion::MotionError> Pipeline::admit(const PathElement& element) const {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    // The start was the end of an element that was admitted. If it is out of range now, memory is
    // corrupt.
    CNC_ASSERT(limits_.scale[axis].reaches(element.start[axis]));
    const bool within = limits_.scale[axis].reaches(element.end[axis]);
    if (!within) return motion::MotionError::kBeyondMotorRange;
  }
  if (!turns_within(limits_, element)) return motion::MotionError::kBeyondMotorRange;
  return element.start != element.end;
}

Result<bool, motion::MotionError> Pipeline::append(const path::PathItem& item) {
  const auto moves = admit(item.request.element);
  if (!moves.ok() || !moves.value()) return moves;
  supply_.restart();
  budget_.take_element();
  path_.put(item);
  // A row may have at most half as many lines as there are planned blocks. So the held part is
  // short compared with the plan, and a program begins with short rows and continues with long
  // rows.
  if (2 * path_.gathered() >= queue_.size()) path_.end_row();
  target_ = item.request.element.end;
  pump();
  return true;
}

bool Pipeline::takes_row(std::size_t pixels) {
  if (path_.takes_row(pixels)) return true;
  pump();
  return path_.takes_row(pixels);
}

Result<bool, motion::MotionError> Pipeline::append_row(const path::PathItem& item,
                                                       const path::RowPowers& powers) {
  const auto moves = admit(item.request.element);
  if (!moves.ok() || !moves.value()) return moves;
  supply_.restart();
  budget_.take_element(static_cast<std::uint32_t>(powers.values.size()));
  path_.put_row(item, powers);
  target_ = item.request.element.end;
  pump();
  return true;
}

/// Converts pieces of the path to blocks until the queue is full.
void Pipeline::pump() {
  while (!queue_.full()) {
    const path::PathPiece* const piece = path_.next();
    if (piece == nullptr) return;
    take(*piece);
  }
}

void Pipeline::take(const path::PathPiece& piece) {
  const AxisArray<StepPosition>& end =
      queue_.empty() ? segmenter_.place() : queue_.at(queue_.size() - 1).end;
  // If this fails, memory is corrupt, and the motors would have to cover a long distance at one
  // point of the path.
  CNC_ASSERT(joins(limits_, piece.request.element.start, end));
  const auto block = motion::build_block(piece.request, limits_);
  // Pieces are, within a tolerance, between the ends of admitted elements, which were within range.
  CNC_ASSERT(block.ok() || block.error() == motion::MotionError::kNothingToMove);
  if (!block.ok()) return;
  if (centre_.active()) {
    motion::Block limited = block.value();
    motion::limit_axes(
        limited, motion::axis_course(limited, piece.request.element.start, centre_), limits_);
    queue_.push(limited, piece.joint);
  } else {
    queue_.push(block.value(), piece.joint);
  }
  ++blocks_taken_;
}

void Pipeline::flush() {
  path_.flush();
  pump();
  queue_.leave_none_out();
  if (path_.empty()) queue_.expect_no_more();
}

void Pipeline::attend(std::int32_t elapsed_us) {
  budget_.begin_cycle(queue_.looked_at());
  supply_.pass(elapsed_us, !path_.empty());
  release_held();
  pump();
  if (path_.empty() && supply_.silent_at_rest()) queue_.expect_no_more();
}

/// Releases the held elements if the plan would soon have to brake for lack of them. While the
/// sender is not silent, there is a second condition. At rest, elements must have been held for
/// long enough. In motion, fewer than kPlenty blocks must be planned.
void Pipeline::release_held() {
  // Number of planned blocks from which on held elements wait for later elements: then longer
  // welds are worth more than additional blocks.
  constexpr std::size_t kPlenty = 16;
  const bool idle = segmenter_.idle();
  const bool silent = idle ? supply_.silent_at_rest() : supply_.silent();
  if (silent) queue_.leave_none_out();
  const bool waits = idle ? !supply_.has_gathered() : queue_.size() >= kPlenty;
  if (path_.empty() || (waits && !silent) || !runs_dry()) return;
  if (silent) {
    path_.flush();
  } else {
    path_.hurry(idle);
  }
}

/// Returns whether the plan would soon have to brake because no further element is planned. This is
/// so if its remaining distance is at most the sum of three distances. They are twice the braking
/// distance, the distance of the next cycles and, if jerk is limited, the distance by which the
/// plan is ahead of the motion. The plan drives this third distance at constant speed before it
/// brakes.
bool Pipeline::runs_dry() const {
  constexpr float kCyclesAheadS = 0.05F;
  constexpr float kWindows = 1.5F;
  if (segmenter_.idle()) return true;
  const float speed = std::max(segmenter_.speed(), segmenter_.planned_speed());
  const float ahead_s = kCyclesAheadS + kWindows * segmenter_.window().seconds();
  const float acceleration = std::min(min_acceleration(limits_, queue_.front()),
                                      min_acceleration(limits_, queue_.at(queue_.size() - 1)));
  const float reach = speed * (speed / acceleration + ahead_s);
  float distance = segmenter_.left_of_block();
  for (std::size_t i = 1; i < queue_.size() && distance <= reach; ++i) {
    distance += queue_.at(i).length;
  }
  return distance <= reach;
}

/// Returns whether a block can be taken back. For a row, all its pixels must still be stored,
/// because without them the power along the row is not known.
bool Pipeline::can_take_back(const motion::Block& block) {
  return !block.row.any() || pixels_.take_back(block.row.first);
}

motion::PathUnits Pipeline::go_back(motion::PathUnits distance) {
  // Least length of the rest of a block. If the rest would be shorter, the motion continues from a
  // slightly earlier point.
  constexpr motion::PathUnits kShortestRest = motion::PathUnits{1} << 26;  // 1 µm.
  motion::PathUnits into = segmenter_.idle() ? 0 : segmenter_.into_block();
  motion::PathUnits left = distance;
  if (!queue_.empty() && !can_take_back(queue_.front())) return distance;
  while (left > into && queue_.kept() > 0 && can_take_back(queue_.newest_kept())) {
    queue_.take_back();
    left -= into;
    into = motion::length_in_units(queue_.front());
  }
  if (queue_.empty()) return distance;
  const motion::PathUnits unknown = std::max<motion::PathUnits>(0, left - into);
  const motion::PathUnits length = motion::length_in_units(queue_.front());
  const motion::PathUnits longest = std::max<motion::PathUnits>(0, length - kShortestRest);
  const motion::PathUnits place = std::min(into - (left - unknown), longest);
  segmenter_.go_back(place, distance - unknown);
  // Without shapers and backlash the motor stage takes no part in the motion, so it does not know
  // the motors' position yet.
  if (!motors_.active()) motors_.reset(segmenter_.motors(), {});
  return unknown;
}

void Pipeline::restart(const AxisArray<std::int32_t>& tool, const AxisArray<std::int32_t>& motors) {
  const Position place = place_of(tool);
  target_ = centre_.active() ? centre_.program_for(place) : place;
  path_.clear();
  pixels_.clear();
  AxisArray<StepPosition> axes{};
  AxisArray<std::int32_t> ahead{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    axes[axis] = StepPosition::whole(tool[axis]);
    ahead[axis] = motors[axis] - tool[axis];
  }
  segmenter_.reset(centre_.active() ? steps_of(target_) : axes);
  motors_.reset(axes, ahead);
}

void Pipeline::set_tool_centre(const kinematics::ToolCentre& centre) {
  centre_ = centre;
  segmenter_.follow_centre(centre_.active() ? &centre_ : nullptr);
}

bool Pipeline::configure(const motion::MotorStageSetting& setting) {
  if (setting == motor_setting_) return false;
  motor_setting_ = setting;
  motors_.configure(setting);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) motors_.rebase(axis);
  motors_.reset(segmenter_.motors(), {});
  return true;
}

void Pipeline::follow_kerf(const kerf::KerfCourse* course) {
  // Without shapers and backlash the motor stage took no part in the motions so far, so it does not
  // know the motors' position yet.
  if (!motors_.active()) motors_.reset(segmenter_.motors(), {});
  segmenter_.follow_kerf(course);
}

AxisArray<StepPosition> Pipeline::steps_of(const Position& place) const {
  AxisArray<StepPosition> steps{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto at = limits_.scale[axis].steps_at(place[axis]);
    CNC_ASSERT(at.has_value());
    steps[axis] = *at;
  }
  return steps;
}

Position Pipeline::place_of(const AxisArray<std::int32_t>& steps) const {
  Position place;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    place[axis] = limits_.scale[axis].place_of(steps[axis]);
  }
  return place;
}

}  // namespace cnc
