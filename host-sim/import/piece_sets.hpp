#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace sim::drawing {

/// Disjoint sets of numbers. Initially each number is in a set by itself. Sets can then be united.
class PieceSets {
 public:
  explicit PieceSets(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }

  /// Returns the smallest number in the set that contains `number`.
  [[nodiscard]] std::size_t find(std::size_t number) {
    while (parents_[number] != number) {
      parents_[number] = parents_[parents_[number]];
      number = parents_[number];
    }
    return number;
  }
  void unite(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }
  [[nodiscard]] bool are_one(std::size_t a, std::size_t b) { return find(a) == find(b); }

 private:
  std::vector<std::size_t> parents_;
};

}  // namespace sim::drawing
