#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planner/order/place_tree.hpp"
#include "planner/order/precedence.hpp"

namespace sim::order {

/// Method that measures legs between points.
enum class Metric : std::uint8_t {
  kMatrix,        ///< Explicit costs.
  kPlane,         ///< Distance in the plane.
  kRoundedPlane,  ///< Distance rounded to the nearest whole number: EUC_2D of TSPLIB.
  kCeiledPlane,   ///< Distance rounded up to a whole number: CEIL_2D of TSPLIB.
};

/// A problem for cnc::order, with its storage: sets of candidates, of which set 0 is home.
struct OrderProblem {
  std::string name;
  std::vector<cnc::order::Index> first_candidate;  ///< One entry more than there are sets.
  std::vector<cnc::order::Index> reversed;         ///< Empty if each candidate is its own reversal.
  std::vector<cnc::order::Before> pairs;
  Metric metric = Metric::kPlane;
  std::vector<cnc::order::Place> entry;  ///< Entry of each candidate, if there is no matrix.
  std::vector<cnc::order::Place> exit;   ///< Empty where contours are closed.
  std::vector<double> matrix;            ///< Row by row.
  bool is_symmetric = true;
  bool is_home_closed = true;
  /// Numbers that the file gives to candidates and sets.
  std::vector<std::uint32_t> vertex_numbers;
  std::vector<std::uint32_t> group_numbers;

  [[nodiscard]] std::size_t sets() const { return first_candidate.size() - 1; }
  [[nodiscard]] std::size_t candidates() const { return first_candidate.back(); }
};

}  // namespace sim::order
