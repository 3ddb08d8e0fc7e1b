#pragma once

#include <string>

#include "host-sim/cut/burnt_pictures.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Returns the entity of the drawing from which a cut was made, which may be a picture. A slice has
/// the name `slice` and no point.
[[nodiscard]] inline drawing::Entity entity_of(const Cut& cut, const drawing::Drawing& drawn) {
  if (cut.contour < drawn.contours.size()) return drawn.contours[cut.contour].entity;
  if (cut.picture) return cut.picture->entity;
  return {.name = "slice", .layer = cut.layer};
}

}  // namespace sim::cut
