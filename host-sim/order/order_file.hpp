#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "host-sim/order/order_problem.hpp"

namespace sim::order {

/// Exception for a faulty problem file. Its text names the position: `file:line: reason; remedy`.
class OrderFileError : public std::runtime_error {
 public:
  OrderFileError(std::string_view file, std::size_t line, std::string_view reason);
};

/// Reads a published problem in one of these formats:
///
/// * TSPLIB (`TYPE: TSP`): EDGE_WEIGHT_TYPE EUC_2D, CEIL_2D, or EXPLICIT as FULL_MATRIX. Each node
///   is a set of one candidate; home is the first node.
/// * PCGLNS (`TYPE: PCGLNS`, also GTSP): EXPLICIT as FULL_MATRIX, with −1 for a forbidden leg.
///   GTSP_SET_SECTION lists the vertices of each group, ended by −1. Each line `a b … −1` of
///   GTSP_SET_ORDERING means that group a comes before group b and before all other groups of the
///   line. START_GROUP_SECTION names home; without this section, home is group 1.
///
/// Throws OrderFileError. Refuses all other entries, except entries that do not affect a search
/// (COMMENT, DISPLAY_…).
[[nodiscard]] OrderProblem read_order_problem(std::string_view text, std::string_view file);

}  // namespace sim::order
