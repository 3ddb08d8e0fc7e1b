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
  kOurs,     ///< Local search with trials, and a proof where one is found in time.
  kAnneal,   ///< The paper's simulated annealing.
  kNearest,  ///< Always the nearest candidate next.
  kFile,     ///< As the file lists them, each after those that it must come after.
  kExact,    ///< The optimum with its proof.
};
[[nodiscard]] std::string_view name_of(OrderMethod method);

struct OrderOptions {
  OrderMethod method = OrderMethod::kOurs;
  /// Without: one second, and as long as it takes for a proof alone.
  std::optional<double> seconds;
  /// Instead of seconds: the result is the same on every machine.
  std::optional<std::uint64_t> steps;
  std::uint64_t seed = 1;
  std::size_t memory_bytes = 1'000'000'000;  ///< Of the proof's states.
  /// Whether a search for the cheapest order also looks for a proof where one may be found.
  bool may_prove = true;
  /// A tour that a search begins with if it is cheaper than the one that always takes the nearest:
  /// sets, home first, and the candidate of each set, by set. Empty: none.
  std::vector<cnc::order::Index> start_order{};
  std::vector<cnc::order::Index> start_chosen{};
};

struct OrderResult {
  double cost = 0.0;
  std::vector<cnc::order::Index> order;       ///< Sets, home first.
  std::vector<cnc::order::Index> candidates;  ///< In the order of the tour.
  std::uint64_t steps = 0;
  bool is_proven = false;  ///< No tour is cheaper.
  std::vector<cnc::order::AnnealingPoint> course;
};

/// A problem that has no tour: a cycle in its precedence, or sets that no allowed leg reaches; or a
/// proof that does not fit.
class NoOrder : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Called now and then with the share of the run that is done and the cost of the best tour.
using OrderProgress = std::function<void(double, double)>;

/// Throws NoOrder.
[[nodiscard]] OrderResult solve_order(const OrderProblem& input,
                                      const OrderOptions& options,
                                      const OrderProgress& progress);

}  // namespace sim::order
