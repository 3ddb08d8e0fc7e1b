#pragma once

#include <cstdint>
#include <span>

#include "planner/base/result.hpp"

namespace cnc::order {

/// Number of a set or of a candidate.
using Index = std::uint32_t;

/// A pair of sets: `first` must be cut before `then`.
struct Before {
  Index first;
  Index then;
};

/// The order in which sets must be cut, as lists of successors and predecessors.
class Precedence {
 public:
  Precedence() = default;
  Precedence(std::span<const Index> first_after,
             std::span<const Index> after,
             std::span<const Index> first_before,
             std::span<const Index> before)
      : first_after_{first_after}, after_{after}, first_before_{first_before}, before_{before} {}

  [[nodiscard]] bool empty() const { return after_.empty(); }
  /// Returns the sets that must come after `set` by a direct pair.
  [[nodiscard]] std::span<const Index> after(Index set) const {
    return list(first_after_, after_, set);
  }
  /// Returns the sets that must come before `set` by a direct pair.
  [[nodiscard]] std::span<const Index> before(Index set) const {
    return list(first_before_, before_, set);
  }

 private:
  static std::span<const Index> list(std::span<const Index> firsts,
                                     std::span<const Index> items,
                                     Index set) {
    if (items.empty()) return {};
    return items.subspan(firsts[set], firsts[set + 1] - firsts[set]);
  }

  std::span<const Index> first_after_;
  std::span<const Index> after_;
  std::span<const Index> first_before_;
  std::span<const Index> before_;
};

struct PrecedenceSizes {
  std::size_t sets;
  std::size_t pairs;
};

/// Storage of a Precedence. It must outlive the Precedence.
struct PrecedenceSpace {
  std::span<Index> first_after;
  std::span<Index> after;
  std::span<Index> first_before;
  std::span<Index> before;
  std::span<Index> waits_for;  ///< Working storage of the check for cycles, like `ready`.
  std::span<Index> ready;

  template <typename Layout>
  void lay_out(Layout& layout, const PrecedenceSizes& sizes) {
    layout(first_after, sizes.sets + 1);
    layout(after, sizes.pairs);
    layout(first_before, sizes.sets + 1);
    layout(before, sizes.pairs);
    layout(waits_for, sizes.sets);
    layout(ready, sizes.sets);
  }
};

enum class PrecedenceFault : std::uint8_t {
  kNoSuchSet,  ///< The pair with index `count` contains a set that does not exist.
  /// The first `count` sets in `ready` of the storage form a ring, in which each set must come
  /// before the next.
  kCycle,
  kBeforeHome  ///< A set must come before home; `count` is the index of the pair.
};

struct PrecedenceError {
  PrecedenceFault fault{};
  std::size_t count = 0;
};

/// Sorts pairs into lists and searches for cycles. A set that must come before itself is a cycle.
/// Home (set 0) is always first, so a pair with home as `first` has no effect.
[[nodiscard]] Result<Precedence, PrecedenceError> sort_precedence(std::size_t sets,
                                                                  std::span<const Before> pairs,
                                                                  const PrecedenceSpace& space);

}  // namespace cnc::order
