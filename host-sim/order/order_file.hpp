#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "host-sim/order/order_problem.hpp"

namespace sim::order {

/// Says what is wrong where: `file:line: reason; remedy`.
class OrderFileError : public std::runtime_error {
 public:
  OrderFileError(std::string_view file, std::size_t line, std::string_view reason);
};

/// Reads a published problem.
///
/// * TSPLIB (`TYPE: TSP`): EDGE_WEIGHT_TYPE EUC_2D, CEIL_2D, or EXPLICIT as FULL_MATRIX. Each node
///   is a set of one candidate; home is the first node.
/// * PCGLNS (`TYPE: PCGLNS`, also GTSP): EXPLICIT as FULL_MATRIX, −1 for a forbidden leg;
///   GTSP_SET_SECTION with the vertices of each group, ended by −1; GTSP_SET_ORDERING, whose lines
///   `a b … −1` mean that group a comes before group b and before all others of the line;
///   START_GROUP_SECTION names home, group 1 without it.
///
/// Throws OrderFileError. Entries that are not named here are refused unless they mean nothing to a
/// search (COMMENT, DISPLAY_…).
[[nodiscard]] OrderProblem read_order_problem(std::string_view text, std::string_view file);

}  // namespace sim::order
