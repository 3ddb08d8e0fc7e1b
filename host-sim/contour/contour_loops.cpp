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

void append_rectangle(const cnc::WideVec2& least, const cnc::WideVec2& most, Contour& to) {
  to.vertices.push_back({least.x(), least.y(), 0.0});
  to.vertices.push_back({most.x(), least.y(), 0.0});
  to.vertices.push_back({most.x(), most.y(), 0.0});
  to.vertices.push_back({least.x(), most.y(), 0.0});
  to.end_loop();
}

}  // namespace sim
