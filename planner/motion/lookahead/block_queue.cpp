#include "planner/motion/lookahead/block_queue.hpp"

#include <algorithm>
#include <cmath>

#include "planner/motion/block/block_builder.hpp"
#include "planner/motion/lookahead/braking.hpp"

namespace cnc::motion {

void BlockQueue::push(const Block& block, Joint joint) {
  const bool from_rest = stops_before(block, joint);
  Block& added = add(block);
  added.from_rest = from_rest;
  added.entry = {};
  ends_ = false;
  stops_at_end_ = false;
  last_exit_tangent_ = exit_tangent(block);
  ++unplanned_;
}

bool BlockQueue::stops_before(const Block& block, Joint joint) const {
  if (empty() || stops_at_end_ || joint == Joint::kStop) return true;
  return joint == Joint::kAsItTurns && !is_tangent(last_exit_tangent_, entry_tangent(block));
}

void BlockQueue::pop_front() {
  left_square_ = front().reachable_square;
  pass_front();
  unplanned_ = std::min(unplanned_, size());
}

void BlockQueue::take_back() {
  return_newest_kept();
  forget_plan();
}

void BlockQueue::begin_at(const AxisArray<StepPosition>& place, const Block& front) {
  Block& begun = BlockRing::at(0);
  begun = front;
  begun.from_rest = true;
  forget_kept(place);
  forget_plan();
}

void BlockQueue::stand() {
  if (front_trail_.empty()) return;
  front_trail_.clear();
  forget_plan();
}

void BlockQueue::clear(const AxisArray<StepPosition>& place) {
  forget_all(place);
  front_trail_.clear();
  unplanned_ = 0;
  leaves_none_out_ = false;
  ends_ = false;
  stops_at_end_ = false;
}

namespace {

/// Returns the greatest v² anywhere on a block, under the overrides `terms.greatest`.
float max_square(const Spans& spans, const Block& block, const PlanTerms& terms) {
  const SpeedCap greatest{block, terms.greatest};
  float most = 0.0F;
  for (int span = 0; span < spans.count(); ++span) {
    most = std::max(most, greatest.square_within(spans.speed_limit_square(span)));
  }
  return most;
}

/// Returns the limit zone that a block imposes on the blocks before and after it. The zone's speed
/// is the lowest speed limit on the block. The length of the zone follows from the greatest speed
/// on the block.
LimitZone zone_of(const Spans& spans, const Block& block, const PlanTerms& terms) {
  const SpeedCap cap{block, terms.overrides};
  float least = LimitZone{}.speed_square;
  for (int span = 0; span < spans.count(); ++span) {
    least = std::min(least, cap.square_within(spans.speed_limit_square(span)));
  }
  LimitZone zone = spans.zone(max_square(spans, block, terms), block.reachable_square);
  zone.speed_square = least;
  return zone;
}

/// Returns the greatest v² with which a block can be left.
/// @param before_square greatest v² with which the block before it can be left
float reachable_after(Block& block,
                      float before_square,
                      const Limits& limits,
                      const PlanTerms& terms) {
  constexpr float kRounding = 1.0F + 1.0e-4F;
  constexpr float kAny = 1.0e12F;
  block.reachable_square = kAny;
  const Spans spans{block, limits, terms.window};
  const float most =
      before_square + 2.0F * kRounding * spans.greatest_acceleration() * block.length;
  return std::min(most, max_square(spans, block, terms));
}

/// Sets `block.tail` to the limit zones that later blocks impose on `block`, and adds the zone of
/// `block` to `ahead`. Returns whether the tail is unchanged and no zone of later blocks reaches
/// beyond `block`.
bool lay_tail(ZoneTrail& ahead, Block& block, const Limits& limits, const PlanTerms& terms) {
  const Spans spans{block, limits, terms.window};
  const LimitZone own = zone_of(spans, block, terms);
  const BlockZones tail = ahead.reaching(own);
  ahead.advance(block.length, terms.window.reach(block.reachable_square));
  const bool same = tail == block.tail && ahead.empty();
  ahead.add(own);
  block.tail = tail;
  return same;
}

}  // namespace

void BlockQueue::leave_front(const Limits& limits, const PlanTerms& terms) {
  if (!terms.window.filters()) return;
  const Block& block = front();
  if (block.from_rest) front_trail_.clear();
  front_trail_.advance(block.length, terms.window.reach(block.reachable_square));
  front_trail_.add(zone_of(Spans{block, limits, terms.window}, block, terms));
}

void BlockQueue::stop_before_newest() {
  BlockRing::at(size() - newest_).from_rest = true;
  forget_plan();
}

/// Sets `head` and `reachable_square` of the blocks before index `end` that are not planned yet.
void BlockQueue::lay_heads(const Limits& limits, const PlanTerms& terms, std::size_t end) {
  if (!terms.window.filters()) return;
  if (unplanned_ == size()) {
    // front_trail_ itself stays unchanged. So if new overrides are refused, planning with the old
    // overrides gives the old plan again.
    trail_ = front_trail_;
    reachable_square_ = left_square_;
  }
  for (std::size_t index = size() - unplanned_; index < end; ++index) {
    Block& block = BlockRing::at(index);
    if (block.from_rest) {
      trail_.clear();  // The window never spans a stop.
      reachable_square_ = 0.0F;
    }
    block.head = {};
    block.tail = {};
    reachable_square_ = reachable_after(block, reachable_square_, limits, terms);
    block.reachable_square = reachable_square_;
    const LimitZone own = zone_of(Spans{block, limits, terms.window}, block, terms);
    block.head = trail_.reaching(own);
    trail_.advance(block.length, terms.window.reach(block.reachable_square));
    trail_.add(own);
  }
}

namespace {

/// Returns the state at the start of a block from which `exit` can be reached at its end. The joint
/// before the block is not considered.
BrakingState entry_for(const Block& block,
                       const Limits& limits,
                       const PlanTerms& terms,
                       const BrakingState& exit,
                       std::uint32_t& looked_at) {
  const SpeedCap cap{block, terms.overrides};
  if (!block.turns() && !terms.window.filters()) {
    ++looked_at;
    return {.speed_square = brake_over_line(block, cap, exit.speed_square)};
  }
  const Spans spans{block, limits, terms.window};
  // Cost of planning a span of an arc or under a time window, relative to planning a line without a
  // window.
  constexpr std::uint32_t kCostOfSpan = 2;
  looked_at += kCostOfSpan * static_cast<std::uint32_t>(spans.count());
  return brake_backwards(spans, cap, exit);
}

}  // namespace

void BlockQueue::plan(const Limits& limits, const PlanTerms& terms, std::size_t lead) {
  const bool enough = unplanned_ * kReplanShare >= size() || leaves_none_out_;
  if (enough) plan_all(limits, terms, lead);
}

namespace {

/// Returns whether a block may keep its old entry state: `before` equals the new entry state `now`
/// or, without a time window, has only a slightly lower v² than `now`. The tolerance ends the
/// backward pass on arcs that are driven at their limit, where the effect of later blocks decreases
/// but never becomes zero.
bool as_good(const BrakingState& before, const BrakingState& now, const TimeWindow& window) {
  constexpr float kNegligible = 1.0F + 5.0e-5F;
  if (before == now) return true;
  return !window.filters() && before.speed_square <= now.speed_square &&
         now.speed_square <= before.speed_square * kNegligible;
}

}  // namespace

void BlockQueue::plan_all(const Limits& limits, const PlanTerms& terms, std::size_t lead) {
  leaves_none_out_ = false;
  if (unplanned_ == 0) return;
  ++plans_;
  lay_heads(limits, terms, size());
  newest_ = unplanned_;
  plan_backwards(limits, terms, lead, size());
  unplanned_ = 0;
}

void BlockQueue::plan_chain(const Limits& limits,
                            const PlanTerms& terms,
                            std::size_t lead,
                            std::size_t end) {
  CNC_ASSERT(unplanned_ == size() && end <= size());
  ++plans_;
  lay_heads(limits, terms, end);
  if (end < size()) BlockRing::at(end).entry = {};
  plan_backwards(limits, terms, lead, end);
}

// Plans backwards from the block before index `end`. Stops at a block that was planned before if
// its new entry equals the old one: then the entries of all older blocks would stay equal, too. But
// continues if the limit zones that reach into that block, or beyond it, have changed.
void BlockQueue::plan_backwards(const Limits& limits,
                                const PlanTerms& terms,
                                std::size_t lead,
                                std::size_t end) {
  const TimeWindow& window = terms.window;
  BrakingState exit{};
  ZoneTrail ahead;
  for (std::size_t index = end; index-- > lead;) {
    Block& block = BlockRing::at(index);
    const bool was_planned = index < size() - unplanned_;
    const bool same_tail = !window.filters() || lay_tail(ahead, block, limits, terms);
    if (index == lead) break;
    const BrakingState entry =
        block.from_rest ? BrakingState{} : entry_for(block, limits, terms, exit, looked_at_);
    if (was_planned && same_tail && as_good(block.entry, entry, window)) break;
    block.entry = entry;
    exit = entry;
    if (block.from_rest) ahead.clear();
  }
}

}  // namespace cnc::motion
