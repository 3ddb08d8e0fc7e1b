#include "host-sim/contour/filled_loops.hpp"

#include <vector>

#include "host-sim/contour/arrangement.hpp"
#include "host-sim/contour/simple_loops.hpp"

namespace sim {
namespace {

/// Greatest distance between points that count as one point, mm. If the resolution of the
/// coordinates is coarser, this resolution is used instead.
constexpr double kSamePointMm = 1.0e-7;

bool is_material(const Windings& windings) {
  int turns = 0;
  for (const LoopTurns& loop : windings) turns += loop.turns;
  return turns > 0;
}

}  // namespace

std::optional<Contour> filled_loops(const cnc::contour::ContourView<double>& loops) {
  Arrangement arrangement;
  if (!arrangement.divide(loops, kSamePointMm)) return std::nullopt;
  std::vector<DirectedEdge> kept;
  for (std::uint32_t i = 0; i < arrangement.edges().size(); ++i) {
    const ArrangedEdge& edge = arrangement.edges()[i];
    const bool left = is_material(arrangement.windings(edge.left));
    const bool right = is_material(arrangement.windings(edge.right));
    if (left != right) kept.push_back({i, right});
  }
  Contour written;
  if (!arrangement.write_loops(kept, written)) return std::nullopt;
  return simple_loops(written.view());
}

}  // namespace sim
