#include "planner/order/precedence.hpp"

#include <algorithm>

namespace cnc::order {
namespace {

using Item = Index Before::*;

/// Makes a list of all `value` members for each value of the member `key`, by a counting sort of
/// the pairs.
void make_lists(std::span<const Before> pairs,
                Item key,
                Item value,
                std::span<Index> firsts,
                std::span<Index> items) {
  std::fill(firsts.begin(), firsts.end(), 0);
  for (const Before& pair : pairs) ++firsts[pair.*key];
  Index sum = 0;
  for (Index& first : firsts) {
    sum += first;
    first = sum;
  }
  for (std::size_t i = pairs.size(); i-- > 0;) items[--firsts[pairs[i].*key]] = pairs[i].*value;
}

/// Returns the number of sets that can be cut in a sequence in which each set comes after all its
/// predecessors.
std::size_t count_in_order(const Precedence& lists, const PrecedenceSpace& space) {
  const auto sets = static_cast<Index>(space.waits_for.size());
  std::size_t count = 0;
  for (Index set = 0; set < sets; ++set) {
    space.waits_for[set] = static_cast<Index>(lists.before(set).size());
    if (space.waits_for[set] == 0) space.ready[count++] = set;
  }
  for (std::size_t next = 0; next < count; ++next) {
    for (const Index then : lists.after(space.ready[next])) {
      if (--space.waits_for[then] == 0) space.ready[count++] = then;
    }
  }
  return count;
}

/// Finds a ring of sets, writes it to `ready` and returns its length.
/// @pre count_in_order() was less than the number of sets, so some sets are waiting
std::size_t find_ring(const Precedence& lists, const PrecedenceSpace& space) {
  // Walks backwards from any waiting set. Each waiting set has a waiting set before it, so the walk
  // returns to a set that it has visited.
  const auto waiting = [&](Index set) { return space.waits_for[set] != 0; };
  const auto sets = static_cast<Index>(space.waits_for.size());
  Index set = 0;
  while (!waiting(set)) ++set;
  // Reuses the storage of `ready`, whose content is not required any more.
  std::span<Index> met_at = space.ready;
  std::fill(met_at.begin(), met_at.end(), sets);
  std::size_t length = 0;
  while (met_at[set] == sets) {
    met_at[set] = static_cast<Index>(length++);
    const auto before = lists.before(set);
    set = *std::find_if(before.begin(), before.end(), waiting);
  }
  const Index start = set;
  length -= met_at[start];
  // Walks along the ring a second time and writes it in the order of cutting.
  for (std::size_t i = length; i-- > 0;) {
    const auto before = lists.before(set);
    set = *std::find_if(before.begin(), before.end(), waiting);
    space.ready[i] = set;
  }
  return length;
}

}  // namespace

Result<Precedence, PrecedenceError> sort_precedence(std::size_t sets,
                                                    std::span<const Before> pairs,
                                                    const PrecedenceSpace& space) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].first >= sets || pairs[i].then >= sets) {
      return PrecedenceError{PrecedenceFault::kNoSuchSet, i};
    }
    if (pairs[i].then == 0) return PrecedenceError{PrecedenceFault::kBeforeHome, i};
  }
  make_lists(pairs, &Before::first, &Before::then, space.first_after, space.after);
  make_lists(pairs, &Before::then, &Before::first, space.first_before, space.before);
  const Precedence lists{space.first_after, space.after, space.first_before, space.before};
  if (count_in_order(lists, space) == sets) return lists;
  return PrecedenceError{PrecedenceFault::kCycle, find_ring(lists, space)};
}

}  // namespace cnc::order
