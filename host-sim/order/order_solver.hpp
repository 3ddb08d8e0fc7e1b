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
  kOurs,     ///< Local search with trials (cnc::order::Search), and a proof if time permits.
  kAnneal,   ///< Simulated annealing as in a paper; see cnc::order::Annealing.
  kNearest,  ///< The nearest candidate is always the next one.
  kFile,     ///< Order of the file, except that each set comes after its predecessors.
  kExact,    ///< The cheapest order of all, with its proof.
};
[[nodiscard]] std::string_view name_of(OrderMethod method);

struct OrderOptions {
  OrderMethod method = OrderMethod::kOurs;
  /// Time for the run, s. If it is missing: one second, or unlimited time for a proof alone
  /// (kExact).
  std::optional<double> seconds;
  /// Number of steps that ends the run instead of `seconds`. The result is then the same on every
  /// machine.
  std::optional<std::uint64_t> steps;
  std::uint64_t seed = 1;
  std::size_t memory_bytes = 1'000'000'000;  ///< Greatest memory for the states of a proof, bytes.
  /// Whether kOurs also searches for a proof that its order is the cheapest one, where this is
  /// possible.
  bool may_prove = true;
  /// A known tour. A search begins with it if it is cheaper than the tour of nearest candidates.
  /// `start_order` lists the sets, home first; `start_chosen` has the candidate of each set. Both
  /// are empty if no tour is known.
  std::vector<cnc::order::Index> start_order{};
  std::vector<cnc::order::Index> start_chosen{};
};

struct OrderResult {
  double cost = 0.0;
  std::vector<cnc::order::Index> order;       ///< Sets in the order of the tour, home first.
  std::vector<cnc::order::Index> candidates;  ///< Chosen candidates in the order of `order`.
  std::uint64_t steps = 0;
  bool is_proven = false;  ///< Whether a proof shows that no tour is cheaper.
  std::vector<cnc::order::AnnealingPoint> course;
};

/// Exception for a problem without a tour. Either its precedence has a cycle, or no allowed leg
/// leads to some sets. Also thrown if a proof does not fit into memory.
class NoOrder : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Callback of a run. It receives the share of the run that is done, 0…1, and the cost of the best
/// tour.
using OrderProgress = std::function<void(double, double)>;

/// Solves a problem by the method of the options. Throws NoOrder.
[[nodiscard]] OrderResult solve_order(const OrderProblem& input,
                                      const OrderOptions& options,
                                      const OrderProgress& progress);

}  // namespace sim::order
