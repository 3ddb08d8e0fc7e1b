#pragma once

#include <string>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Returns the entity of a drawing that a cut is of; of a slice, `slice` without a place.
[[nodiscard]] inline drawing::Entity entity_of(const Cut& cut, const drawing::Drawing& drawn) {
  if (cut.contour < drawn.contours.size()) return drawn.contours[cut.contour].entity;
  return {.name = "slice", .layer = cut.layer};
}

}  // namespace sim::cut
