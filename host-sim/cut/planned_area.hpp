#pragma once

#include <map>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// The area that a beam covers along strokes, each stroke with its own radius.
class PlannedArea {
 public:
  /// Adds a stroke.
  /// @param radius_mm above 0
  void add(const Stroke& stroke, double radius_mm);
  /// Prepares the searches. Call it after the last add().
  void prepare();

  /// Returns the depth of a point inside the covered area, negative outside, as
  /// SweptArea::depth_of() does.
  [[nodiscard]] double depth_of(const Place& place) const;

 private:
  std::map<double, Clearance> strokes_;  ///< Strokes by radius.
};

}  // namespace sim::cut
