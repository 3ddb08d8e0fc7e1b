#pragma once

#include <cmath>
#include <cstdint>

#include "planner/order/neighbours.hpp"

namespace cnc::order {

/// Cost of a leg: the distance in the plane from the exit to the entry.
class PlaneCost {
 public:
  explicit PlaneCost(const CandidatePlaces& places) : places_{places} {}
  [[nodiscard]] double operator()(Index from, Index to) const {
    return std::sqrt(squared_distance(places_.exit[from], places_.entry[to]));
  }

 private:
  CandidatePlaces places_;
};

/// Cost of a leg: the distance in the plane, rounded to a whole number like EUC_2D of TSPLIB.
class RoundedPlaneCost {
 public:
  explicit RoundedPlaneCost(const CandidatePlaces& places) : exact_{places} {}
  [[nodiscard]] double operator()(Index from, Index to) const {
    return static_cast<double>(static_cast<std::int64_t>(exact_(from, to) + 0.5));
  }

 private:
  PlaneCost exact_;
};

/// Cost of a leg: the distance in the plane, rounded up to a whole number like CEIL_2D of TSPLIB.
class CeiledPlaneCost {
 public:
  explicit CeiledPlaneCost(const CandidatePlaces& places) : exact_{places} {}
  [[nodiscard]] double operator()(Index from, Index to) const {
    return std::ceil(exact_(from, to));
  }

 private:
  PlaneCost exact_;
};

/// Costs of all legs, read from a matrix.
class MatrixCost {
 public:
  /// @param costs matrix of `size`² costs; the row is `from`, and the column is `to`
  MatrixCost(std::span<const double> costs, Index size) : costs_{costs}, size_{size} {}
  [[nodiscard]] double operator()(Index from, Index to) const {
    return costs_[std::size_t{from} * size_ + to];
  }

 private:
  std::span<const double> costs_;
  Index size_;
};

}  // namespace cnc::order
