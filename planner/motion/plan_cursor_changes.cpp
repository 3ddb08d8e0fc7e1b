// What happens to a plan that is being driven: more blocks, other overrides, holds.

#include <algorithm>

#include "planner/motion/plan_cursor.hpp"

namespace cnc::motion {
namespace {

/// Trying a pace is to plan all blocks, and twice if it is refused.
constexpr std::uint64_t kBetweenTriesNs = 20'000'000;

}  // namespace

void PlanCursor::set_overrides(const Overrides& overrides) {
  overrides_ = overrides;
  if (!terms_.window.filters() && !same_pace(overrides, terms_.overrides)) take_up_overrides();
}

/// All that was planned is to be planned anew.
void PlanCursor::plan_for(const PlanTerms& terms) {
  terms_ = terms;
  queue_.forget_plan();
  replan_ = true;
}

/// @pre at rest, or nothing reaches from one block into another
void PlanCursor::take_up_overrides() {
  plan_for({.overrides = overrides_, .greatest = overrides_, .window = terms_.window});
}

void PlanCursor::set_window(const TimeWindow& window) {
  terms_.window = window;
  take_up_overrides();
}

void PlanCursor::stop_phase_short() {
  if (phase_.duration > 0.0F) {
    profile_.stop_short(phase_, phase_distance_left(), speed_);
    clock_.cut(elapsed_ns_);
  }
  phase_ = {};
  settle_place();
}

/// The profile counts in floats, of which each phase rounds one. Set right in one
/// phase much later, the sum would be a jump of speed.
void PlanCursor::settle_place() {
  if (terms_.window.filters()) profile_.settle(to_mm(length_ - place_));
}

/// Into the next block, which was planned before: whatever changes the plan now finds the
/// block begun, and is judged by where the motion is.
bool PlanCursor::goes_on() const {
  return !driving_ && index_ < queue_.size() && !queue_.at(index_).from_rest;
}

/// More blocks, an override or a hold may have changed what lies ahead.
/// @pre driving_
void PlanCursor::follow_plan(Drive drive) {
  if (queue_.plans() == followed_ && !replan_ && drive == phase_drive_) return;
  followed_ = queue_.plans();
  const bool same_zones = !terms_.window.filters() || queue_.at(index_).tail == profile_.tail();
  const bool same_plan = !replan_ && same_zones && queue_.exit_of(index_) == profile_.exit();
  if (same_plan && drive == phase_drive_) return;
  stop_phase_short();
  if (profile_.at_end() || same_plan) return;
  const BlockZones zones = profile_.tail();
  replan();
  if (terms_.window.filters()) {
    const bool too_fast = profile_.too_fast(patience());
    if (replan_) {
      overtaken_ = too_fast;
    } else if (too_fast || profile_.within_other_zones(zones)) {
      refuse_late_blocks();
    }
  }
  replan_ = false;
}

/// Blocks that are not planned yet are judged by the plan as it was.
void PlanCursor::bring_up_to_date(Drive drive) {
  queue_.plan_all(limits_, terms_, index_);
  if (driving_) follow_plan(drive);
}

/// At once: who is too fast for it slows down. But where zones that are taken together have
/// changed, one that the speed is too high to turn in may reach farther than it did. No way to
/// brake is left in it, so there the plan for the lower pace has to wait.
void PlanCursor::lower_pace(std::uint64_t passed_ns, Drive drive) {
  postponed_ns_ -= std::min(postponed_ns_, passed_ns);
  PlanTerms lower = terms_;
  lower.overrides = lesser_pace(overrides_, terms_.overrides);
  if (postponed_ns_ > 0 || same_pace(lower.overrides, terms_.overrides)) return;
  bring_up_to_date(drive);
  const PlanTerms before = terms_;
  const BlockZones zones = profile_.tail();
  plan_for(lower);
  bring_up_to_date(drive);
  if (!driving_ || profile_.at_end() || !overtaken_ || !profile_.too_fast_to_turn(zones)) return;
  plan_and_replan(before);
  overtaken_ = profile_.too_fast(patience());
  postponed_ns_ = kBetweenTriesNs;
}

/// As soon as the plan for it is one that can be gone over to here.
void PlanCursor::try_higher_pace(std::uint64_t passed_ns, Drive drive) {
  untried_ns_ += passed_ns;
  if (untried_ns_ < kBetweenTriesNs || same_pace(terms_.overrides, overrides_)) return;
  untried_ns_ = 0;
  bring_up_to_date(drive);
  stop_phase_short();
  if (profile_.at_end()) return;
  const PlanTerms before = terms_;
  const BlockZones zones = profile_.tail();
  plan_and_replan({.overrides = overrides_,
                   .greatest = greater_pace(overrides_, terms_.greatest),
                   .window = terms_.window});
  const bool can_go_over = !profile_.too_fast(patience()) && !profile_.within_other_zones(zones);
  if (!can_go_over) plan_and_replan(before);
}

void PlanCursor::plan_and_replan(const PlanTerms& terms) {
  plan_for(terms);
  queue_.plan_all(limits_, terms_, index_);
  replan();
  replan_ = false;
}

void PlanCursor::replan() {
  profile_.replan(queue_.at(index_), limits_, terms_, queue_.exit_of(index_));
}

/// Blocks came so late that the plan is too fast already for what they ask for
/// ahead of their start. Nothing is, for a stop there, as was planned without them.
void PlanCursor::refuse_late_blocks() {
  if (!queue_.has_newest_behind(index_)) return;
  queue_.stop_before_newest();
  queue_.plan(limits_, terms_, index_);
  replan();
}

}  // namespace cnc::motion
