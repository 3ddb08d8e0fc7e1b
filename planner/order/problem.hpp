#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <span>

#include "planner/order/precedence.hpp"

namespace cnc::order {

inline constexpr Index kNone = std::numeric_limits<Index>::max();

/// Sets of candidates. Each tour visits one candidate of every set.
///
/// A set is a contour. A candidate is one method to cut it: a point where the torch arrives (entry)
/// and a point where the torch leaves (exit). Set 0 is home. The tour begins at home's exit and
/// ends at home's entry, so a path between two fixed points is also a tour.
struct Problem {
  /// Index of the first candidate of each set. The candidates of set s are
  /// `first_candidate[s]`…`first_candidate[s + 1] − 1`. The span has one entry more than there are
  /// sets. No set is empty.
  std::span<const Index> first_candidate;
  /// For each candidate, the candidate that cuts the same contour backwards. For an open line it is
  /// the other direction; for a closed contour it is the candidate itself. The span is empty if
  /// every candidate is its own reversal.
  std::span<const Index> reversed;
  Precedence precedence;
  /// Whether cost(u, v) = cost(reversed v, reversed u) for all candidates, so that a stretch of the
  /// tour costs the same in both directions.
  bool is_symmetric = true;
  /// Whether home may be passed in both directions, because the tour begins and ends at the same
  /// point.
  bool is_home_closed = true;

  [[nodiscard]] Index sets() const { return static_cast<Index>(first_candidate.size() - 1); }
  [[nodiscard]] Index candidates() const { return first_candidate.back(); }
  [[nodiscard]] Index candidates_of(Index set) const {
    return first_candidate[set + 1] - first_candidate[set];
  }
  /// Returns whether a tour may be driven in the reverse direction and costs the same.
  [[nodiscard]] bool is_free() const {
    return precedence.empty() && is_symmetric && is_home_closed;
  }
  [[nodiscard]] Index reversal_of(Index candidate) const {
    return reversed.empty() ? candidate : reversed[candidate];
  }
};

/// Cost of the leg from the exit of one candidate to the entry of a candidate of another set. The
/// cost must be finite and not negative. A forbidden leg costs kForbidden.
template <typename Cost>
concept LegCost = requires(const Cost& cost, Index from, Index to) {
  { cost(from, to) } -> std::convertible_to<double>;
};

/// Cost of a forbidden leg. It far exceeds the sum of all other legs, but is small enough for a sum
/// with it to keep their digits. So a tour with forbidden legs is worse than any tour without them.
/// A tour with fewer forbidden legs is better than a tour with more of them.
inline constexpr double kForbidden = 1.0e12;

/// Returns whether a tour of this cost has no forbidden leg.
[[nodiscard]] constexpr bool is_allowed(double tour_cost) { return tour_cost < 0.5 * kForbidden; }

}  // namespace cnc::order
