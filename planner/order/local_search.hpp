#pragma once

#include "planner/order/exchange.hpp"
#include "planner/order/feasibility.hpp"
#include "planner/order/neighbours.hpp"
#include "planner/order/work_queue.hpp"

namespace cnc::order {

/// Improves a tour around one set at a time, by one of three changes. The first is an exchange of
/// two or three legs that begins with a leg of the set. Exchanges are chosen as by Lin and
/// Kernighan: each new leg joins neighbours, and the sum of the gains stays positive. The second
/// change is another candidate of the set. The third is another position of the set, with the
/// candidate that is best there.
template <LegCost Cost>
class LocalSearch {
 public:
  /// @param min_gain least gain that is accepted. Smaller gains are rounding, and a search that
  ///     accepts them may not end
  LocalSearch(const Problem& problem,
              const Cost& cost,
              const Neighbours& neighbours,
              Tour& tour,
              WorkQueue& queue,
              double min_gain)
      : problem_{&problem},
        neighbours_{neighbours},
        tour_{&tour},
        queue_{&queue},
        legs_{problem, cost, tour},
        may_{problem.precedence, tour},
        min_gain_{min_gain},
        is_free_{problem.is_free()},
        has_lines_{!problem.reversed.empty()},
        is_plain_{problem.candidates() == problem.sets()},
        ends_early_{is_plain_ && problem.is_symmetric} {}

  [[nodiscard]] const Legs<Cost>& legs() const { return legs_; }

  /// Makes the first improvements that it finds around a set.
  /// @return the decrease of the tour's cost; 0 if no improvement was found
  double improve(Index set) {
    double gain = 0.0;
    if (!is_plain_) gain += improve_choice(set);
    for (const bool at_entry : {false, true}) {
      const double more = improve_legs({set, at_entry});
      if (more > 0.0) return gain + more;
    }
    if (!is_plain_) gain += improve_position(set);
    return gain;
  }

  /// Makes an exchange. @pre may_make(exchange)
  void make(const Exchange& exchange) {
    const Index count = exchange.has_three ? 3 : 2;
    for (Index i = 0; i < count; ++i) {
      queue_->add(tour_->at(exchange.cuts[i]));
      queue_->add(tour_->at(tour_->position_after(exchange.cuts[i])));
    }
    make_exchange(*tour_, exchange, is_free_);
  }

  [[nodiscard]] bool may_make(const Exchange& exchange) const {
    if (is_free_) return true;
    const auto [p, q, r] = exchange.cuts;
    if (!exchange.has_three) return q - p <= kMaxChecked && may_.may_reverse(p + 1, q + 1);
    if (std::min(q - p, r - q) > kMaxChecked || r - p > kMaxMoved) return false;
    return may_.may_rearrange(exchange.how, p + 1, q + 1, r + 1);
  }

 private:
  /// Number of neighbours that are tried for a third leg, or as positions to insert a set.
  static constexpr Index kThirdWidth = 5;
  // Greatest numbers of sets that are checked and moved in a tour that is not free (see Problem).
  // Longer stretches take more time than their gain is worth.
  static constexpr Index kMaxChecked = 1000;
  static constexpr Index kMaxMoved = 30'000;

  double improve_choice(Index set);
  double improve_legs(const LooseEnd& start);
  double improve_position(Index set);

  /// Returns the cost of the leg that joins an end to the neighbour `set`, at an end of the
  /// opposite kind.
  /// @param number index of `set` in the list of neighbours of the end's set
  [[nodiscard]] double cost_to(const LooseEnd& end, Index number, Index set) const {
    if (neighbours_.have_costs()) return neighbours_.cost(end.set, number);
    return legs_.join(end, {set, !end.is_entry});
  }
  [[nodiscard]] CutLeg cut_at(const LooseEnd& end) const {
    return {end, legs_.across(end), legs_.leg_of(end)};
  }
  /// Returns whether two ends may be joined. No part of an asymmetric tour is ever reversed.
  [[nodiscard]] bool may_join(const LooseEnd& a, const LooseEnd& b) const {
    return a.set != b.set && (problem_->is_symmetric || a.is_entry != b.is_entry);
  }
  bool try_second(const CutLeg& one, Index number, double removed, Exchange& best) const;
  void close_two(const CutLeg& one, const CutLeg& two, double gained, Exchange& best) const;
  void try_third(const CutLeg& one, const CutLeg& two, double gained, Exchange& best) const;
  void close_three(
      const CutLeg& one, const CutLeg& two, const CutLeg& three, double gain, Exchange& best) const;

  struct Insertion {
    Index after = kNone;  ///< Position after which the set is inserted.
    Index candidate = 0;
    double gain = 0.0;
  };
  void try_insertion(Index set, Index after, double freed, Insertion& best) const;
  void make_insertion(Index set, const Insertion& insertion);
  [[nodiscard]] Exchange exchange_of(Index position, Index after) const;

  const Problem* problem_;
  Neighbours neighbours_;
  Tour* tour_;
  WorkQueue* queue_;
  Legs<Cost> legs_;
  Feasibility may_;
  double min_gain_;
  bool is_free_;
  /// Whether a set exists whose reversal has another entry, as an open line has.
  bool has_lines_;
  bool is_plain_;  ///< Whether each set has only one candidate.
  /// Whether a later neighbour in a list always costs more, so that a search may end early.
  bool ends_early_;
};

template <LegCost Cost>
double LocalSearch<Cost>::improve_choice(Index set) {
  const Index before = tour_->chosen(tour_->before(set));
  const Index after = tour_->chosen(tour_->after(set));
  const auto cost_of = [&](Index candidate) {
    return legs_.between(before, candidate) + legs_.between(candidate, after);
  };
  const double present = cost_of(tour_->chosen(set));
  Index best = tour_->chosen(set);
  double least = present - min_gain_;
  for (Index c = problem_->first_candidate[set]; c < problem_->first_candidate[set + 1]; ++c) {
    const double cost = cost_of(c);
    if (cost < least) {
      least = cost;
      best = c;
    }
  }
  if (best == tour_->chosen(set)) return 0.0;
  tour_->choose(set, best);
  queue_->add(set);
  queue_->add(tour_->before(set));
  queue_->add(tour_->after(set));
  return present - least;
}

template <LegCost Cost>
double LocalSearch<Cost>::improve_legs(const LooseEnd& start) {
  const CutLeg one = cut_at(start);
  const double removed = legs_.after(one.position);
  Exchange best;
  best.gain = min_gain_;
  const auto near = neighbours_.of(one.other.set);
  for (Index i = 0; i < near.size(); ++i) {
    if (near[i] == kNone || !try_second(one, i, removed, best) || best.gain > min_gain_) break;
  }
  if (best.gain <= min_gain_) return 0.0;
  make(best);
  return best.gain;
}

/// Tries new legs from the other end of the leg `one` to the neighbour with index `number`.
/// @return false if no neighbour farther away can give a gain
template <LegCost Cost>
bool LocalSearch<Cost>::try_second(const CutLeg& one,
                                   Index number,
                                   double removed,
                                   Exchange& best) const {
  const Index set = neighbours_.of(one.other.set)[number];
  if (set == one.one.set) return true;
  double gained = removed - cost_to(one.other, number, set);
  if (ends_early_ && gained <= min_gain_) return false;
  for (const bool is_entry : {!one.other.is_entry, one.other.is_entry}) {
    const LooseEnd end{set, is_entry};
    if (!may_join(one.other, end)) continue;
    if (has_lines_ && is_entry == one.other.is_entry) gained = removed - legs_.join(one.other, end);
    if (gained <= min_gain_) continue;
    const CutLeg two = cut_at(end);
    if (two.position == one.position) continue;
    const double both = gained + legs_.after(two.position);
    if (is_entry == one.other.is_entry) close_two(one, two, both, best);
    try_third(one, two, both, best);
  }
  return true;
}

template <LegCost Cost>
void LocalSearch<Cost>::close_two(const CutLeg& one,
                                  const CutLeg& two,
                                  double gained,
                                  Exchange& best) const {
  const double gain = gained - legs_.join(two.other, one.one);
  if (gain <= best.gain) return;
  Exchange exchange;
  exchange.cuts = {std::min(one.position, two.position), std::max(one.position, two.position), 0};
  exchange.gain = gain;
  if (may_make(exchange)) best = exchange;
}

template <LegCost Cost>
void LocalSearch<Cost>::try_third(const CutLeg& one,
                                  const CutLeg& two,
                                  double gained,
                                  Exchange& best) const {
  const auto near = neighbours_.of(two.other.set);
  for (Index i = 0; i < std::min(kThirdWidth, neighbours_.width()); ++i) {
    const Index set = near[i];
    if (set == kNone) return;
    if (set == two.one.set) continue;
    double sum = gained - cost_to(two.other, i, set);
    if (ends_early_ && sum <= best.gain) return;
    for (const bool is_entry : {!two.other.is_entry, two.other.is_entry}) {
      const LooseEnd end{set, is_entry};
      if (!may_join(two.other, end)) continue;
      if (has_lines_ && is_entry == two.other.is_entry) sum = gained - legs_.join(two.other, end);
      if (sum <= best.gain) continue;
      const CutLeg three = cut_at(end);
      if (three.position == one.position || three.position == two.position) continue;
      if (!may_join(three.other, one.one)) continue;
      const double gain = sum + legs_.after(three.position) - legs_.join(three.other, one.one);
      if (gain > best.gain) close_three(one, two, three, gain, best);
    }
  }
}

template <LegCost Cost>
void LocalSearch<Cost>::close_three(
    const CutLeg& one, const CutLeg& two, const CutLeg& three, double gain, Exchange& best) const {
  Exchange exchange;
  if (!find_rearrangement(one, two, three, exchange)) return;
  exchange.gain = gain;
  if (may_make(exchange)) best = exchange;
}

template <LegCost Cost>
double LocalSearch<Cost>::improve_position(Index set) {
  if (set == 0) return 0.0;
  const Index position = tour_->position_of(set);
  const Index before = tour_->position_before(position);
  const double freed =
      legs_.after(before) + legs_.after(position) -
      legs_.between(tour_->chosen(tour_->before(set)), tour_->chosen(tour_->after(set)));
  Insertion best;
  best.gain = min_gain_;
  for (const Index near : neighbours_.of(set).first(std::min(kThirdWidth, neighbours_.width()))) {
    if (near == kNone) break;
    const Index there = tour_->position_of(near);
    try_insertion(set, there, freed, best);
    try_insertion(set, tour_->position_before(there), freed, best);
  }
  if (best.after == kNone) return 0.0;
  make_insertion(set, best);
  return best.gain;
}

template <LegCost Cost>
void LocalSearch<Cost>::try_insertion(Index set, Index after, double freed, Insertion& best) const {
  const Index position = tour_->position_of(set);
  if (after == position || tour_->position_after(after) == position) return;
  const Index from = tour_->chosen(tour_->at(after));
  const Index to = tour_->chosen(tour_->at(tour_->position_after(after)));
  const double present = legs_.after(after);
  for (Index c = problem_->first_candidate[set]; c < problem_->first_candidate[set + 1]; ++c) {
    const double gain = freed + present - legs_.between(from, c) - legs_.between(c, to);
    if (gain > best.gain && may_make(exchange_of(position, after))) best = {after, c, gain};
  }
}

/// Returns the exchange that moves the set at `position` to the position just after `after`.
template <LegCost Cost>
Exchange LocalSearch<Cost>::exchange_of(Index position, Index after) const {
  Exchange exchange;
  exchange.has_three = true;
  // In a free tour the set may be at position 0. In every other tour home is at position 0, and
  // home is never moved.
  const Index before = tour_->position_before(position);
  if (position == 0) {
    exchange.cuts = {position, after, before};
  } else if (after > position) {
    exchange.cuts = {before, position, after};
  } else {
    exchange.cuts = {after, before, position};
  }
  return exchange;
}

template <LegCost Cost>
void LocalSearch<Cost>::make_insertion(Index set, const Insertion& insertion) {
  make(exchange_of(tour_->position_of(set), insertion.after));
  tour_->choose(set, insertion.candidate);
  queue_->add(set);
}

}  // namespace cnc::order
