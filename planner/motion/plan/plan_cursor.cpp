#include "planner/motion/plan/plan_cursor.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::motion {
namespace {

/// Returns the acceleration of a phase whose duration was rounded up to `duration_ns`. It is
/// reduced in the ratio in which the duration grows, so that the speeds at both ends stay
/// unchanged.
float acceleration_of(const Phase& phase, std::uint64_t duration_ns) {
  const float duration = nearest_float(duration_ns) * kSecondsPerNanosecond;
  return phase.acceleration * std::min(1.0F, phase.duration / duration);
}

PhaseCourse::Grain grain_of(const TimeWindow& window) {
  return window.filters() ? PhaseCourse::Grain::kFine : PhaseCourse::Grain::kUsual;
}

}  // namespace

void PlanCursor::block_left() {
  CNC_ASSERT(index_ > 0);
  queue_.leave_front(limits_, terms_);
  --index_;
}

Stretch PlanCursor::next(std::uint32_t max_ns, Drive drive, bool may_start) {
  const bool at_rest = speed_ <= 0.0F && may_start;
  if (at_rest && !same_pace(terms_.greatest, overrides_)) take_up_overrides();
  if (terms_.window.filters() && speed_ > 0.0F && goes_on()) begin_block();
  queue_.plan(limits_, terms_, index_);
  if (driving_) follow_plan(drive);
  if (!same_pace(terms_.overrides, overrides_)) {
    lower_pace(max_ns, drive);
    if (driving_) try_higher_pace(max_ns, drive);
  }
  return follow(max_ns, drive, may_start);
}

/// Returns the next stretch of the present plan.
Stretch PlanCursor::follow(std::uint32_t max_ns, Drive drive, bool may_start) {
  if (!driving_) stand_at_stop();
  if (speed_ <= 0.0F) {
    if (!may_start) return {};
    since_speeding_up_ns_ = kLongAgo;
    since_braking_ns_ = kLongAgo;
    clock_.rest();
  }
  if (driving_ && profile_.at_end()) return finish_block();
  if (phase_.duration <= 0.0F && !begin_phase(drive)) return {};
  const Stretch stretch = pass(max_ns);
  if (terms_.window.filters()) note_change(stretch);
  if (elapsed_ns_ == course_.duration_ns()) end_phase();
  return stretch;
}

/// Moves the plan along the present phase for at most `max_ns`, and returns the stretch.
Stretch PlanCursor::pass(std::uint32_t max_ns) {
  const std::uint64_t left_ns = course_.duration_ns() - elapsed_ns_;
  const std::uint64_t duration_ns = std::min<std::uint64_t>(max_ns, left_ns);
  const float start_speed = speed_;
  const PathUnits from = place_;
  elapsed_ns_ += duration_ns;
  speed_ = course_.speed_after(elapsed_ns_);
  place_ = phase_from_ + course_.way_after(elapsed_ns_);
  // Only the end of a phase may reach the end of the block.
  if (duration_ns < left_ns) place_ = std::min(place_, length_ - 1);
  return {.way = terms_.window.filters() ? way_in_time(place_ - from) : place_ - from,
          .duration_ns = duration_ns,
          .start_speed = start_speed,
          .end_speed = speed_,
          .acceleration = course_.whole().acceleration};
}

void PlanCursor::end_phase() {
  profile_.complete(phase_);
  phase_ = {};
  settle_place();
  if (profile_.at_end()) end_block();
}

/// Returns the distance of a stretch as if the durations of phases were not rounded up to whole
/// nanoseconds. Updates lead_, the distance that the motion drives in the delay that this rounding
/// causes, and adds the change of lead_ to the distance. The lead may reach into the next phase,
/// because a cell of the window may end exactly where a phase ends. The lead never reaches beyond a
/// stop.
/// @param way distance of the stretch with the rounded durations
PathUnits PlanCursor::way_in_time(PathUnits way) {
  const float late_mm = speed_ * clock_.late_ns(elapsed_ns_) * kSecondsPerNanosecond;
  const bool stops = index_ + 1 == queue_.size() || queue_.at(index_ + 1).from_rest;
  PathUnits lead = to_units(late_mm);
  if (stops) lead = std::min(lead, length_ - place_);
  const PathUnits before = lead_;
  lead = std::max(lead, before - way);
  lead_ = lead;
  return way + lead - before;
}

Patience PlanCursor::patience() const {
  const auto wait = [this](std::uint32_t since_ns) {
    const std::uint32_t window_ns = terms_.window.whole_ns();
    return since_ns < window_ns ? static_cast<float>(window_ns - since_ns) * kSecondsPerNanosecond
                                : 0.0F;
  };
  return {.before_speeding_up = wait(since_braking_ns_),
          .before_braking = wait(since_speeding_up_ns_),
          .braking_from = braking_from_,
          .overtaken = overtaken_};
}

void PlanCursor::note_change(const Stretch& stretch) {
  const auto pass = [&stretch](std::uint32_t& since_ns, bool changes) {
    const std::uint64_t passed = since_ns + stretch.duration_ns;
    since_ns = changes ? 0 : static_cast<std::uint32_t>(std::min<std::uint64_t>(kLongAgo, passed));
  };
  if (stretch.acceleration >= 0.0F) braking_from_ = stretch.end_speed;
  pass(since_speeding_up_ns_, stretch.acceleration > 0.0F);
  pass(since_braking_ns_, stretch.acceleration < 0.0F);
}

/// Ends a block whose last phase was ended early at the end of the block. Returns a stretch of 1 ns
/// for the distance that rounding may have left to the end of the block.
Stretch PlanCursor::finish_block() {
  end_block();
  return {.way = length_ - place_, .duration_ns = 1, .start_speed = speed_, .end_speed = speed_};
}

/// Begins the next phase. Returns false if the plan is at rest and stays at rest.
bool PlanCursor::begin_phase(Drive drive) {
  if (!driving_) {
    if (index_ == queue_.size()) return false;
    begin_block();
  }
  // Until the braking after a lower override has ended, the motion may be faster than the plan and
  // faster than the override allows.
  overtaken_ = overtaken_ && (since_braking_ns_ == 0 || profile_.too_fast(patience()));
  phase_ = profile_.next_phase(drive, patience());
  phase_drive_ = drive;
  if (phase_.duration <= 0.0F) {
    speed_ = 0.0F;
    return false;
  }
  phase_from_ = place_;
  const std::uint64_t duration_ns = clock_.begin(phase_.duration, terms_.window.filters());
  course_.begin({.way = place_after(phase_) - place_,
                 .duration_ns = duration_ns,
                 .start_speed = phase_.start_speed,
                 .end_speed = std::sqrt(phase_.end_speed_square),
                 .acceleration = acceleration_of(phase_, duration_ns)},
                grain_of(terms_.window));
  elapsed_ns_ = 0;
  return true;
}

/// Returns the position on the block where the phase ends. It is computed from the nearer end of
/// the block, so that the rounding error of a long block never falls on a short phase at one of its
/// ends. But if settle_place() will correct rounding errors after the phase, the position is
/// computed from the distance of the phase.
PathUnits PlanCursor::place_after(const Phase& phase) const {
  const float left = profile_.left_of_block(phase);
  if (left <= 0.0F) return length_;
  const bool nearer_start = 2.0F * left > queue_.at(index_).length;
  const bool settled = terms_.window.filters() && SpeedProfile::settles(left);
  const PathUnits place =
      nearer_start || settled ? place_ + to_units(phase.distance) : length_ - to_units(left);
  return std::clamp(place, place_, length_ - 1);
}

float PlanCursor::phase_distance_left() const {
  const auto whole = nearest_float(course_.whole().way);
  if (elapsed_ns_ == 0 || whole <= 0.0F) return phase_.distance;
  const auto left = nearest_float(phase_from_ + course_.whole().way - place_);
  return phase_.distance * (left / whole);
}

/// Sets the speed to zero where the next block begins from rest. Under a time window, a hold or an
/// override may leave a low speed there. The position still counts as a stop: the window
/// distributes this speed over time, and the motion is at rest before the path changes its
/// direction.
void PlanCursor::stand_at_stop() {
  if (index_ == queue_.size() || !queue_.at(index_).from_rest) return;
  speed_ = 0.0F;
  entry_square_ = 0.0F;
}

void PlanCursor::begin_block() {
  const Block& block = queue_.at(index_);
  profile_.begin(block, limits_, terms_, queue_.exit_of(index_), entry_square_);
  length_ = length_in_units(block);
  place_ = 0;
  driving_ = true;
  replan_ = false;
  followed_ = queue_.plans();
}

void PlanCursor::end_block() {
  entry_square_ = profile_.speed_square();
  ++index_;
  driving_ = false;
}

}  // namespace cnc::motion
