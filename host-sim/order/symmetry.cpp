#include "host-sim/order/symmetry.hpp"

#include "planner/order/problem.hpp"

namespace sim::order {
namespace {

using cnc::order::Index;

/// Determines whether one set must come before another, directly by a pair or by a chain of pairs.
class Reach {
 public:
  explicit Reach(const OrderProblem& problem) : after_(problem.sets()), known_(problem.sets()) {
    for (const auto& [first, then] : problem.pairs) after_[first].push_back(then);
  }

  /// Returns whether `from` must come before `to`. Home comes before all other sets.
  [[nodiscard]] bool leads(Index from, Index to) {
    if (from == 0) return true;
    std::vector<bool>& reached = known_[from];
    if (reached.empty()) {
      reached.resize(after_.size());
      std::vector<Index> open{from};
      while (!open.empty()) {
        const Index set = open.back();
        open.pop_back();
        for (const Index after : after_[set]) {
          if (reached[after]) continue;
          reached[after] = true;
          open.push_back(after);
        }
      }
    }
    return reached[to];
  }

 private:
  std::vector<std::vector<Index>> after_;
  std::vector<std::vector<bool>> known_;
};

}  // namespace

bool is_symmetric(const OrderProblem& problem) {
  const std::size_t size = problem.candidates();
  std::vector<Index> set_of;
  for (std::size_t set = 0; set < problem.sets(); ++set) {
    set_of.resize(problem.first_candidate[set + 1], static_cast<Index>(set));
  }
  Reach reach{problem};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double there = problem.matrix[i * size + k];
      const double back = problem.matrix[k * size + i];
      if (there == back || set_of[i] == set_of[k]) continue;
      if (there == cnc::order::kForbidden && reach.leads(set_of[k], set_of[i])) continue;
      if (back == cnc::order::kForbidden && reach.leads(set_of[i], set_of[k])) continue;
      return false;
    }
  }
  return true;
}

}  // namespace sim::order
