#include "host-sim/cut/filled_area.hpp"

#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "host-sim/contour/arrangement.hpp"
#include "host-sim/import/filled_set.hpp"

namespace sim::cut {
namespace {

constexpr double kSamePointMm = 1.0e-7;
constexpr drawing::LeastLoop kMinArea{.area_mm2 = 1.0e-6, .width_mm = kMinFilledWidthMm};

}  // namespace

Contour filled_area(const Contour& drawn, FilledBy rule) {
  std::vector<std::optional<drawing::FillingLoop>> loops;
  for (std::size_t i = 0; i < drawn.loop_ends.size(); ++i) {
    const bool counts_turns = rule == FilledBy::kTurns;
    const auto shape = static_cast<std::uint32_t>(counts_turns ? 0 : i);
    loops.emplace_back(drawing::FillingLoop{.is_nonzero = counts_turns, .shape = shape});
  }
  Arrangement arrangement;
  std::optional<drawing::FilledSet> filled;
  if (arrangement.divide(drawn.view(), kSamePointMm)) {
    std::vector<std::uint32_t> edges(arrangement.edges().size());
    std::iota(edges.begin(), edges.end(), 0U);
    filled = drawing::fill_set(arrangement, edges, loops, kMinArea);
  }
  if (!filled) {
    throw NoOffset{drawn.vertices.front().point(),
                   "the area in this contour, or in one near it, does not close",
                   "check whether contours cross each other, and separate them"};
  }
  return std::move(filled->outlines);
}

}  // namespace sim::cut
