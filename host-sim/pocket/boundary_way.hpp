#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/owned_area.hpp"

namespace sim::pocket {

/// A point on the boundary of an area.
struct BoundaryPlace {
  std::uint32_t element = 0;
  cnc::WideVec2 place{0.0, 0.0};
};

/// A line or an arc that begins at the end of the previous element.
struct WayElement {
  cnc::WideVec2 to{0.0, 0.0};
  double bulge = 0.0;  ///< tan(sweep / 4); 0 for a line, positive for a left turn.
};

/// Returns the elements along the boundary from one point to another. The area is to the left of
/// the path, or to the right if `is_backwards`. Returns none if the path is longer than `limit_mm`,
/// or if the points are on different loops.
[[nodiscard]] std::optional<std::vector<WayElement>> way_along(const OwnedArea& area,
                                                               const BoundaryPlace& from,
                                                               const BoundaryPlace& to,
                                                               bool is_backwards,
                                                               double limit_mm);

}  // namespace sim::pocket
