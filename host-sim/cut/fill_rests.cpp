#include "host-sim/cut/fill_rests.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "host-sim/pocket/medial_axis.hpp"
#include "host-sim/pocket/owned_area.hpp"

namespace sim::cut {
namespace {

using pocket::AxisChain;
using pocket::AxisPoint;
using pocket::MedialAxis;

/// Tolerance of the medial axis, as a share of the interval.
constexpr double kAxisTolerance = 0.02;
/// Least length of a thin part that is reported, in intervals. Shorter parts are corners of the
/// area.
constexpr double kMinThin = 2.0;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// The kind of point at which a stretch ends.
enum class EndKind : std::uint8_t {
  kRow,   ///< A corner of the row at the level of the stretch.
  kTip,   ///< A point that the next row outside still covers.
  kNode,  ///< A node of the axis at which several stretches meet.
  kLeaf,  ///< A node of the axis at which only this stretch ends.
};

struct StretchEnd {
  EndKind kind = EndKind::kTip;
  std::uint32_t node = 0;  ///< Number of the node, if a node is the end.
};

/// A part of a chain of the axis within one band of radii. The limits of a band are the radius at a
/// row and the radius in the middle between two rows.
struct Stretch {
  std::vector<AxisPoint> points{};
  std::vector<double> ways{};  ///< Distance along the stretch to each point, mm.
  std::size_t band = 0;        ///< All radii are at least this number of half intervals.
  StretchEnd from{};
  StretchEnd to{};

  [[nodiscard]] double length() const { return ways.back(); }
  [[nodiscard]] AxisPoint at(double way) const {
    const auto next = std::upper_bound(ways.begin() + 1, ways.end() - 1, way);
    const auto i = static_cast<std::size_t>(next - ways.begin());
    const double size = ways[i] - ways[i - 1];
    const double share = size > 0.0 ? std::clamp((way - ways[i - 1]) / size, 0.0, 1.0) : 0.0;
    return {points[i - 1].place + share * (points[i].place - points[i - 1].place),
            points[i - 1].radius + share * (points[i].radius - points[i - 1].radius)};
  }
};

/// A line along the axis that covers a gap, with the nodes at its ends, if there are any.
struct Ridge {
  FillRest rest{};
  std::vector<std::uint32_t> nodes{};
};

class RestFinder {
 public:
  RestFinder(const MedialAxis& axis, double interval_mm)
      : axis_{axis}, interval_{interval_mm}, half_{0.5 * interval_mm}, degrees_(axis.nodes.size()) {
    for (const AxisChain& chain : axis.chains) {
      ++degrees_[chain.from];
      ++degrees_[chain.to];
    }
  }

  FillRests find() {
    for (const AxisChain& chain : axis_.chains) divide(chain);
    for (std::uint32_t i = 0; i < degrees_.size(); ++i) {
      if (degrees_[i] == 0) take_round(axis_.nodes[i]);
    }
    for (const auto& [node, level] : dots_) {
      if (!ends_at(node)) add_dot(axis_.nodes[node].place, level);
    }
    join_ridges();
    return std::move(rests_);
  }

 private:
  /// Returns the number of the band of a radius: the number of whole half intervals in the radius.
  /// If a radius exceeds a limit by no more than rounding, kMinRowWidth of the interval, it belongs
  /// to the band below the limit.
  [[nodiscard]] std::size_t band_of(double radius) const {
    return static_cast<std::size_t>(std::max(radius - kMinRowWidth * interval_, 0.0) / half_);
  }
  [[nodiscard]] double beyond(const Stretch& stretch, const AxisPoint& point) const {
    return point.radius - half_ * static_cast<double>(stretch.band);
  }

  /// Divides a chain of the axis at rows and in the middle between rows.
  void divide(const AxisChain& chain) {
    Stretch stretch{.points = {chain.points.front()}, .ways = {0.0}};
    stretch.from = end_at(chain.from);
    bool is_begun = false;
    const auto go_to = [&](const AxisPoint& to) {
      const AxisPoint& from = stretch.points.back();
      const std::size_t band = band_of(0.5 * (from.radius + to.radius));
      if (is_begun && band != stretch.band) {
        const AxisPoint begin = from;
        const bool rises = band > stretch.band;
        // The last point ends this stretch and begins the next one. It is at the upper limit of the
        // lower of the two bands.
        stretch.to.kind = kind_of_limit(stretch.band, rises);
        take(std::exchange(stretch, {.points = {begin}, .ways = {0.0}}));
        stretch.from.kind = kind_of_limit(band, !rises);
      }
      is_begun = true;
      stretch.band = band;
      const double step = drawing::distance(stretch.points.back().place, to.place);
      stretch.ways.push_back(stretch.ways.back() + step);
      stretch.points.push_back(to);
    };
    for (std::size_t i = 1; i < chain.points.size(); ++i) {
      go_through(chain.points[i - 1], chain.points[i], go_to);
    }
    stretch.to = end_at(chain.to);
    take(std::move(stretch));
  }

  [[nodiscard]] StretchEnd end_at(std::uint32_t node) const {
    return {degrees_[node] == 1 ? EndKind::kLeaf : EndKind::kNode, node};
  }
  /// Returns the kind of end at a limit of a band. Odd bands have a row at their lower limit, even
  /// bands at their upper limit.
  [[nodiscard]] static EndKind kind_of_limit(std::size_t band, bool is_upper) {
    return (band % 2 == 0) == is_upper ? EndKind::kRow : EndKind::kTip;
  }

  /// Visits the points between `from` and `to` at which the radius is a whole number of half
  /// intervals, then `to`.
  template <typename GoTo>
  void go_through(const AxisPoint& from, const AxisPoint& to, const GoTo& go_to) const {
    const double slack = kMinRowWidth * interval_;
    const double least = (std::min(from.radius, to.radius) - slack) / half_;
    const double most = (std::max(from.radius, to.radius) - slack) / half_;
    const double first = std::floor(least) + 1.0;
    const double count = std::ceil(most) - first;
    for (double i = 0.0; i < count; i += 1.0) {
      const double number = to.radius > from.radius ? first + i : first + count - 1.0 - i;
      const double radius = half_ * number + slack;
      const double share = (radius - from.radius) / (to.radius - from.radius);
      go_to(AxisPoint{from.place + share * (to.place - from.place), radius});
    }
    go_to(to);
  }

  void take(Stretch stretch) {
    if (stretch.points.size() < 2) return;
    if (stretch.band == 0) return take_thin(stretch.length(), stretch.points.front().place);
    if (stretch.band % 2 == 0 && is_left(stretch)) cover(stretch);
  }

  void take_thin(double length, const Place& place) {
    if (length <= kMinThin * interval_) return;
    ThinParts& thin = rests_.thin;
    ++thin.count;
    thin.length_mm += length;
    if (length <= thin.longest_mm) return;
    thin.longest_mm = length;
    thin.place = place;
  }

  /// Returns whether a stretch has a point that rows do not cover.
  [[nodiscard]] bool is_left(const Stretch& stretch) const {
    const double reach = half_ + kFillSlack * interval_;
    const double length = stretch.length();
    const double from = stretch.from.kind == EndKind::kRow ? reach : -kNever;
    const double to = stretch.to.kind == EndKind::kRow ? length - reach : kNever;
    const auto is_far = [&](double way) {
      return way >= from && way <= to && beyond(stretch, stretch.at(way)) > kFillSlack * interval_;
    };
    return is_far(std::max(from, 0.0)) || is_far(std::min(to, length)) ||
           std::ranges::any_of(stretch.ways, is_far);
  }

  /// Adds a line along a stretch. The line is shorter than the stretch where an end is covered
  /// without it.
  void cover(const Stretch& stretch) {
    const auto spared = [&](const StretchEnd& end, const AxisPoint& point) {
      if (end.kind == EndKind::kTip) return half_;
      return end.kind == EndKind::kLeaf ? std::max(half_ - beyond(stretch, point), 0.0) : 0.0;
    };
    const auto top = std::ranges::max_element(stretch.points, {}, &AxisPoint::radius);
    const auto number = static_cast<std::size_t>(top - stretch.points.begin());
    const double top_way = stretch.ways[number];
    const double low = std::min(spared(stretch.from, stretch.points.front()), top_way);
    const double high =
        std::max(stretch.length() - spared(stretch.to, stretch.points.back()), top_way);
    const std::size_t level = stretch.band / 2;
    if (high - low < 0.01 * interval_) {
      if (number == 0) return cover_end(stretch.from, *top, level);
      if (number + 1 == stretch.points.size()) return cover_end(stretch.to, *top, level);
      return add_dot(top->place, level);
    }
    Ridge ridge{.rest = {.level = level}};
    ridge.rest.places.push_back(stretch.at(low).place);
    for (std::size_t i = 0; i < stretch.points.size(); ++i) {
      if (stretch.ways[i] <= low || stretch.ways[i] >= high) continue;
      ridge.rest.places.push_back(stretch.points[i].place);
    }
    ridge.rest.places.push_back(stretch.at(high).place);
    add(stretch, std::move(ridge));
  }

  void cover_end(const StretchEnd& end, const AxisPoint& point, std::size_t level) {
    if (end.kind == EndKind::kNode) dots_.insert({end.node, level});
    if (end.kind == EndKind::kLeaf || end.kind == EndKind::kTip) add_dot(point.place, level);
  }

  void add(const Stretch& stretch, Ridge ridge) {
    const bool from_row = stretch.from.kind == EndKind::kRow;
    const bool to_row = stretch.to.kind == EndKind::kRow;
    ridge.rest.is_spur = from_row != to_row;
    if (to_row && !from_row) std::ranges::reverse(ridge.rest.places);
    for (const StretchEnd& end : {stretch.from, stretch.to}) {
      if (end.kind == EndKind::kNode) nodes_.insert(end.node);
    }
    if (ridge.rest.is_spur) return rests_.lines.push_back(std::move(ridge.rest));
    const auto node = [](const StretchEnd& end) {
      return end.kind == EndKind::kNode ? end.node : UINT32_MAX;
    };
    ridge.nodes = {node(stretch.from), node(stretch.to)};
    ridges_.push_back(std::move(ridge));
  }

  /// Adds a short line in place of a point, because the beam may be off at rest.
  void add_dot(const Place& place, std::size_t level) {
    const Place reach{0.5 * half_, 0.0};
    rests_.lines.push_back({.places = {place - reach, place + reach}, .level = level});
  }

  void take_round(const AxisPoint& node) {
    const std::size_t band = band_of(node.radius);
    if (band == 0) return take_thin(kMinThin * interval_ + node.radius, node.place);
    const double beyond = node.radius - half_ * static_cast<double>(band);
    if (band % 2 == 0 && beyond > kFillSlack * interval_) add_dot(node.place, band / 2);
  }

  [[nodiscard]] bool ends_at(std::uint32_t node) const { return nodes_.contains(node); }

  /// Joins ridges into longer lines where they meet at nodes, two ridges at each node.
  void join_ridges() {
    std::map<std::uint32_t, std::vector<std::size_t>> at_node;
    for (std::size_t i = 0; i < ridges_.size(); ++i) {
      for (const std::uint32_t node : ridges_[i].nodes) {
        if (node != UINT32_MAX) at_node[node].push_back(i);
      }
    }
    std::vector<bool> is_used(ridges_.size());
    for (std::size_t i = 0; i < ridges_.size(); ++i) {
      if (is_used[i]) continue;
      is_used[i] = true;
      Ridge& line = ridges_[i];
      for (int side = 0; side < 2; ++side) {
        lengthen(line, at_node, is_used);
        std::ranges::reverse(line.rest.places);
        std::ranges::reverse(line.nodes);
      }
      rests_.lines.push_back(std::move(line.rest));
    }
  }

  /// Appends ridges to the end of `line` as long as there is one that continues it.
  void lengthen(Ridge& line,
                const std::map<std::uint32_t, std::vector<std::size_t>>& at_node,
                std::vector<bool>& is_used) {
    while (line.nodes.back() != UINT32_MAX) {
      const std::uint32_t node = line.nodes.back();
      const auto& here = at_node.at(node);
      const auto next = std::ranges::find_if(here, [&](std::size_t i) {
        return !is_used[i] && ridges_[i].rest.level == line.rest.level;
      });
      if (next == here.end()) return;
      is_used[*next] = true;
      Ridge& more = ridges_[*next];
      if (more.nodes.front() != node) {
        std::ranges::reverse(more.rest.places);
        std::ranges::reverse(more.nodes);
      }
      line.rest.places.insert(
          line.rest.places.end(), more.rest.places.begin() + 1, more.rest.places.end());
      line.nodes.back() = more.nodes.back();
    }
  }

  const MedialAxis& axis_;
  double interval_;
  double half_;
  std::vector<std::size_t> degrees_;  ///< Number of ends of chains at each node.
  FillRests rests_;
  std::vector<Ridge> ridges_;
  std::set<std::uint32_t> nodes_;  ///< Nodes at which lines that cover gaps end.
  /// Nodes that the rows do not cover, each with the level of its line.
  std::set<std::pair<std::uint32_t, std::size_t>> dots_;
};

}  // namespace

FillRests rests_between_rows(const cnc::contour::ContourView<double>& area, double interval_mm) {
  const pocket::OwnedArea owned{area};
  const double tolerance_mm = kAxisTolerance * interval_mm;
  const MedialAxis axis =
      pocket::medial_axis(owned, {.tolerance_mm = tolerance_mm, .slack_mm = 2.0 * tolerance_mm});
  return RestFinder{axis, interval_mm}.find();
}

}  // namespace sim::cut
