#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/cut/order_wish.hpp"
#include "host-sim/job/setting_line.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Options of `kerfline cut` for the order of cuts.
struct CutOrderOptions {
  order::OrderMethod method = order::OrderMethod::kOurs;
  cut::OrderCost cost = cut::OrderCost::kTime;
  cut::Grouping grouping = cut::Grouping::kNone;
  std::string from;
  std::string to;
  std::optional<double> seconds{};
  std::uint64_t seed = 1;
};

/// Adds --order, --cost, --group, --from, --to, --seconds and --seed.
void add_cut_order_options(CLI::App& command, CutOrderOptions& options);

/// Returns the requirements for the order of the cuts on a machine with these settings. Throws
/// std::invalid_argument naming the wrong option or setting.
/// @param progress called repeatedly during the search for the order; may be empty
[[nodiscard]] cut::OrderWish order_wish_of(const CutOrderOptions& options,
                                           const std::vector<SettingChange>& settings,
                                           order::OrderProgress progress);

}  // namespace sim
