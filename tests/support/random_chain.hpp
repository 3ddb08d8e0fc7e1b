#pragma once

#include "host-sim/measure/programmed_path.hpp"
#include "tests/support/random_source.hpp"

namespace proof {

struct ChainShape {
  std::size_t pieces = 10;
  double min_length = 0.1;  ///< Least length of a piece, mm.
  double max_length = 10.0;
  bool feeds = false;  ///< Each piece has a feed of 5…500 mm/s; without, all pieces are rapids.
};

/// Returns lines and arcs of up to 170° in X Y with tangent joints, so that only the curvature
/// steps there. They are exact in double precision, unlike the text of a program.
[[nodiscard]] sim::ProgrammedPath random_chain(Random& random, const ChainShape& shape);

}  // namespace proof
