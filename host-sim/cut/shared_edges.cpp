#include "host-sim/cut/shared_edges.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/segment_distance.hpp"
#include "host-sim/cut/shared_stretch.hpp"

namespace sim::cut {
namespace {

/// Greatest distance between ends of lines that count as one node, mm. Gaps between lines, and
/// lines themselves, of at most this length are ignored.
constexpr double kSameNode = 2.0 * kTouchesMm;

/// Two outlines, given by their positions in the list of contours.
using Pair = std::pair<std::size_t, std::size_t>;

/// Finds the lines and points that outlines share.
class EdgeFinder {
 public:
  EdgeFinder(const std::vector<Outline>& outlines,
             const std::vector<std::size_t>& contours,
             const std::function<bool(std::size_t, std::size_t)>& may_share)
      : contours_{contours}, may_share_{may_share}, strokes_{kTouchReachMm} {
    for (const std::size_t contour : contours) rows_.emplace_back(outlines[contour].strokes);
  }

  SharedEdges find() {
    note_strokes();
    for (std::size_t i = 0; i < rows_.size(); ++i) note_stretches(i);
    for (auto& [pair, stretches] : stretches_) {
      join(stretches, rows_[pair.first].length());
    }
    for (const auto& [pair, stretches] : stretches_) {
      if (pair.first > pair.second) continue;
      for (const SharedStretch& stretch : stretches) add(pair, stretch);
    }
    note_taken();
    for (std::size_t i = 0; i < rows_.size(); ++i) add_points(i);
    return std::move(found_);
  }

 private:
  static constexpr double kTouchReachMm = 1.0;

  struct OwnedStroke {
    std::size_t row = 0;
    Stroke stroke{};
  };

  void note_strokes() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      for (const Stroke& stroke : rows_[i].strokes()) {
        strokes_.add(stroke, owned_.size());
        owned_.push_back({i, stroke});
      }
    }
    strokes_.prepare();
  }
  void note_stretches(std::size_t i);
  static void join(std::vector<SharedStretch>& stretches, double length_mm);
  void add(const Pair& pair, const SharedStretch& stretch);
  [[nodiscard]] std::vector<Stroke> strokes_along(std::size_t i,
                                                  const SharedStretch& stretch) const;
  [[nodiscard]] bool is_whole(std::size_t i, const SharedStretch& stretch) const {
    return stretch.to_mm - stretch.from_mm > rows_[i].length() - kSameNode;
  }
  [[nodiscard]] std::optional<SharedStretch> other_side(const Pair& pair,
                                                        const SharedStretch& stretch) const;
  [[nodiscard]] std::size_t node_at(const Place& place);
  void note_taken();
  [[nodiscard]] bool is_taken(std::size_t i, double way_mm) const;
  void add_points(std::size_t i);
  void add_point(std::size_t i, double way_mm, std::size_t other, const Place& place);

  const std::vector<std::size_t>& contours_;
  const std::function<bool(std::size_t, std::size_t)>& may_share_;
  std::vector<MeasuredRow> rows_;
  Clearance strokes_;
  std::vector<OwnedStroke> owned_;
  /// For each pair, the stretches of the first outline along the second one.
  std::map<Pair, std::vector<SharedStretch>> stretches_;
  /// For each outline, its stretches that belong to lines or points.
  std::vector<std::vector<EdgeStretch>> taken_;
  SharedEdges found_;
};

void EdgeFinder::note_stretches(std::size_t i) {
  for (std::size_t k = 0; k < rows_[i].strokes().size(); ++k) {
    const Stroke& stroke = rows_[i].strokes()[k];
    for (const std::size_t number : strokes_.owners_near(stroke, kTouchesMm)) {
      const OwnedStroke& other = owned_[number];
      if (other.row == i || !may_share_(contours_[i], contours_[other.row])) continue;
      auto shared = shared_stretch(stroke, other.stroke, kTouchesMm);
      if (!shared) continue;
      shared->from_mm += rows_[i].way_to(k);
      shared->to_mm += rows_[i].way_to(k);
      stretches_[{i, other.row}].push_back(*shared);
    }
  }
}

/// Joins stretches across corners and across the start of the outline, and removes short ones.
void EdgeFinder::join(std::vector<SharedStretch>& stretches, double length_mm) {
  std::ranges::sort(stretches, {}, &SharedStretch::from_mm);
  std::vector<SharedStretch> joined;
  for (const SharedStretch& next : stretches) {
    if (joined.empty() || next.from_mm > joined.back().to_mm + kSameNode) {
      joined.push_back(next);
    } else {
      joined.back().to_mm = std::max(joined.back().to_mm, next.to_mm);
    }
  }
  if (joined.size() > 1 && joined.front().from_mm + length_mm < joined.back().to_mm + kSameNode) {
    joined.back().to_mm = length_mm + joined.front().to_mm;
    joined.erase(joined.begin());
  }
  std::erase_if(joined, [](const SharedStretch& stretch) {
    return stretch.to_mm - stretch.from_mm <= kSameNode;
  });
  stretches = std::move(joined);
}

std::vector<Stroke> EdgeFinder::strokes_along(std::size_t i, const SharedStretch& stretch) const {
  const MeasuredRow& row = rows_[i];
  if (is_whole(i, stretch)) return row.strokes();
  std::vector<Stroke> strokes = row.stretch(stretch.from_mm, std::min(stretch.to_mm, row.length()));
  if (stretch.to_mm > row.length()) {
    const std::vector<Stroke> more = row.stretch(0.0, stretch.to_mm - row.length());
    strokes.insert(strokes.end(), more.begin(), more.end());
  }
  return strokes;
}

/// Returns the stretch of the second outline that lies along a stretch of the first outline;
/// nothing if there is none.
std::optional<SharedStretch> EdgeFinder::other_side(const Pair& pair,
                                                    const SharedStretch& stretch) const {
  const auto known = stretches_.find({pair.second, pair.first});
  if (known == stretches_.end()) return std::nullopt;
  const auto place = [](const MeasuredRow& row, double way_mm) {
    return row.place(way_mm > row.length() ? way_mm - row.length() : way_mm);
  };
  const MeasuredRow& row = rows_[pair.first];
  const MeasuredRow& other = rows_[pair.second];
  const bool is_ring = is_whole(pair.first, stretch);
  for (const SharedStretch& beside : known->second) {
    if (is_ring != is_whole(pair.second, beside)) continue;
    if (is_ring) return beside;
    const bool ends_there = drawing::distance(place(row, stretch.from_mm),
                                              place(other, beside.to_mm)) <= 2.0 * kSameNode &&
                            drawing::distance(place(row, stretch.to_mm),
                                              place(other, beside.from_mm)) <= 2.0 * kSameNode;
    if (ends_there) return beside;
  }
  return std::nullopt;
}

std::size_t EdgeFinder::node_at(const Place& place) {
  for (std::size_t i = 0; i < found_.nodes.size(); ++i) {
    if (drawing::distance(found_.nodes[i], place) <= kSameNode) return i;
  }
  found_.nodes.push_back(place);
  return found_.nodes.size() - 1;
}

void EdgeFinder::add(const Pair& pair, const SharedStretch& stretch) {
  const auto other = other_side(pair, stretch);
  if (!other) return;
  SharedEdge edge{.strokes = strokes_along(pair.first, stretch)};
  const auto along = [this](std::size_t i, const SharedStretch& one) {
    return EdgeStretch{contours_[i], one.from_mm, std::fmod(one.to_mm, rows_[i].length())};
  };
  edge.beside = {along(pair.first, stretch), along(pair.second, *other)};
  edge.is_ring = is_whole(pair.first, stretch);
  edge.nodes[0] = node_at(edge.strokes.front().from);
  edge.nodes[1] = edge.is_ring ? edge.nodes[0] : node_at(edge.strokes.back().to);
  if (!edge.is_ring && edge.nodes[0] == edge.nodes[1]) return;
  edge.strokes.front().from = found_.nodes[edge.nodes[0]];
  edge.strokes.back().to = found_.nodes[edge.nodes[1]];
  found_.edges.push_back(std::move(edge));
}

void EdgeFinder::note_taken() {
  taken_.resize(rows_.size());
  for (const SharedEdge& edge : found_.edges) {
    for (const EdgeStretch& beside : edge.beside) {
      const auto i = static_cast<std::size_t>(std::ranges::find(contours_, beside.contour) -
                                              contours_.begin());
      taken_[i].push_back(beside);
      if (edge.is_ring) taken_[i].back().to_mm = beside.from_mm + rows_[i].length();
    }
  }
}

/// Returns whether an outline has a shared line or point at or near a distance along it.
bool EdgeFinder::is_taken(std::size_t i, double way_mm) const {
  const double length = rows_[i].length();
  return std::ranges::any_of(taken_[i], [&](const EdgeStretch& one) {
    const double from = one.from_mm - 2.0 * kSameNode;
    double to = one.to_mm + 2.0 * kSameNode;
    if (to < from) to += length;
    return std::fmod(way_mm - from + 2.0 * length, length) <= to - from;
  });
}

/// Adds a point for each corner of an outline that touches another outline.
void EdgeFinder::add_points(std::size_t i) {
  for (std::size_t k = 0; k < rows_[i].strokes().size(); ++k) {
    const Place& corner = rows_[i].strokes()[k].from;
    for (const std::size_t number : strokes_.owners_near({corner, corner}, kTouchesMm)) {
      const OwnedStroke& other = owned_[number];
      if (other.row == i || !may_share_(contours_[i], contours_[other.row])) continue;
      if (distance_to(other.stroke, corner) > kTouchesMm) continue;
      add_point(i, rows_[i].way_to(k), other.row, corner);
    }
  }
}

void EdgeFinder::add_point(std::size_t i, double way_mm, std::size_t other, const Place& place) {
  const MeasuredRow& row = rows_[other];
  double beside_mm = 0.0;
  double nearest = 2.0 * kTouchesMm;
  for (std::size_t k = 0; k < row.strokes().size(); ++k) {
    const Stroke& stroke = row.strokes()[k];
    const double apart = distance_to(stroke, place);
    if (apart >= nearest) continue;
    nearest = apart;
    beside_mm = row.way_to(k) + nearest_share(stroke, place) * length_of(stroke);
  }
  // A corner next to the point counts as the point. Otherwise, the outline would leave the point by
  // a crumb of an edge, in whose direction there is no waste.
  for (std::size_t k = 0; k < row.strokes().size(); ++k) {
    if (std::abs(row.way_to(k) - beside_mm) <= kSameNode) beside_mm = row.way_to(k);
  }
  if (beside_mm > row.length() - kSameNode) beside_mm = 0.0;
  if (is_taken(i, way_mm) || is_taken(other, beside_mm)) return;
  const std::size_t node = node_at(place);
  const EdgeStretch own{contours_[i], way_mm, way_mm};
  const EdgeStretch beside{contours_[other], beside_mm, beside_mm};
  taken_[i].push_back(own);
  taken_[other].push_back(beside);
  found_.edges.push_back({.beside = {own, beside}, .nodes = {node, node}});
}

}  // namespace

SharedEdges shared_edges(const std::vector<Outline>& outlines,
                         const std::vector<std::size_t>& contours,
                         const std::function<bool(std::size_t, std::size_t)>& may_share) {
  return EdgeFinder{outlines, contours, may_share}.find();
}

}  // namespace sim::cut
