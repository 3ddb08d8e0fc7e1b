#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "host-sim/order/order_problem.hpp"
#include "planner/order/annealing.hpp"

namespace sim::order {

enum class OrderMethod : std::uint8_t {
  kOurs,     ///< Local search with trials, and a proof if one is found in time.
  kAnneal,   ///< Simulated annealing of the paper.
  kNearest,  ///< Always moves to the nearest candidate.
  kFile,     ///< The order of the file; each set comes after those that must precede it.
  kExact,    ///< The optimum with its proof.
};
[[nodiscard]] std::string_view name_of(OrderMethod method);

struct OrderOptions {
  OrderMethod method = OrderMethod::kOurs;
  /// Time for the run. Without a value: one second, or unlimited time for a proof alone (kExact).
  std::optional<double> seconds;
  /// Number of steps in place of seconds: the result is then the same on every machine.
  std::optional<std::uint64_t> steps;
  std::uint64_t seed = 1;
  std::size_t memory_bytes = 1'000'000'000;  ///< Greatest memory for the states of a proof.
  /// Whether a search for the cheapest order also tries to prove it where a proof is possible.
  bool may_prove = true;
  /// A tour with which a search begins if it is cheaper than the tour of nearest candidates: the
  /// sets with home first, and the candidate of each set, indexed by set. Empty: no such tour.
  std::vector<cnc::order::Index> start_order{};
  std::vector<cnc::order::Index> start_chosen{};
};

struct OrderResult {
  double cost = 0.0;
  std::vector<cnc::order::Index> order;       ///< Sets, home first.
  std::vector<cnc::order::Index> candidates;  ///< Chosen candidates, in the order of the tour.
  std::uint64_t steps = 0;
  bool is_proven = false;  ///< Whether the proof shows that no tour is cheaper.
  std::vector<cnc::order::AnnealingPoint> course;
};

/// Thrown for a problem without a tour, because of a cycle in its precedence or sets that no
/// allowed leg reaches. Also thrown for a proof that does not fit into memory.
class NoOrder : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Called from time to time with the share of the run that is done and the cost of the best tour.
using OrderProgress = std::function<void(double, double)>;

/// Solves a problem. Throws NoOrder.
[[nodiscard]] OrderResult solve_order(const OrderProblem& input,
                                      const OrderOptions& options,
                                      const OrderProgress& progress);

}  // namespace sim::order
