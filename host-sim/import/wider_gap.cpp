#include "host-sim/import/wider_gap.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "host-sim/import/loose_ends.hpp"

namespace sim::drawing {
namespace {

constexpr std::array<double, 5> kProposedGapsMm{0.02, 0.05, 0.1, 0.2, kWidestProposedGapMm};

}  // namespace

std::optional<WiderGap> wider_gap(const std::vector<Piece>& chains, double gap_mm) {
  LooseEnds ends;
  double shortest_mm = std::numeric_limits<double>::infinity();
  for (const Piece& chain : chains) {
    const DrawnContour& contour = chain.contour;
    if (contour.length_mm <= gap_mm) continue;
    shortest_mm = std::min(shortest_mm, contour.length_mm);
    if (distance(chain.outline.front(), chain.outline.back()) <= gap_mm) continue;
    ends.add(chain);
  }
  ends.prepare();
  const std::vector<double> distances = ends.paired_distances();
  const auto within = [&](double gap) {
    return static_cast<std::size_t>(std::ranges::upper_bound(distances, gap) - distances.begin());
  };
  const std::size_t open = ends.count() - 2 * within(gap_mm);
  for (const double gap : kProposedGapsMm) {
    const std::size_t closing = 2 * (within(gap) - within(gap_mm));
    const std::size_t most = 2 * (distances.size() - within(gap_mm));
    if (gap <= gap_mm || gap >= shortest_mm || closing == 0) continue;
    if (2 * closing > open && 10 * closing >= 9 * most) return WiderGap{gap, open, closing};
  }
  return {};
}

}  // namespace sim::drawing
