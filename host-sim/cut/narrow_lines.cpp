#include "host-sim/cut/narrow_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "host-sim/contour/polyline_arcs.hpp"
#include "host-sim/cut/shared_edges.hpp"
#include "host-sim/import/piece_sets.hpp"
#include "host-sim/pocket/medial_axis.hpp"
#include "host-sim/pocket/owned_area.hpp"

namespace sim::cut {
namespace {

using pocket::AxisChain;
using pocket::AxisPoint;
using pocket::MedialAxis;

/// Tolerance of the lines along the middle, as a share of half the kerf.
constexpr double kMiddleTolerance = 5.0e-3;
constexpr double kSamePlaceMm = 1.0e-6;
constexpr double kNoMore = 1.0e-6;  ///< Tolerance for rounding at a limit, mm.
/// Distance by which two paths may be nearer to each other than required, as a share of half the
/// kerf.
constexpr double kWideEnough = 1.0e-3;
/// Maximum decrease of the radius along a stretch, mm per mm of its length. A stretch whose end
/// narrows faster is a corner and has no line.
constexpr double kSteepest = 0.5;
/// Half the length of a line that replaces a point, as a share of half the kerf.
constexpr double kDot = 0.25;

/// The kind of point at which a stretch ends.
enum class NarrowEnd : std::uint8_t {
  kPath,   ///< A point from which on the waste is wider, so that a path of the beam begins there.
  kLimit,  ///< A point beyond which a cut would take too much off the edges.
  kNode,   ///< A node of the medial axis.
};

struct End {
  NarrowEnd kind = NarrowEnd::kNode;
  std::uint32_t node = 0;  ///< Number of the node, if a node is the end.
};

/// A stretch of the medial axis along which the waste is narrower than the kerf. It is part of a
/// chain.
struct Narrow {
  std::vector<AxisPoint> points{};
  End from{};
  End to{};
};

void turn_round(Narrow& narrow) {
  std::ranges::reverse(narrow.points);
  std::swap(narrow.from, narrow.to);
}

double length_of(const std::vector<AxisPoint>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += drawing::distance(points[i - 1].place, points[i].place);
  }
  return length;
}

/// Removes a piece of the given length from the end of a line of points.
void shorten(std::vector<AxisPoint>& points, double length) {
  while (points.size() > 1) {
    const AxisPoint& last = points.back();
    const AxisPoint& before = points[points.size() - 2];
    const double step = drawing::distance(before.place, last.place);
    if (step > length) {
      const double share = length / step;
      const AxisPoint end{last.place + share * (before.place - last.place),
                          last.radius + share * (before.radius - last.radius)};
      points.back() = end;
      return;
    }
    length -= step;
    points.pop_back();
  }
}

/// Returns the points of a chain. Inserts the points between them at which the radius equals
/// `least` or `most`.
std::vector<AxisPoint> with_limits(const AxisChain& chain, double least, double most) {
  std::vector<AxisPoint> points{chain.points.front()};
  for (std::size_t i = 1; i < chain.points.size(); ++i) {
    const AxisPoint from = chain.points[i - 1];
    const AxisPoint& to = chain.points[i];
    std::array<double, 2> limits{least, most};
    if (to.radius < from.radius) std::ranges::reverse(limits);
    for (const double limit : limits) {
      if ((from.radius < limit) == (to.radius < limit)) continue;
      const double share = (limit - from.radius) / (to.radius - from.radius);
      points.push_back({from.place + share * (to.place - from.place), limit});
    }
    points.push_back(to);
  }
  return points;
}

/// Finds the narrow stretches of a medial axis and joins them to lines.
class NarrowFinder {
 public:
  NarrowFinder(const MedialAxis& axis,
               double half_kerf_mm,
               double max_off_mm,
               const std::function<bool(const Place&, double)>& is_other_near)
      : axis_{axis},
        is_other_near_{is_other_near},
        half_{half_kerf_mm},
        min_{std::max(half_kerf_mm - max_off_mm - kNoMore, 0.0)},
        max_{half_kerf_mm * (1.0 - kWideEnough)},
        degrees_(axis.nodes.size()),
        sets_{axis.nodes.size()},
        has_path_(axis.nodes.size()) {}

  NarrowLines find() {
    for (const AxisChain& chain : axis_.chains) divide(chain);
    note_sets();
    drop_corners();
    join();
    add_points();
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool is_narrow(double radius) const { return radius >= min_ && radius < max_; }

  void divide(const AxisChain& chain);
  void note_sets();
  void drop_corners();
  void join();
  void lengthen(Narrow& line, std::vector<bool>& is_used) const;
  [[nodiscard]] bool is_free(const End& end) const {
    return end.kind != NarrowEnd::kPath &&
           !(end.kind == NarrowEnd::kNode && degrees_[end.node] > 1);
  }
  [[nodiscard]] bool is_corner(const Narrow& narrow) const;
  [[nodiscard]] bool is_cut_from_ends(const Narrow& line) const;
  [[nodiscard]] bool ends_at_other_waste(const Narrow& line) const;
  void add(Narrow line);
  void add_points();
  void add_point(const AxisPoint& point);
  void note(const std::vector<AxisPoint>& points);

  const MedialAxis& axis_;
  const std::function<bool(const Place&, double)>& is_other_near_;
  double half_;
  double min_;  ///< Minimum radius of the waste, mm, for which there is a line.
  double max_;  ///< Radius of the waste, mm, from which on there is no line.
  std::vector<Narrow> narrows_{};
  std::vector<std::uint32_t> degrees_;  ///< Number of ends of narrow stretches at each node.
  drawing::PieceSets sets_;             ///< Sets of nodes that narrow stretches connect.
  /// Whether a path leads to a set. The index is the first node of the set.
  std::vector<bool> has_path_;
  /// Whether a line goes through a set. The index is the first node of the set.
  std::vector<bool> is_cut_{};
  /// For each node, the stretches that end there. The flag is true if the node is at the last point
  /// of the stretch.
  std::vector<std::vector<std::pair<std::size_t, bool>>> ends_at_{};
  NarrowLines found_{};
};

/// Divides a chain into the stretches along which the waste is narrow.
void NarrowFinder::divide(const AxisChain& chain) {
  const std::vector<AxisPoint> points = with_limits(chain, min_, max_);
  const auto end_at = [&](std::size_t i) -> End {
    if (i == 0) return {NarrowEnd::kNode, chain.from};
    if (i + 1 == points.size()) return {NarrowEnd::kNode, chain.to};
    const bool is_path = max_ - points[i].radius < points[i].radius - min_;
    return {is_path ? NarrowEnd::kPath : NarrowEnd::kLimit};
  };
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= points.size(); ++i) {
    if (i < points.size() && is_narrow(0.5 * (points[i - 1].radius + points[i].radius))) continue;
    if (i - begin > 1) {
      const auto first = points.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto last = points.begin() + static_cast<std::ptrdiff_t>(i);
      narrows_.push_back({.points = {first, last}, .from = end_at(begin), .to = end_at(i - 1)});
    }
    begin = i;
  }
}

/// Determines the sets of connected nodes, and marks the sets to which a path leads.
void NarrowFinder::note_sets() {
  for (const Narrow& narrow : narrows_) {
    for (const End& end : {narrow.from, narrow.to}) {
      if (end.kind == NarrowEnd::kNode) ++degrees_[end.node];
    }
    if (narrow.from.kind == NarrowEnd::kNode && narrow.to.kind == NarrowEnd::kNode) {
      sets_.unite(narrow.from.node, narrow.to.node);
    }
  }
  is_cut_.assign(axis_.nodes.size(), false);
  for (const Narrow& narrow : narrows_) {
    for (const auto& [end, other] : {std::pair{narrow.from, narrow.to}, {narrow.to, narrow.from}}) {
      if (end.kind != NarrowEnd::kNode || other.kind != NarrowEnd::kPath) continue;
      has_path_[sets_.find(end.node)] = true;
    }
  }
}

/// Returns whether a stretch only leads into a corner. It then needs no line, because the beam
/// already reaches as far into the corner as it can.
bool NarrowFinder::is_corner(const Narrow& narrow) const {
  const bool ends_free = is_free(narrow.to);
  if (is_free(narrow.from) == ends_free) return false;
  const double fall = narrow.points.front().radius - narrow.points.back().radius;
  return (ends_free ? fall : -fall) > kSteepest * length_of(narrow.points);
}

void NarrowFinder::drop_corners() {
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    std::vector<Narrow> kept;
    // In one pass, all stretches are checked before any is dropped. If dropping a stretch gives
    // another stretch a free end, this other stretch is checked in the next pass.
    std::vector<bool> goes;
    for (const Narrow& narrow : narrows_) goes.push_back(is_corner(narrow));
    for (std::size_t i = 0; i < narrows_.size(); ++i) {
      if (!goes[i]) {
        kept.push_back(std::move(narrows_[i]));
        continue;
      }
      is_changed = true;
      for (const End& end : {narrows_[i].from, narrows_[i].to}) {
        if (end.kind == NarrowEnd::kNode) --degrees_[end.node];
      }
    }
    narrows_ = std::move(kept);
  }
}

/// Joins stretches into lines where they meet at nodes. At a node, a line continues as straight as
/// possible.
void NarrowFinder::join() {
  ends_at_.assign(axis_.nodes.size(), {});
  for (std::size_t i = 0; i < narrows_.size(); ++i) {
    for (const bool is_last : {false, true}) {
      const End& end = is_last ? narrows_[i].to : narrows_[i].from;
      if (end.kind == NarrowEnd::kNode) ends_at_[end.node].push_back({i, is_last});
    }
  }
  std::vector<bool> is_used(narrows_.size());
  for (std::size_t i = 0; i < narrows_.size(); ++i) {
    if (is_used[i]) continue;
    is_used[i] = true;
    Narrow line = narrows_[i];
    for (int side = 0; side < 2; ++side) {
      lengthen(line, is_used);
      turn_round(line);
    }
    add(std::move(line));
  }
}

void NarrowFinder::lengthen(Narrow& line, std::vector<bool>& is_used) const {
  while (line.to.kind == NarrowEnd::kNode) {
    const Place way = line.points.back().place - line.points[line.points.size() - 2].place;
    std::optional<Narrow> next;
    std::size_t number = 0;
    double straightest = -0.5;
    for (const auto& [i, is_last] : ends_at_[line.to.node]) {
      if (is_used[i]) continue;
      Narrow more = narrows_[i];
      if (is_last) turn_round(more);
      const Place on = more.points[1].place - more.points[0].place;
      const double straight = drawing::dot(way.normalized(), on.normalized());
      if (straight <= straightest) continue;
      straightest = straight;
      number = i;
      next = std::move(more);
    }
    if (!next) return;
    is_used[number] = true;
    line.points.insert(line.points.end(), next->points.begin() + 1, next->points.end());
    line.to = next->to;
  }
}

/// Returns whether the cuts that begin at both ends of a line cover the line, so that it is
/// unnecessary.
bool NarrowFinder::is_cut_from_ends(const Narrow& line) const {
  if (line.from.kind != NarrowEnd::kPath || line.to.kind != NarrowEnd::kPath) return false;
  const double widest = std::ranges::max_element(line.points, {}, &AxisPoint::radius)->radius;
  return std::hypot(widest, 0.5 * length_of(line.points)) <= half_;
}

/// Returns whether a line ends where its waste lies against other waste.
bool NarrowFinder::ends_at_other_waste(const Narrow& line) const {
  const AxisPoint& end = line.points.back();
  return is_other_near_ && is_other_near_(end.place, end.radius + kTouchesMm);
}

/// Adds a line. An end at which neither another line continues nor other waste begins is shortened
/// by the reach of the beam.
void NarrowFinder::add(Narrow line) {
  if (is_cut_from_ends(line)) return;
  const AxisPoint widest = *std::ranges::max_element(line.points, {}, &AxisPoint::radius);
  const End& known = line.from.kind == NarrowEnd::kNode ? line.from : line.to;
  const bool leads_to_path = line.from.kind == NarrowEnd::kPath ||
                             line.to.kind == NarrowEnd::kPath ||
                             (known.kind == NarrowEnd::kNode && has_path_[sets_.find(known.node)]);
  for (int side = 0; side < 2; ++side) {
    if (line.to.kind == NarrowEnd::kNode && is_free(line.to) && !ends_at_other_waste(line)) {
      shorten(line.points, half_ - line.points.back().radius);
    }
    turn_round(line);
  }
  if (known.kind == NarrowEnd::kNode) is_cut_[sets_.find(known.node)] = true;
  if (line.points.size() < 2 || length_of(line.points) < kDot * half_) {
    if (!leads_to_path) add_point(widest);
    return;
  }
  note(line.points);
  std::vector<Place> places{line.points.front().place};
  for (const AxisPoint& point : line.points) {
    if (drawing::distance(places.back(), point.place) > kSamePlaceMm) places.push_back(point.place);
  }
  if (places.size() < 2) return;
  const std::vector<ContourVertex> elements = arcs_along(places, kMiddleTolerance * half_);
  std::vector<Stroke>& row = found_.rows.emplace_back();
  for (std::size_t i = 1; i < elements.size(); ++i) {
    const ContourVertex& from = elements[i - 1];
    row.push_back({{from.x, from.y}, {elements[i].x, elements[i].y}, from.bulge});
  }
}

/// Adds a short line for each piece of narrow waste that contains no line and is connected to no
/// path.
void NarrowFinder::add_points() {
  std::vector<std::optional<AxisPoint>> widest(axis_.nodes.size());
  for (std::uint32_t i = 0; i < axis_.nodes.size(); ++i) {
    const AxisPoint& node = axis_.nodes[i];
    std::optional<AxisPoint>& known = widest[sets_.find(i)];
    if (!known || node.radius > known->radius) known = node;
  }
  for (std::uint32_t i = 0; i < widest.size(); ++i) {
    if (!widest[i] || has_path_[i] || is_cut_[i]) continue;
    if (is_narrow(widest[i]->radius)) add_point(*widest[i]);
  }
}

/// Adds a short line in place of a point, because the beam may be off at rest.
void NarrowFinder::add_point(const AxisPoint& point) {
  const Place reach{kDot * half_, 0.0};
  note({point});
  found_.rows.push_back({{point.place - reach, point.place + reach}});
}

void NarrowFinder::note(const std::vector<AxisPoint>& points) {
  found_.length_mm += length_of(points);
  for (const AxisPoint& point : points) {
    if (half_ - point.radius <= found_.max_off_mm) continue;
    found_.max_off_mm = half_ - point.radius;
    found_.place = point.place;
  }
}

}  // namespace

NarrowLines narrow_lines(const cnc::contour::ContourView<double>& waste,
                         double half_kerf_mm,
                         double max_off_mm,
                         const std::function<bool(const Place&, double)>& is_other_near) {
  const pocket::OwnedArea owned{waste};
  const double tolerance_mm = kMiddleTolerance * half_kerf_mm;
  const MedialAxis axis =
      pocket::medial_axis(owned, {.tolerance_mm = tolerance_mm, .slack_mm = tolerance_mm});
  return NarrowFinder{axis, half_kerf_mm, max_off_mm, is_other_near}.find();
}

}  // namespace sim::cut
