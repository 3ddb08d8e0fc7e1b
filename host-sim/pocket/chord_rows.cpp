#include "host-sim/pocket/chord_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "planner/contour/box_tree.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::contour::FlatBox;
using Curve = cnc::contour::Curve<double>;

/// Divides an arc of at most half a turn into parts. Each part is within `sagitta_mm` of its chord
/// and of its tangents.
class ArcParts {
 public:
  ArcParts(const Curve& curve, double sagitta_mm)
      : curve_{curve}, sweep_{4.0 * std::atan(curve.bulge_between(curve.start, curve.end))} {
    if (curve.curvature == 0.0) return;
    constexpr double kMaxRadians = 0.8;
    constexpr double kMaxParts = 4096.0;
    const double each =
        std::min(kMaxRadians, 2.0 * std::sqrt(2.0 * sagitta_mm * std::abs(curve.curvature)));
    count_ = static_cast<int>(std::clamp(std::ceil(std::abs(sweep_) / each), 1.0, kMaxParts));
  }

  [[nodiscard]] int count() const { return count_; }

  /// Returns the point of the arc at the end of the first `parts` parts.
  [[nodiscard]] WideVec2 joint(int parts) const {
    return point_at(static_cast<double>(parts) / count_);
  }

  /// Returns the point where the tangents at both ends of a part intersect.
  [[nodiscard]] WideVec2 tangents_meet(int part) const {
    const double share = (static_cast<double>(part) + 0.5) / count_;
    const double angle = share * sweep_;
    const WideVec2 tangent = std::cos(angle) * curve_.start_tangent +
                             std::sin(angle) * cnc::left_normal(curve_.start_tangent);
    const double outwards = (1.0 / std::cos(0.5 * sweep_ / count_) - 1.0) / curve_.curvature;
    return point_at(share) - outwards * cnc::left_normal(tangent);
  }

 private:
  /// Returns the point at a share of the sweep. The point is the end of a chord from the start. The
  /// angle between this chord and the start tangent is half of the sweep up to the point.
  [[nodiscard]] WideVec2 point_at(double share) const {
    const double half = 0.5 * share * sweep_;
    const double length = 2.0 * std::sin(half) / curve_.curvature;
    const WideVec2 normal = cnc::left_normal(curve_.start_tangent);
    return curve_.start +
           length * (std::cos(half) * curve_.start_tangent + std::sin(half) * normal);
  }

  const Curve& curve_;
  double sweep_;
  int count_ = 1;
};

class ChordMaker {
 public:
  explicit ChordMaker(const cnc::pocket::AreaDistance& area) : area_{area} {
    FlatBox<double> box = area.element(0).box();
    for (std::uint32_t i = 1; i < area.element_count(); ++i) box.include(area.element(i).box());
    rows_.centre = {0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
    const double reach = 0.5 * std::max(box.x1 - box.x0, box.y1 - box.y0);
    rows_.unit_mm = std::exp2(std::ceil(std::log2(reach / kGridReach)));
  }

  const ChordRows& chop(double sagitta_mm) {
    rows_.chords.clear();
    for (std::uint32_t i = 0; i < area_.element_count(); ++i) chop_element(i, sagitta_mm);
    return rows_;
  }

 private:
  void chop_element(std::uint32_t index, double sagitta_mm) {
    const Curve& curve = area_.element(index);
    const ArcParts parts{curve, sagitta_mm};
    here_ = grid_point(curve.start);
    // All tangents are equally far from the centre, so the bisectors of neighbouring tangents meet
    // there.
    const bool by_tangents = curve.curvature > 0.0;
    for (int k = 0; k < parts.count(); ++k) {
      if (by_tangents) {
        add(parts.tangents_meet(k), index);
      } else if (k > 0) {
        add(parts.joint(k), index);
      }
    }
    add(area_.element(area_.next(index)).start, index);
  }

  void add(const WideVec2& place, std::uint32_t index) {
    const GridPoint to = grid_point(place);
    if (here_ == to) return;
    rows_.chords.push_back({here_, to, index});
    here_ = to;
  }

  [[nodiscard]] GridPoint grid_point(const WideVec2& place) const {
    const WideVec2 units = (place - rows_.centre) / rows_.unit_mm;
    return {static_cast<std::int32_t>(std::lround(units.x())),
            static_cast<std::int32_t>(std::lround(units.y()))};
  }

  const cnc::pocket::AreaDistance& area_;
  ChordRows rows_;
  GridPoint here_;
};

/// Returns the side of a chord on which a point is, as the sign of an exact cross product.
int side_of(const Chord& chord, const GridPoint& point) {
  const auto wide = [](std::int32_t to, std::int32_t from) { return std::int64_t{to} - from; };
  const std::int64_t side = wide(chord.to.x, chord.from.x) * wide(point.y, chord.from.y) -
                            wide(chord.to.y, chord.from.y) * wide(point.x, chord.from.x);
  return (side > 0) - (side < 0);
}

FlatBox<double> box_of(const Chord& chord) {
  return {static_cast<double>(std::min(chord.from.x, chord.to.x)),
          static_cast<double>(std::min(chord.from.y, chord.to.y)),
          static_cast<double>(std::max(chord.from.x, chord.to.x)),
          static_cast<double>(std::max(chord.from.y, chord.to.y))};
}

/// Returns whether two chords have a common point that is not an end of both chords.
bool cross_each_other(const Chord& a, const Chord& b) {
  const auto is_end = [](const GridPoint& point, const Chord& of) {
    return point == of.from || point == of.to;
  };
  const auto lies_on = [&](const GridPoint& point, const Chord& of) {
    const FlatBox<double> box = box_of(of);
    const auto x = static_cast<double>(point.x);
    const auto y = static_cast<double>(point.y);
    return !is_end(point, of) && side_of(of, point) == 0 && box.meets({x, y, x, y});
  };
  if (lies_on(a.from, b) || lies_on(a.to, b) || lies_on(b.from, a) || lies_on(b.to, a)) return true;
  if (is_end(a.from, b) && is_end(a.to, b)) return true;
  return side_of(a, b.from) * side_of(a, b.to) < 0 && side_of(b, a.from) * side_of(b, a.to) < 0;
}

/// Returns the first chord that another chord crosses.
std::optional<Chord> crossed_chord(const std::vector<Chord>& chords) {
  using Tree = cnc::contour::BoxTree<double>;
  const auto count = static_cast<std::uint32_t>(chords.size());
  std::vector<FlatBox<double>> boxes(Tree::size_for(count));
  Tree tree{{boxes.data(), boxes.size()}};
  for (std::uint32_t i = 0; i < count; ++i) tree.leaf(i) = box_of(chords[i]);
  tree.build(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    bool crossed = false;
    tree.search(tree.leaf(i), i + 1, [&](std::uint32_t other) {
      crossed = cross_each_other(chords[i], chords[other]);
      return !crossed;
    });
    if (crossed) return chords[i];
  }
  return std::nullopt;
}

}  // namespace

ChordRows chords_of(const cnc::pocket::AreaDistance& area, double sagitta_mm) {
  ChordMaker maker{area};
  constexpr int kTrials = 4;
  constexpr double kFiner = 5.0;
  std::optional<Chord> crossed;
  for (int i = 0; i < kTrials; ++i) {
    const ChordRows& rows = maker.chop(sagitta_mm);
    crossed = crossed_chord(rows.chords);
    if (!crossed) return rows;
    sagitta_mm /= kFiner;
  }
  const WideVec2 place = area.element(crossed->element).start;
  throw std::runtime_error{
      fmt::format("at {:.3f} {:.3f}: the element that begins here crosses or touches another "
                  "element; separate them",
                  place.x(),
                  place.y())};
}

}  // namespace sim::pocket
