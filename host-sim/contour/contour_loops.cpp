#include "host-sim/contour/contour_loops.hpp"

namespace sim {

void append_loop(const cnc::contour::ContourView<double>& from, std::size_t loop, Contour& to) {
  const auto* const first = from.vertices.begin();
  to.vertices.insert(
      to.vertices.end(), first + from.loop_begin(loop), first + from.loop_ends[loop]);
  to.end_loop();
}

void append_loops(const cnc::contour::ContourView<double>& from, Contour& to) {
  for (std::size_t loop = 0; loop < from.loop_ends.size(); ++loop) append_loop(from, loop, to);
}

}  // namespace sim
