#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "planner/order/costs.hpp"
#include "planner/order/nearest_order.hpp"
#include "planner/order/storage.hpp"
#include "planner/order/tour.hpp"
#include "tests/support/random_source.hpp"

namespace proof {

/// Working storage on the heap, filled with bytes on which no algorithm may rely.
template <typename Space>
class TestSpace {
 public:
  template <typename Sizes>
  explicit TestSpace(const Sizes& sizes)
      : block_(cnc::order::bytes_for<Space>(sizes) / sizeof(double) + 1, -1.0e300),
        space_{cnc::order::space_in<Space>(std::as_writable_bytes(std::span{block_}), sizes)} {}

  const Space& operator*() const { return space_; }

 private:
  std::vector<double> block_;
  Space space_;
};

/// Properties of a random problem.
struct ProblemKind {
  std::size_t sets = 6;
  std::size_t max_candidates = 3;
  double precedence = 0.2;  ///< Probability that a pair has a precedence.
  double forbidden = 0.0;   ///< Probability that a leg is forbidden.
  bool is_symmetric = true;
  bool has_lines = false;  ///< If true, sets of two candidates are open lines, each candidate being
                           ///< the reverse of the other.
  bool is_grid = false;    ///< If true, costs are integers, many of them equal.
};

/// A random problem with its costs as a matrix, and the storage that a search requires.
class MadeProblem {
 public:
  using Index = cnc::order::Index;

  MadeProblem(Random& random, const ProblemKind& kind) {
    make_sets(random, kind);
    make_costs(random, kind);
    make_pairs(random, kind);
    precedence_ = std::make_unique<TestSpace<cnc::order::PrecedenceSpace>>(
        cnc::order::PrecedenceSizes{kind.sets, pairs.size()});
    const auto sorted = cnc::order::sort_precedence(kind.sets, pairs, **precedence_);
    problem = {first, reversed, sorted.value(), kind.is_symmetric, kind.is_symmetric};
    for (Index set = 0; set < problem.sets(); ++set) {
      set_of.resize(first[set + 1], set);
    }
    constexpr Index kWidth = 5;
    lists.resize(kind.sets * kWidth);
    neighbours = cnc::order::find_neighbours(problem, cost(), set_of, kWidth, lists);
  }
  MadeProblem(const MadeProblem&) = delete;
  MadeProblem& operator=(const MadeProblem&) = delete;

  [[nodiscard]] const cnc::order::MatrixCost& cost() const { return cost_; }

  [[nodiscard]] double cost_of(std::span<const Index> order, std::span<const Index> chosen) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      sum += cost()(chosen[order[i]], chosen[order[(i + 1) % order.size()]]);
    }
    return sum;
  }

  [[nodiscard]] bool keeps_precedence(std::span<const Index> order) const {
    std::vector<std::size_t> at(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) at[order[i]] = i;
    return std::all_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
      return at[pair.first] < at[pair.then];
    });
  }

  /// Returns the cost of the cheapest tour, by trying all.
  [[nodiscard]] double min_by_trying_all() const {
    std::vector<Index> order(problem.sets());
    std::iota(order.begin(), order.end(), 0);
    double least = 1.0e300;
    do {
      if (keeps_precedence(order)) least = std::min(least, min_of(order));
    } while (std::next_permutation(order.begin() + 1, order.end()));
    return least;
  }

  /// Returns the least cost over all choices of candidates for an order.
  [[nodiscard]] double min_of(std::span<const Index> order) const {
    std::vector<Index> chosen(first.begin(), first.end() - 1);
    double least = 1.0e300;
    for (;;) {
      least = std::min(least, cost_of(order, chosen));
      std::size_t set = 0;
      while (set < chosen.size() && ++chosen[set] == first[set + 1]) {
        chosen[set] = first[set];
        ++set;
      }
      if (set == chosen.size()) return least;
    }
  }

  /// Returns a start for searches: order and candidates by set.
  [[nodiscard]] std::pair<std::vector<Index>, std::vector<Index>> nearest() const {
    const TestSpace<cnc::order::NearestOrderSpace> space{
        cnc::order::NearestOrderSizes{problem.sets()}};
    std::vector<std::uint8_t> open(problem.candidates());
    cnc::order::nearest_order(
        problem, cnc::order::NearestByCost{problem, cost(), set_of, open}, *space);
    return {{(*space).order.begin(), (*space).order.end()},
            {(*space).chosen.begin(), (*space).chosen.end()}};
  }

  std::vector<Index> first{0};
  std::vector<Index> reversed;
  std::vector<cnc::order::Before> pairs;
  std::vector<double> matrix;
  cnc::order::Problem problem;
  std::vector<Index> set_of;
  std::vector<Index> lists;
  cnc::order::Neighbours neighbours;

 private:
  void make_sets(Random& random, const ProblemKind& kind) {
    for (std::size_t set = 0; set < kind.sets; ++set) {
      const auto count =
          kind.has_lines && set > 0 ? 2 : static_cast<Index>(1 + random.below(kind.max_candidates));
      first.push_back(first.back() + count);
    }
  }

  void make_costs(Random& random, const ProblemKind& kind) {
    const std::size_t size = first.back();
    std::vector<cnc::order::Place> entry;
    for (std::size_t i = 0; i < size; ++i) {
      const double step = kind.is_grid ? 10.0 : 0.0;
      const auto place = [&] {
        const double value = random.between(0.0, 100.0);
        return step > 0.0 ? step * std::floor(value / step) : value;
      };
      entry.push_back({place(), place()});
    }
    std::vector<cnc::order::Place> exit = entry;
    if (kind.has_lines) {
      for (Index c = 0; c < size; ++c) reversed.push_back(c);
      for (std::size_t set = 1; set < kind.sets; ++set) {
        std::swap(reversed[first[set]], reversed[first[set] + 1]);
        exit[first[set]] = entry[first[set] + 1];
        exit[first[set] + 1] = entry[first[set]];
      }
    }
    matrix.resize(size * size);
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t k = 0; k < size; ++k) {
        double cost = std::sqrt(squared_distance(exit[i], entry[k]));
        if (!kind.is_symmetric) cost *= random.between(0.5, 1.5);
        if (random.chance(kind.forbidden)) cost = cnc::order::kForbidden;
        matrix[i * size + k] = kind.is_grid ? std::round(cost) : cost;
      }
    }
    cost_ = cnc::order::MatrixCost{matrix, static_cast<Index>(size)};
  }

  /// Makes pairs along a hidden random order, so that at least one order keeps them.
  void make_pairs(Random& random, const ProblemKind& kind) {
    std::vector<Index> hidden(kind.sets);
    std::iota(hidden.begin(), hidden.end(), 0);
    for (std::size_t i = 1; i < kind.sets; ++i) {
      std::swap(hidden[i], hidden[i + random.below(kind.sets - i)]);
    }
    for (std::size_t i = 1; i < kind.sets; ++i) {
      for (std::size_t k = i + 1; k < kind.sets; ++k) {
        if (random.chance(kind.precedence)) pairs.push_back({hidden[i], hidden[k]});
      }
    }
  }

  cnc::order::MatrixCost cost_{{}, 0};
  std::unique_ptr<TestSpace<cnc::order::PrecedenceSpace>> precedence_;
};

/// Returns a kind of problem with 2 to `max_sets` sets and any of the properties.
inline ProblemKind random_kind(Random& random, std::size_t max_sets) {
  ProblemKind kind;
  kind.sets = 2 + random.below(max_sets - 1);
  kind.max_candidates = 1 + random.below(3);
  kind.precedence = random.chance(0.3) ? 0.0 : random.unit() * 0.6;
  kind.is_symmetric = random.chance(0.7);
  kind.has_lines = kind.is_symmetric && random.chance(0.3);
  kind.forbidden = !kind.is_symmetric && random.chance(0.3) ? 0.2 : 0.0;
  kind.is_grid = kind.forbidden > 0.0 || random.chance(0.3);
  return kind;
}

}  // namespace proof
