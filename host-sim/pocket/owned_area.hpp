#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "planner/pocket/area_distance.hpp"

namespace sim::pocket {

/// Distances from the boundary of an area, with the storage for the boundary.
class OwnedArea {
 public:
  /// Reads the area. Throws std::invalid_argument for coordinates or bulges that are not finite.
  explicit OwnedArea(const cnc::contour::ContourView<double>& area);

  // Not copyable, because `distance_` points into the storage.
  OwnedArea(const OwnedArea&) = delete;
  OwnedArea& operator=(const OwnedArea&) = delete;
  ~OwnedArea() = default;

  [[nodiscard]] const cnc::pocket::AreaDistance& operator*() const { return distance_; }
  [[nodiscard]] const cnc::pocket::AreaDistance* operator->() const { return &distance_; }

 private:
  std::vector<ContourVertex> vertices_;
  std::vector<cnc::contour::Curve<double>> elements_;
  std::vector<cnc::contour::FlatBox<double>> boxes_;
  std::vector<std::uint32_t> loop_ends_;
  cnc::pocket::AreaDistance distance_;
};

}  // namespace sim::pocket
