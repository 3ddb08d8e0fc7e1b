#include "host-sim/pocket/spiral_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "host-sim/contour/contour_loops.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim::pocket {
namespace {

using cnc::contour::kNone;
using cnc::pocket::Milling;

/// Greatest distance between two loops with a turn between them, also in corners, in tool radii.
constexpr double kWidest = 1.9;
/// Tolerance of turns, as a share of the tool's radius.
constexpr double kTolerance = 2.5e-4;
/// Least number of turns of a spiral. A spiral with fewer turns takes longer than its loops.
constexpr std::size_t kFewestTurns = 2;
/// Greatest length of a spiral around an island, as a multiple of the length of the passes that it
/// replaces.
constexpr double kLongest = 1.5;

Milling opposite(Milling milling) {
  return milling == Milling::kClimb ? Milling::kConventional : Milling::kClimb;
}

}  // namespace

std::vector<SpiralLoop> SpiralSearch::outwards(const PassLoop& first,
                                               const DrivenMarks& is_driven) const {
  std::vector<SpiralLoop> spiral{{first, options_.milling}};
  for (;;) {
    const std::optional<PassLoop> next = tree_.around(spiral.back().loop);
    if (!next || is_driven[next->pass][next->loop]) break;
    spiral.push_back({*next, options_.milling});
  }
  while (spiral.size() > kFewestTurns) {
    const std::size_t reached = add_turns(spiral);
    if (reached == spiral.size()) return spiral;
    spiral.resize(reached);
  }
  return {};
}

/// Adds to each loop the turns that lead to it from the previous loop. Returns the number of loops
/// that the turns reach.
std::size_t SpiralSearch::add_turns(std::vector<SpiralLoop>& spiral) const {
  spiral.back().start_mm = driven(spiral.back().loop, spiral.back().milling).longest_middle();
  for (std::size_t i = spiral.size() - 1; i > 0; --i) {
    const DrivenLoop outer = driven(spiral[i].loop, spiral[i].milling);
    const DrivenLoop inner = driven(spiral[i - 1].loop, spiral[i - 1].milling);
    const OwnedBoundary boundary{only(spiral[i - 1].loop)};
    const cnc::WideVec2 place = outer.row().place(spiral[i].start_mm);
    spiral[i - 1].start_mm = inner.way_at(boundary.nearest().nearest_to(place).point);
  }
  for (std::size_t i = 1; i < spiral.size(); ++i) {
    SpiralLoop& loop = spiral[i];
    const OwnedBoundary inner{only(spiral[i - 1].loop)};
    const DrivenLoop outer = driven(loop.loop, loop.milling);
    const double turns = loop.turn_count;
    loop.turns.clear();
    for (double turn = 0.0; turn < turns; ++turn) {
      const auto way = spiral_turn(inner,
                                   outer,
                                   loop.start_mm,
                                   {.tolerance_mm = kTolerance * options_.tool_radius_mm,
                                    .widest_mm = kWidest * options_.tool_radius_mm,
                                    .milling = options_.milling,
                                    .begin_share = turn / turns,
                                    .end_share = (turn + 1.0) / turns});
      if (!way) return i;
      std::ranges::copy(*way, std::back_inserter(loop.turns));
    }
  }
  return spiral.size();
}

std::vector<IslandSpiral> SpiralSearch::around_islands() const {
  std::vector<IslandSpiral> spirals;
  std::vector<bool> is_replaced(plan_.passes.size());
  for (std::uint32_t pass = 0; pass < plan_.passes.size(); ++pass) {
    if (tree_.parent(pass) == kNone || is_replaced[pass] || tree_.around({pass, 0})) continue;
    std::optional<IslandSpiral> spiral = around_island(pass);
    if (!spiral) continue;
    for (const std::uint32_t replaced : spiral->replaced) is_replaced[replaced] = true;
    spirals.push_back(std::move(*spiral));
  }
  return spirals;
}

/// Returns the rings from a pass with a single hole inwards, as long as only rings are between the
/// passes. Returns none if the first pass is not a ring.
std::vector<SpiralSearch::Ring> SpiralSearch::rings_from(std::uint32_t pass) const {
  std::vector<Ring> rings;
  for (std::optional<std::uint32_t> next = pass; next; next = tree_.only_child(*next)) {
    const auto loops = plan_.passes[*next].view();
    if (loops.loop_ends.size() != 2) break;
    if (!rings.empty() && !tree_.around({*next, 0})) break;
    const std::size_t outline = cnc::pocket::signed_area(loops, 0) > 0.0 ? 0 : 1;
    rings.push_back({.island = {*next, 1 - outline}, .outline = {*next, outline}});
  }
  return rings;
}

/// Returns the least number of turns between the two loops of a ring for which neighbouring turns
/// are at most the stepover apart.
std::uint32_t SpiralSearch::turns_between(const Ring& ring) const {
  const OwnedBoundary island{only(ring.island)};
  const cut::MeasuredRow outline = driven(ring.outline, options_.milling).row();
  const double step_mm = 0.25 * options_.tool_radius_mm;
  const double parts = std::ceil(outline.length() / step_mm);
  double widest_mm = 0.0;
  for (double i = 0.0; i < parts; ++i) {
    const cnc::WideVec2 place = outline.place(i / parts * outline.length());
    widest_mm = std::max(widest_mm, island.distance(place));
  }
  return static_cast<std::uint32_t>(std::max(1.0, std::ceil(widest_mm / options_.stepover_mm)));
}

std::optional<IslandSpiral> SpiralSearch::around_island(std::uint32_t pass) const {
  const std::vector<Ring> rings = rings_from(pass);
  if (rings.empty()) return std::nullopt;
  IslandSpiral spiral{pass, {}, tree_.within(pass)};
  double replaced_mm = 0.0;
  for (const std::uint32_t replaced : spiral.replaced) {
    const auto loops = plan_.passes[replaced].loop_ends.size();
    for (std::size_t loop = 0; loop < loops; ++loop) replaced_mm += length_of({replaced, loop});
  }
  double length_mm = 0.0;
  const Milling against = opposite(options_.milling);
  for (const Ring& ring : rings) {
    length_mm += length_of(ring.island) + length_of(ring.outline);
    spiral.loops.push_back({.loop = ring.island, .milling = against});
  }
  const Ring& innermost = rings.back();
  const std::uint32_t turns = turns_between(innermost);
  length_mm += 0.5 * (turns - 1) * (length_of(innermost.island) + length_of(innermost.outline));
  if (length_mm > kLongest * replaced_mm) return std::nullopt;
  for (std::size_t i = rings.size(); i-- > 0;) {
    spiral.loops.push_back({.loop = rings[i].outline, .milling = options_.milling});
  }
  spiral.loops[rings.size()].turn_count = turns;
  if (add_turns(spiral.loops) < spiral.loops.size()) return std::nullopt;
  return spiral;
}

double SpiralSearch::length_of(const PassLoop& loop) const {
  return driven(loop, options_.milling).length();
}

/// Returns one loop as a contour.
Contour SpiralSearch::only(const PassLoop& loop) const {
  Contour contour;
  append_loop(plan_.passes[loop.pass].view(), loop.loop, contour);
  return contour;
}

}  // namespace sim::pocket
