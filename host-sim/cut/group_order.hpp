#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/cut/order_wish.hpp"
#include "host-sim/cut/refine_beginnings.hpp"

namespace sim::cut {

/// The task of ordering a group of cuts.
struct GroupTask {
  order::OrderMethod method = order::OrderMethod::kOurs;
  bool only_usual = false;  ///< Whether only the first beginning of each cut is used.
  Place from{0.0, 0.0};
  /// Point where the group's path ends; nothing if another group follows.
  std::optional<Place> to{};
  std::uint64_t seed = 1;
  std::optional<double> seconds{};
  /// Number of steps of the search, instead of usual_steps(). If it is given, the order is not
  /// proven. The number is ignored if `seconds` has a value.
  std::optional<std::uint64_t> steps{};
  /// Order of the same cuts with which a search begins, with beginnings from their lists. It may be
  /// empty.
  std::vector<OrderedCut> start{};
};

struct GroupResult {
  std::vector<OrderedCut> cuts;
  bool is_proven = false;
};

/// Returns the number of steps of a search without a limit of time. These steps take about a second
/// for 1,000 cuts, and at most about 20 s.
/// @param candidates number of beginnings of all cuts
[[nodiscard]] std::uint64_t usual_steps(std::size_t cuts, std::size_t candidates);

/// Orders some of the cuts with the solver for published problems. Each cut is a set, whose
/// candidates are the beginnings of the cut.
/// @param members numbers of the cuts; a cut in their `after` that is not a member counts as done
[[nodiscard]] GroupResult order_group(const std::vector<UnbegunCut>& cuts,
                                      const std::vector<std::size_t>& members,
                                      const RapidCost& cost,
                                      const GroupTask& task,
                                      const order::OrderProgress& progress);

}  // namespace sim::cut
