#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/owned_area.hpp"

namespace sim::pocket {

/// A place on the boundary of an area.
struct BoundaryPlace {
  std::uint32_t element = 0;
  cnc::WideVec2 place{0.0, 0.0};
};

/// A line or an arc by its end; it begins where the one before it ends.
struct WayElement {
  cnc::WideVec2 to{0.0, 0.0};
  double bulge = 0.0;  ///< tan(sweep / 4), positive turns left.
};

/// Returns the elements from one place of a boundary to another one along it, with the area on the
/// left or, backwards, on the right; none if that is longer than the limit, or if the places are on
/// different loops.
[[nodiscard]] std::optional<std::vector<WayElement>> way_along(const OwnedArea& area,
                                                               const BoundaryPlace& from,
                                                               const BoundaryPlace& to,
                                                               bool is_backwards,
                                                               double limit_mm);

}  // namespace sim::pocket
