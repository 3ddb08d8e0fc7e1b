#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/sheet/sheet_check.hpp"
#include "planner/contour/box_tree.hpp"

namespace sim::sheet {
namespace {

using drawing::cross;
using drawing::distance;
using drawing::dot;
using drawing::Drawing;
using drawing::DrawnContour;
using drawing::Place;

/// Distance within which a point counts as on a line, and within which two points count as one, mm.
constexpr double kOnLineMm = 1.0e-6;
/// Greatest error of the distance between two chords, mm: each chord is within kSheetChordMm of its
/// curve.
constexpr double kDistanceSlackMm = 2.0 * kSheetChordMm;

/// A chord of the edge of a part, in the direction that has the material on the left.
struct EdgeChord {
  Place from{0.0, 0.0};
  Place to{0.0, 0.0};
  std::uint32_t part = 0;
  double kerf_mm = 0.0;
};

/// Result of the comparison of two chords: their distance, and the point where they are nearest.
struct Meeting {
  bool overlap = false;
  double distance_mm = 0.0;
  Place place{0.0, 0.0};
};

double side_of(const EdgeChord& chord, const Place& place) {
  return cross(chord.to - chord.from, place - chord.from);
}

bool cross_each_other(const EdgeChord& a, const EdgeChord& b) {
  return side_of(a, b.from) * side_of(a, b.to) < 0.0 && side_of(b, a.from) * side_of(b, a.to) < 0.0;
}

/// Returns whether two chords are on one line, have more than a point in common, and have material
/// on the same side.
bool share_edge(const EdgeChord& a, const EdgeChord& b) {
  const Place way = a.to - a.from;
  const double length = way.norm();
  if (length <= kOnLineMm || dot(way, b.to - b.from) <= 0.0) return false;
  if (std::abs(side_of(a, b.from)) > kOnLineMm * length) return false;
  if (std::abs(side_of(a, b.to)) > kOnLineMm * length) return false;
  const double begin = std::max(0.0, dot(b.from - a.from, way) / length);
  const double end = std::min(length, dot(b.to - a.from, way) / length);
  return end - begin > kOnLineMm;
}

/// Replaces `nearest` if `end` is nearer to `chord`. Unless two chords cross, an end of one of them
/// is among their nearest points.
void look_from(const Place& end, const EdgeChord& chord, Meeting& nearest) {
  const Place way = chord.to - chord.from;
  const double square = way.squaredNorm();
  const double share =
      square > 0.0 ? std::clamp(dot(end - chord.from, way) / square, 0.0, 1.0) : 0.0;
  const double apart = distance(end, chord.from + share * way);
  if (apart >= nearest.distance_mm) return;
  nearest.distance_mm = apart;
  nearest.place = end;
}

Meeting meeting_of(const EdgeChord& a, const EdgeChord& b) {
  Meeting nearest{.distance_mm = 1.0e300};
  if (cross_each_other(a, b)) {
    const Place way = a.to - a.from;
    const double share = side_of(b, a.from) / (side_of(b, a.from) - side_of(b, a.to));
    return {true, 0.0, a.from + share * way};
  }
  look_from(a.from, b, nearest);
  look_from(a.to, b, nearest);
  look_from(b.from, a, nearest);
  look_from(b.to, a, nearest);
  nearest.overlap = nearest.distance_mm <= kOnLineMm && share_edge(a, b);
  return nearest;
}

/// Finds the pairs of parts of one drawing that overlap, or that are nearer to each other than
/// their kerf.
class PairFinder {
 public:
  PairFinder(const Drawing& placed, std::span<const ContourUse> uses, std::size_t max_pairs)
      : placed_{placed}, uses_{uses}, max_pairs_{max_pairs} {
    for (std::size_t i = 0; i < placed.contours.size(); ++i) {
      if (uses[i].is_edge) add_chords(i);
    }
    build_tree();
  }

  std::vector<PartPair> find() {
    for (std::uint32_t i = 0; i < chords_.size() && pairs_.size() < max_pairs_; ++i) look_at(i);
    for (std::size_t i = 0; i < placed_.contours.size() && pairs_.size() < max_pairs_; ++i) {
      if (uses_[i].is_edge) look_for_cover(i);
    }
    std::vector<PartPair> pairs;
    for (const auto& [parts, pair] : pairs_) pairs.push_back(pair);
    return pairs;
  }

 private:
  using Box = cnc::contour::FlatBox<double>;
  using Key = std::pair<std::size_t, std::size_t>;

  /// Returns the number of contours that surround a contour and are edges of the same part as this
  /// contour.
  [[nodiscard]] std::size_t depth_of(std::size_t contour) const {
    std::size_t depth = 0;
    for (auto p = placed_.contours[contour].parent; p; p = placed_.contours[*p].parent) {
      if (uses_[*p].is_edge) ++depth;
    }
    return depth;
  }

  void add_chords(std::size_t contour) {
    const DrawnContour& drawn = placed_.contours[contour];
    std::vector<Place> places = drawing::outline_of(drawn.shapes, kSheetChordMm);
    const bool is_hole = depth_of(contour) % 2 == 1;
    if ((drawn.area_mm2 < 0.0) != is_hole) std::ranges::reverse(places);
    for (std::size_t i = 1; i < places.size(); ++i) {
      chords_.push_back({places[i - 1],
                         places[i],
                         static_cast<std::uint32_t>(drawn.entity.part),
                         uses_[contour].kerf_mm});
      kerf_mm_ = std::max(kerf_mm_, uses_[contour].kerf_mm);
    }
  }

  [[nodiscard]] static Box box_of(const EdgeChord& chord, double around) {
    const Place least = chord.from.cwiseMin(chord.to);
    const Place most = chord.from.cwiseMax(chord.to);
    return {least.x() - around, least.y() - around, most.x() + around, most.y() + around};
  }

  void build_tree() {
    boxes_.resize(cnc::contour::BoxTree<double>::size_for(chords_.size()));
    tree_ = cnc::contour::BoxTree<double>{{boxes_.data(), boxes_.size()}};
    for (std::uint32_t i = 0; i < chords_.size(); ++i) tree_.leaf(i) = box_of(chords_[i], 0.0);
    tree_.build(static_cast<std::uint32_t>(chords_.size()));
  }

  void look_at(std::uint32_t index) {
    const EdgeChord& chord = chords_[index];
    tree_.search(box_of(chord, kerf_mm_), index + 1, [&](std::uint32_t other) {
      if (chords_[other].part != chord.part) compare(chord, chords_[other]);
      return pairs_.size() < max_pairs_;
    });
  }

  void compare(const EdgeChord& a, const EdgeChord& b) {
    const Key key = std::minmax<std::size_t>(a.part, b.part);
    const auto known = pairs_.find(key);
    if (known != pairs_.end() && known->second.overlap) return;
    const Meeting meeting = meeting_of(a, b);
    const double kerf = std::max(a.kerf_mm, b.kerf_mm);
    if (!meeting.overlap && meeting.distance_mm >= kerf - kDistanceSlackMm) return;
    const bool is_worse =
        known == pairs_.end() || meeting.overlap || meeting.distance_mm < known->second.distance_mm;
    if (is_worse) pairs_[key] = {key, meeting.overlap, meeting.distance_mm, meeting.place};
  }

  /// Finds the parts whose material is under an outer edge, and records that the part of this edge
  /// overlaps them. The edge is on the material of a part if an odd number of that part's edges are
  /// around it.
  void look_for_cover(std::size_t contour) {
    const DrawnContour& drawn = placed_.contours[contour];
    if (depth_of(contour) != 0) return;
    std::map<std::size_t, std::size_t> edges;
    for (auto around = drawn.lies_in; around; around = placed_.contours[*around].lies_in) {
      if (uses_[*around].is_edge) ++edges[placed_.contours[*around].entity.part];
    }
    for (const auto& [part, count] : edges) {
      if (part == drawn.entity.part || count % 2 == 0) continue;
      const Key key = std::minmax(part, drawn.entity.part);
      const auto known = pairs_.find(key);
      if (known != pairs_.end() && known->second.overlap) continue;
      pairs_[key] = {key, true, 0.0, start_of(drawn.shapes.front())};
    }
  }

  const Drawing& placed_;
  std::span<const ContourUse> uses_;
  std::size_t max_pairs_;
  std::vector<EdgeChord> chords_;
  double kerf_mm_ = 0.0;
  std::vector<Box> boxes_;
  cnc::contour::BoxTree<double> tree_{cnc::contour::Slice<Box>{}};
  std::map<Key, PartPair> pairs_;
};

}  // namespace

std::vector<PartPair> near_parts(const Drawing& placed,
                                 std::span<const ContourUse> uses,
                                 std::size_t max_pairs) {
  return PairFinder{placed, uses, max_pairs}.find();
}

}  // namespace sim::sheet
