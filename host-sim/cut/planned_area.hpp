#pragma once

#include <map>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// The area that a beam covers along strokes. Each stroke has its own radius of the beam.
class PlannedArea {
 public:
  /// Adds a stroke with the radius of the beam.
  /// @param radius_mm above 0
  void add(const Stroke& stroke, double radius_mm);
  /// Prepares the searches. Call it after the last add().
  void prepare();

  /// Returns the depth of a point inside the covered area, mm; negative outside, as from
  /// SweptArea::depth_of().
  [[nodiscard]] double depth_of(const Place& place) const;

 private:
  std::map<double, Clearance> strokes_;  ///< Strokes by the radius of the beam.
};

}  // namespace sim::cut
