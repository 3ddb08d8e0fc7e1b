#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planner/order/place_tree.hpp"
#include "planner/order/precedence.hpp"

namespace sim::order {

/// How legs are measured between places.
enum class Metric : std::uint8_t {
  kMatrix,        ///< Explicit costs.
  kPlane,         ///< Distance.
  kRoundedPlane,  ///< Distance to the nearest whole number: TSPLIB's EUC_2D.
  kCeiledPlane,   ///< Distance to the next whole number: TSPLIB's CEIL_2D.
};

/// A problem for cnc::order, with its storage: sets of candidates, of which set 0 is home.
struct OrderProblem {
  std::string name;
  std::vector<cnc::order::Index> first_candidate;  ///< One more than sets.
  std::vector<cnc::order::Index> reversed;         ///< Empty: every candidate is its own.
  std::vector<cnc::order::Before> pairs;
  Metric metric = Metric::kPlane;
  std::vector<cnc::order::Place> entry;  ///< Without a matrix: by candidate.
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
