#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planner/order/place_tree.hpp"
#include "planner/order/precedence.hpp"

namespace sim::order {

/// Method by which the cost of a leg is determined.
enum class Metric : std::uint8_t {
  kMatrix,        ///< Costs that a matrix gives.
  kPlane,         ///< Distance in the plane.
  kRoundedPlane,  ///< Distance rounded to the nearest whole number: EUC_2D of TSPLIB.
  kCeiledPlane,   ///< Distance rounded up to a whole number: CEIL_2D of TSPLIB.
};

/// A problem for cnc::order together with its storage. It consists of sets of candidates, of which
/// set 0 is home.
struct OrderProblem {
  std::string name;
  /// First candidate of each set, then the number of candidates.
  std::vector<cnc::order::Index> first_candidate;
  /// For each candidate, the candidate that cuts the same contour backwards. Empty if each
  /// candidate equals its own reversal.
  std::vector<cnc::order::Index> reversed;
  std::vector<cnc::order::Before> pairs;
  Metric metric = Metric::kPlane;
  /// Entry point of each candidate; empty if there is a matrix.
  std::vector<cnc::order::Place> entry;
  /// Exit point of each candidate; empty if the exit of each candidate is its entry.
  std::vector<cnc::order::Place> exit;
  /// Costs of all legs; a row holds the legs from one candidate.
  std::vector<double> matrix;
  bool is_symmetric = true;
  bool is_home_closed = true;
  /// Number that the file gives to each candidate (`vertex_numbers`) and to each set
  /// (`group_numbers`).
  std::vector<std::uint32_t> vertex_numbers;
  std::vector<std::uint32_t> group_numbers;

  [[nodiscard]] std::size_t sets() const { return first_candidate.size() - 1; }
  [[nodiscard]] std::size_t candidates() const { return first_candidate.back(); }
};

}  // namespace sim::order
