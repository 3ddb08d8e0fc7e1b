#pragma once

#include "host-sim/measure/programmed_path.hpp"
#include "tests/support/random_source.hpp"

namespace proof {

struct ChainShape {
  std::size_t pieces = 10;
  double min_length = 0.1;  ///< mm, of a piece.
  double max_length = 10.0;
  bool feeds = false;  ///< A feed of 5…500 mm/s for each piece; else rapids.
};

/// Lines and arcs of up to 170° in X Y that follow each other with one tangent, so that only
/// the curvature steps at their joints. Exact in double precision, unlike a program's text.
[[nodiscard]] sim::ProgrammedPath random_chain(Random& random, const ChainShape& shape);

}  // namespace proof
