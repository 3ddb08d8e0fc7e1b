#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Lines of a report about the order: its rapids and predicted time beside those of the drawing's
/// order and of the nearest neighbour, at most 76 characters each.
[[nodiscard]] std::vector<std::string> lines_of(const OrderFigures& order, std::size_t cuts);

/// The same for programs.
[[nodiscard]] nlohmann::ordered_json json_of(const OrderFigures& order, std::size_t cuts);

}  // namespace sim::cut
