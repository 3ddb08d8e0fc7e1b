#pragma once

#include <algorithm>
#include <cmath>

#include "tests/support/contour_corpus.hpp"
#include "tests/support/contour_oracle.hpp"

namespace proof {

/// Returns a pocket of 30 to 80 mm whose walls do not cross. It consists of lines and arcs of at
/// most half a turn; one in twenty has islands.
inline sim::Contour random_pocket(Random& random) {
  sim::Contour area;
  do {
    area = random.chance(0.95) ? random_star(random, 3 + random.below(12), 15.0, 40.0)
                               : random_case(Corpus::kIslands, random.bits() >> 8).contour;
  } while (!is_simple(area.view()) || std::ranges::any_of(area.vertices, [](const auto& vertex) {
    return std::abs(vertex.bulge) > 1.0;
  }));
  return area;
}

}  // namespace proof
