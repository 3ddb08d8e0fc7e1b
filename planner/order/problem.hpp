#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <span>

#include "planner/order/precedence.hpp"

namespace cnc::order {

inline constexpr Index kNone = std::numeric_limits<Index>::max();

/// Sets of candidates, of which each tour visits one candidate of every set.
///
/// A set is a contour, a candidate one way to cut it: the point where the torch arrives (entry) and
/// the point where it leaves (exit). Set 0 is home: the tour begins at its exit and ends at its
/// entry, so that a path between two fixed points is a tour, too.
struct Problem {
  /// Candidates of set s are `first_candidate[s]`…`first_candidate[s + 1] − 1`; one entry more
  /// than sets. No set is empty.
  std::span<const Index> first_candidate;
  /// The candidate that cuts the same contour backwards: an open line's other direction, and of a
  /// closed contour itself. Empty where every candidate is its own.
  std::span<const Index> reversed;
  Precedence precedence;
  /// Whether cost(u, v) = cost(reversed v, reversed u) for all candidates: a stretch of the tour
  /// costs the same in both directions.
  bool is_symmetric = true;
  /// Whether home may be passed in both directions: the tour begins and ends at the same point.
  bool is_home_closed = true;

  [[nodiscard]] Index sets() const { return static_cast<Index>(first_candidate.size() - 1); }
  [[nodiscard]] Index candidates() const { return first_candidate.back(); }
  [[nodiscard]] Index candidates_of(Index set) const {
    return first_candidate[set + 1] - first_candidate[set];
  }
  /// Returns whether a tour costs the same backwards and may be driven so.
  [[nodiscard]] bool is_free() const {
    return precedence.empty() && is_symmetric && is_home_closed;
  }
  [[nodiscard]] Index reversal_of(Index candidate) const {
    return reversed.empty() ? candidate : reversed[candidate];
  }
};

/// Cost of the leg from the exit of one candidate to the entry of another of another set. Must be
/// finite and not negative; a leg that is forbidden costs kForbidden.
template <typename Cost>
concept LegCost = requires(const Cost& cost, Index from, Index to) {
  { cost(from, to) } -> std::convertible_to<double>;
};

/// Exceeds the sum of all other legs by far, and leaves digits for them: a tour with forbidden
/// legs is worse than any without, and of two such tours the one with fewer is better.
inline constexpr double kForbidden = 1.0e12;

/// Returns whether a tour of this cost has no forbidden leg.
[[nodiscard]] constexpr bool is_allowed(double tour_cost) { return tour_cost < 0.5 * kForbidden; }

}  // namespace cnc::order
