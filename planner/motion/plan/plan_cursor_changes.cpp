// The part of PlanCursor that begins a plan, and that changes it when blocks are added, overrides
// are set or the feed is held.

#include <algorithm>
#include <array>

#include "planner/motion/plan/plan_cursor.hpp"

namespace cnc::motion {
namespace {

/// Least time between two attempts to apply an override, in ns. An attempt plans all blocks, and
/// plans them again if the override is refused.
constexpr std::uint64_t kBetweenTriesNs = 20'000'000;

}  // namespace

/// Returns the end of the chain: the index of the next block that begins from rest, or the size of
/// the queue. The chain is the blocks from the present block to the next stop.
std::size_t PlanCursor::chain_end() const {
  std::size_t end = index_ + 1;
  while (end < queue_.size() && !queue_.at(end).from_rest) ++end;
  return end;
}

/// Returns the time in ns that the motion takes under a time window from the present block to the
/// block at index `end`. `window` stays set. @pre at rest, and no block has begun
std::uint64_t PlanCursor::time_to(std::size_t end, const TimeWindow& window) {
  constexpr std::uint32_t kAnyNs = 1'000'000'000;
  const std::size_t first = index_;
  const PathUnits lead = lead_;
  set_window(window);
  queue_.plan_chain(limits_, terms_, index_, end);
  std::uint64_t took_ns = window.whole_ns();
  while (index_ < end) {
    const Stretch stretch = follow(kAnyNs, Drive::kOn, true);
    if (!stretch.lasts()) break;
    took_ns += stretch.duration_ns;
  }
  reset();
  index_ = first;
  lead_ = lead;
  return took_ns;
}

/// Returns the time window with which the blocks before index `end` are driven in the shortest
/// time. Tries the window that suits a single move first, and then shorter windows until the motion
/// takes longer again.
TimeWindow PlanCursor::quickest(const WindowChoice& choice, std::size_t end) {
  constexpr std::array<float, 7> kShares{0.84F, 0.7F, 0.59F, 0.5F, 0.42F, 0.35F, 0.25F};
  /// These numbers of blocks limit the time for choosing a window to some milliseconds on the
  /// controller. Up to kFewBlocks blocks are planned under all windows. Up to kMaxBlocks blocks are
  /// planned under every third window.
  constexpr std::size_t kFewBlocks = 16;
  constexpr std::size_t kMaxBlocks = 64;
  constexpr std::size_t kWideStep = 3;
  TimeWindow chosen = choice.window();
  const std::size_t blocks = end - index_;
  const bool one_line = blocks == 1 && !queue_.at(index_).turns();
  if (driving_ || one_line || blocks > kMaxBlocks) return chosen;
  std::uint64_t min_ns = time_to(end, chosen);
  const std::size_t step = blocks > kFewBlocks ? kWideStep : 1;
  for (std::size_t i = step - 1; i < kShares.size(); i += step) {
    const TimeWindow tried = choice.window(kShares[i]);
    const std::uint64_t took_ns = time_to(end, tried);
    if (took_ns > min_ns + min_ns / 64) break;
    if (took_ns >= min_ns) continue;
    min_ns = took_ns;
    chosen = tried;
  }
  set_window(chosen);
  return chosen;
}

TimeWindow PlanCursor::choose_window() {
  queue_.stand();
  const std::size_t end = chain_end();
  std::uint8_t axes = 0;
  for (std::size_t index = index_; index < end; ++index) {
    axes = static_cast<std::uint8_t>(axes | moving_axes(queue_.at(index)));
  }
  const TimeWindow longest = window_for(limits_, axes);
  const bool stop_known = end < queue_.size() || queue_.ends();
  if (!longest.filters() || !stop_known) return longest;
  // An override below 100 % may still be raised, so the window is chosen for at least 100 %.
  const Overrides greatest = greater_pace(overrides_, {});
  WindowChoice choice{limits_};
  for (std::size_t index = index_; index < end; ++index) {
    const Block& block = queue_.at(index);
    const bool begun = driving_ && index == index_;
    choice.add(block,
               begun ? to_mm(length_ - place_) : block.length,
               SpeedCap{block, greatest}.square_within(block.speed_limit_square));
  }
  const TimeWindow window = quickest(choice, end);
  if (end == queue_.size() && window != longest) queue_.stop_at_end();
  return window;
}

void PlanCursor::reset() {
  since_speeding_up_ns_ = kLongAgo;
  since_braking_ns_ = kLongAgo;
  overtaken_ = false;
  braking_from_ = 0.0F;
  clock_ = {};
  lead_ = 0;
  postponed_ns_ = 0;
  index_ = 0;
  driving_ = false;
  phase_ = {};
  speed_ = 0.0F;
  entry_square_ = 0.0F;
}

void PlanCursor::set_overrides(const Overrides& overrides) {
  overrides_ = overrides;
  if (!terms_.window.filters() && !same_pace(overrides, terms_.overrides)) take_up_overrides();
}

/// Replaces the conditions of the plan (overrides and time window), and marks all blocks as
/// unplanned.
void PlanCursor::plan_for(const PlanTerms& terms) {
  terms_ = terms;
  queue_.forget_plan();
  replan_ = true;
}

/// Applies the requested overrides to the plan. @pre at rest, or without a time window, so that no
/// limits of a block reach into other blocks
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

/// Corrects the profile's distance to the end of the block after a phase. The profile adds up
/// distances in single precision, so each phase adds a rounding error. If the errors of many phases
/// were corrected in one later phase, the speed would jump there.
void PlanCursor::settle_place() {
  if (terms_.window.filters()) profile_.settle(to_mm(length_ - place_));
}

/// Returns whether the plan is at the end of a block and continues without rest into the next one.
/// The caller then begins the next block before it changes the plan, so that the change is checked
/// at the present position and speed.
bool PlanCursor::goes_on() const {
  return !driving_ && index_ < queue_.size() && !queue_.at(index_).from_rest;
}

/// Adapts the profile if added blocks, an override or a hold may have changed the plan ahead.
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

/// Plans all blocks that are not planned yet, and adapts the profile. Called before a change of the
/// overrides, it ensures that blocks that arrived late are accepted or refused under the old
/// overrides.
void PlanCursor::bring_up_to_date(Drive drive) {
  queue_.plan_all(limits_, terms_, index_);
  if (driving_) follow_plan(drive);
}

/// Applies lower overrides immediately: if the motion is too fast for them, it slows down. There is
/// one exception. Where too many limit zones of later blocks reach into a block, some of these
/// zones are merged. The overrides determine which zones are merged. A merged zone may reach
/// farther than the zones under the old overrides. If the speed is too high for turning within this
/// zone, no acceleration is left for braking. Then the lower overrides are postponed.
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

/// Applies higher overrides as soon as the motion can change to the faster plan at its position.
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

/// Refuses blocks that arrived so late that the plan is already too fast for the limits that they
/// impose on earlier blocks. The plan can always stop before the late blocks, because the present
/// speed was planned without them.
void PlanCursor::refuse_late_blocks() {
  if (!queue_.has_newest_behind(index_)) return;
  queue_.stop_before_newest();
  queue_.plan(limits_, terms_, index_);
  replan();
}

}  // namespace cnc::motion
