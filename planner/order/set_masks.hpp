#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "planner/order/problem.hpp"

namespace cnc::order {

/// Mask of sets without home: set s is bit s − 1.
using SetMask = std::uint64_t;
inline constexpr Index kMaxMaskedSets = 64;

[[nodiscard]] constexpr SetMask bit_of(Index set) { return SetMask{1} << (set - 1); }
[[nodiscard]] constexpr Index count_of(SetMask mask) {
  return static_cast<Index>(std::popcount(mask));
}

/// Precedence, including all pairs that follow from chains of pairs.
class MaskedPrecedence {
 public:
  /// @pre at most kMaxMaskedSets sets besides home
  explicit MaskedPrecedence(const Problem& problem) : sets_{problem.sets() - 1} {
    for (Index set = 1; set <= sets_; ++set) {
      for (const Index before : problem.precedence.before(set)) {
        if (before != 0) before_[set] |= bit_of(before);
      }
    }
    // Each pass doubles the length of the chains that are included.
    for (Index length = 1; length < sets_; length *= 2) extend();
    for (Index set = 1; set <= sets_; ++set) {
      for (Index other = 1; other <= sets_; ++other) {
        if ((before_[other] & bit_of(set)) != 0) after_[set] |= bit_of(other);
      }
    }
  }

  [[nodiscard]] SetMask before(Index set) const { return before_[set]; }
  [[nodiscard]] SetMask after(Index set) const { return after_[set]; }

  /// Returns whether `then` may come directly after `set`.
  [[nodiscard]] bool may_follow(Index set, Index then) const {
    return set != then && (before_[set] & bit_of(then)) == 0 && (after_[set] & before_[then]) == 0;
  }
  /// Returns whether a set may have the position `number` in the tour, counted from 1 after home.
  [[nodiscard]] bool may_be_at(Index set, Index number) const {
    return count_of(before_[set]) < number && number + count_of(after_[set]) <= sets_;
  }

 private:
  void extend() {
    for (Index set = 1; set <= sets_; ++set) {
      SetMask all = before_[set];
      for (SetMask rest = before_[set]; rest != 0; rest &= rest - 1) {
        all |= before_[static_cast<Index>(std::countr_zero(rest)) + 1];
      }
      before_[set] = all;
    }
  }

  std::array<SetMask, kMaxMaskedSets + 1> before_{};
  std::array<SetMask, kMaxMaskedSets + 1> after_{};
  Index sets_;
};

}  // namespace cnc::order
