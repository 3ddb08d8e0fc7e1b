#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Returns lines of at most 76 characters for a report about the order. They compare its rapids and
/// its predicted time with those of the drawing's order and of the nearest neighbour.
[[nodiscard]] std::vector<std::string> lines_of(const OrderFigures& order, std::size_t cuts);

/// Returns the content of lines_of() as JSON for programs.
[[nodiscard]] nlohmann::ordered_json json_of(const OrderFigures& order, std::size_t cuts);

}  // namespace sim::cut
