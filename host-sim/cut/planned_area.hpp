#pragma once

#include <map>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Everything that a beam covers along strokes, each with a radius of its own.
class PlannedArea {
 public:
  /// @param radius_mm > 0
  void add(const Stroke& stroke, double radius_mm);
  /// After the last add().
  void prepare();

  /// Returns how far a place is inside of what is covered, negative outside, as
  /// SweptArea::depth_of() does.
  [[nodiscard]] double depth_of(const Place& place) const;

 private:
  std::map<double, Clearance> strokes_;  ///< By radius.
};

}  // namespace sim::cut
