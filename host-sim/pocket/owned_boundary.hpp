#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "planner/pocket/nearest_curve.hpp"

namespace sim::pocket {

/// Loops with their storage, prepared for queries for the nearest point.
class OwnedBoundary {
 public:
  explicit OwnedBoundary(Contour contour);

  // Not copyable, because `nearest_` points into the storage.
  OwnedBoundary(const OwnedBoundary&) = delete;
  OwnedBoundary& operator=(const OwnedBoundary&) = delete;
  ~OwnedBoundary() = default;

  [[nodiscard]] cnc::contour::ContourView<double> view() const { return contour_.view(); }
  [[nodiscard]] std::size_t loops() const { return contour_.loop_ends.size(); }
  [[nodiscard]] const cnc::pocket::NearestCurve<double>& nearest() const { return nearest_; }
  /// Returns the distance from `place` to the nearest loop, mm. @pre there is a loop
  [[nodiscard]] double distance(const cnc::WideVec2& place) const {
    return nearest_.nearest_to(place).distance;
  }

 private:
  Contour contour_;
  std::vector<cnc::contour::Curve<double>> curves_;
  std::vector<cnc::contour::FlatBox<double>> boxes_;
  cnc::pocket::NearestCurve<double> nearest_;
};

}  // namespace sim::pocket
