#include "host-sim/pocket/loop_pieces.hpp"

#include <algorithm>
#include <utility>

#include "host-sim/pocket/driven_loop.hpp"
#include "planner/contour/meeting.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using Curve = cnc::contour::Curve<double>;

/// Distance below which two crossings count as one, mm.
constexpr double kSameCrossingMm = 1.0e-9;

/// A stretch of a loop. `from` and `to` are distances from the first vertex, mm; `to` may exceed
/// the length of the loop.
struct LoopStretch {
  double from = 0.0;
  double to = 0.0;
};

/// Returns the points that divide a curve: its two ends, and its intersections with the boundary of
/// an area.
std::vector<WideVec2> divisions(const Curve& curve, const OwnedArea& area) {
  std::vector<WideVec2> places{curve.start, curve.end};
  area->search(curve.box(), [&](const Curve& other) {
    const auto found = cnc::contour::meetings_of(curve, other, kSameCrossingMm);
    for (std::uint32_t i = 0; i < found.count; ++i) places.push_back(found.places[i]);
    return true;
  });
  std::ranges::sort(places, {}, [&](const WideVec2& place) { return curve.order_of(place); });
  return places;
}

/// Returns the stretches of a row that are outside of an area, in order. Adjacent stretches become
/// one.
std::vector<LoopStretch> stretches_outside(const cut::MeasuredRow& row, const OwnedArea& area) {
  std::vector<LoopStretch> stretches;
  for (std::size_t i = 0; i < row.strokes().size(); ++i) {
    const cut::Stroke& stroke = row.strokes()[i];
    Curve curve;
    if (!cnc::pocket::make_curve<double>({stroke.from, stroke.to, stroke.bulge}, curve)) continue;
    const std::vector<WideVec2> places = divisions(curve, area);
    double way = row.way_to(i);
    for (std::size_t k = 1; k < places.size(); ++k) {
      const double from = way;
      const cut::Stroke part{.from = places[k - 1],
                             .to = places[k],
                             .bulge = curve.bulge_between(places[k - 1], places[k])};
      if (drawing::distance(part.from, part.to) > kSameCrossingMm) way += cut::length_of(part);
      if (k + 1 == places.size()) way = row.way_to(i + 1);
      if (way <= from || area->depth(cut::place_at(part, 0.5)) > 0.0) continue;
      const bool goes_on = !stretches.empty() && stretches.back().to >= from;
      if (goes_on) {
        stretches.back().to = way;
      } else {
        stretches.push_back({from, way});
      }
    }
  }
  return stretches;
}

/// Extends stretches by `overlap` at both ends. Joins stretches that then meet, also across the end
/// of the loop. A single stretch from 0 to `length` is the full loop.
std::vector<LoopStretch> lengthened(std::vector<LoopStretch> stretches,
                                    double overlap,
                                    double length) {
  for (LoopStretch& stretch : stretches) stretch = {stretch.from - overlap, stretch.to + overlap};
  std::vector<LoopStretch> joined;
  for (const LoopStretch& stretch : stretches) {
    if (!joined.empty() && stretch.from <= joined.back().to) {
      joined.back().to = std::max(joined.back().to, stretch.to);
    } else {
      joined.push_back(stretch);
    }
  }
  if (joined.size() > 1 && joined.front().from + length <= joined.back().to) {
    joined.front().from = joined.back().from - length;
    joined.pop_back();
  }
  if (joined.size() == 1 && joined.front().to - joined.front().from >= length) {
    return {{0.0, length}};
  }
  for (LoopStretch& stretch : joined) {
    if (stretch.from < 0.0) stretch = {stretch.from + length, stretch.to + length};
  }
  return joined;
}

std::vector<cut::Stroke> strokes_of(const cut::MeasuredRow& row, const LoopStretch& stretch) {
  const double length = row.length();
  std::vector<cut::Stroke> part = row.stretch(stretch.from, std::min(stretch.to, length));
  if (stretch.to > length) {
    const std::vector<cut::Stroke> rest = row.stretch(0.0, stretch.to - length);
    part.insert(part.end(), rest.begin(), rest.end());
  }
  return part;
}

}  // namespace

std::vector<LoopPiece> pieces_outside(const cnc::contour::ContourView<double>& loops,
                                      const OwnedArea& area,
                                      double overlap_mm) {
  std::vector<LoopPiece> pieces;
  for (std::size_t loop = 0; loop < loops.loop_ends.size(); ++loop) {
    const DrivenLoop driven{loops, loop, cnc::pocket::Milling::kClimb};
    const cut::MeasuredRow& row = driven.row();
    const double length = row.length();
    for (const LoopStretch& stretch :
         lengthened(stretches_outside(row, area), overlap_mm, length)) {
      const bool is_whole = stretch.from == 0.0 && stretch.to == length;
      pieces.push_back({loop, strokes_of(row, stretch), is_whole});
    }
  }
  return pieces;
}

}  // namespace sim::pocket
