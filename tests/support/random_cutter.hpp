#pragma once

#include <algorithm>

#include "planner/surface/profile.hpp"
#include "tests/support/random_source.hpp"

namespace proof {

/// Returns a flat, ball, bull-nose or V tool of 0.2 to 20 mm in diameter.
inline cnc::surface::Profile random_cutter(Random& random) {
  cnc::surface::Profile profile;
  profile.radius_mm = random.magnitude(0.1, 10.0);
  profile.flat_mm = profile.radius_mm;
  switch (random.below(4)) {
    case 0:
      break;
    case 1:
      profile.flat_mm = 0.0;
      profile.corner_mm = profile.radius_mm;
      break;
    case 2:
      profile.corner_mm = profile.radius_mm * random.between(0.05, 0.95);
      profile.flat_mm = profile.radius_mm - profile.corner_mm;
      break;
    default:
      profile.flat_mm = random.chance(0.5) ? 0.0 : profile.radius_mm * random.between(0.0, 0.8);
      profile.rise = random.magnitude(0.05, 20.0);
  }
  return profile;
}

}  // namespace proof
