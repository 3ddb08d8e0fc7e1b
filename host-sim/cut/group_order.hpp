#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/cut/order_wish.hpp"
#include "host-sim/cut/refine_beginnings.hpp"

namespace sim::cut {

/// How a group of cuts is ordered.
struct GroupTask {
  order::OrderMethod method = order::OrderMethod::kOurs;
  bool only_usual = false;  ///< The first beginning of each cut only.
  Place from{0.0, 0.0};
  std::optional<Place> to{};  ///< Nothing: another group follows.
  std::uint64_t seed = 1;
  std::optional<double> seconds{};
  /// Bounds the search instead of usual_steps(), where neither seconds are given nor a proof is
  /// worth while.
  std::optional<std::uint64_t> steps{};
  /// An order of the same cuts to begin a search with, with beginnings of their lists; may be
  /// empty.
  std::vector<OrderedCut> start{};
};

struct GroupResult {
  std::vector<OrderedCut> cuts;
  bool is_proven = false;
};

/// Returns how many steps a search takes that is not bounded by time: as many as take about a
/// second for 1,000 cuts, and 20 s at most.
/// @param candidates number of beginnings of all cuts
[[nodiscard]] std::uint64_t usual_steps(std::size_t cuts, std::size_t candidates);

/// Orders some of the cuts by the solver of published problems: sets are cuts, candidates their
/// beginnings.
/// @param members numbers of the cuts; what they must come after and is not among them is done
[[nodiscard]] GroupResult order_group(const std::vector<UnbegunCut>& cuts,
                                      const std::vector<std::size_t>& members,
                                      const RapidCost& cost,
                                      const GroupTask& task,
                                      const order::OrderProgress& progress);

}  // namespace sim::cut
