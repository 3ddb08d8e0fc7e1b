#include "host-sim/cut/fill_area.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace sim::cut {
namespace {

/// A stretch of an outline along which y only rises or only falls, from its lowest to its highest
/// point.
struct RisingEdge {
  Place low{0.0, 0.0};
  Place high{0.0, 0.0};
  Place centre{0.0, 0.0};  ///< Centre of the circle, if the stretch is an arc.
  double radius = 0.0;     ///< Radius of the arc; 0: the stretch is a line.
  /// Whether the arc is to the right of its centre; otherwise it is to the left.
  bool is_right = false;

  [[nodiscard]] double x_at(double y) const {
    if (radius == 0.0) {
      return low.x() + (high.x() - low.x()) * (y - low.y()) / (high.y() - low.y());
    }
    const double height = y - centre.y();
    const double half = std::sqrt(std::max(radius * radius - height * height, 0.0));
    return centre.x() + (is_right ? half : -half);
  }
};

/// Finds the points at which rows along x cross closed outlines. Adjacent edges share the exact
/// coordinates of their common end. So each row crosses each outline an even number of times.
class RowCrossings {
 public:
  explicit RowCrossings(double interval_mm) : interval_mm_{interval_mm} {}

  void add(const Stroke& stroke) {
    if (stroke.bulge == 0.0) return add_edge({.low = stroke.from, .high = stroke.to});
    const Place chord = stroke.to - stroke.from;
    const double b = stroke.bulge;
    const Place left{-chord.y(), chord.x()};
    const Place centre = 0.5 * (stroke.from + stroke.to) + (1.0 - b * b) / (4.0 * b) * left;
    const double radius = drawing::distance(centre, stroke.from);
    const double sweep = 4.0 * std::atan(b);
    const Place out = stroke.from - centre;
    const double begin = std::atan2(out.y(), out.x());
    add_arc(stroke, centre, radius, begin, sweep);
  }

  [[nodiscard]] bool is_too_much() const { return too_much_; }
  /// Returns the number of the lowest row. Call it after rows().
  [[nodiscard]] std::int64_t first_row() const { return first_; }
  /// Returns, for each row, the x coordinates at which it crosses the outlines, in ascending order.
  [[nodiscard]] std::vector<std::vector<double>> rows() {
    first_ = std::numeric_limits<std::int64_t>::max();
    std::int64_t last = std::numeric_limits<std::int64_t>::min();
    std::size_t crossings = 0;
    for (const RisingEdge& edge : edges_) {
      const std::int64_t from = row_from(edge.low.y());
      const std::int64_t to = row_from(edge.high.y());
      if (from == to) continue;
      first_ = std::min(first_, from);
      last = std::max(last, to);
      crossings += static_cast<std::size_t>(to - from);
    }
    too_much_ = crossings > kMaxFillStrokes ||
                (last > first_ && last - first_ > static_cast<std::int64_t>(kMaxFillStrokes));
    if (too_much_ || last <= first_) return {};
    std::vector<std::vector<double>> rows(static_cast<std::size_t>(last - first_));
    for (const RisingEdge& edge : edges_) {
      const std::int64_t to = row_from(edge.high.y());
      for (std::int64_t row = row_from(edge.low.y()); row < to; ++row) {
        rows[static_cast<std::size_t>(row - first_)].push_back(edge.x_at(y_of(row)));
      }
    }
    for (std::vector<double>& row : rows) std::ranges::sort(row);
    return rows;
  }

  [[nodiscard]] double y_of(std::int64_t row) const {
    return (static_cast<double>(row) + 0.5) * interval_mm_;
  }

 private:
  /// Returns the number of the first row at or above the height `y`.
  [[nodiscard]] std::int64_t row_from(double y) const {
    auto row = static_cast<std::int64_t>(std::ceil(y / interval_mm_ - 0.5));
    while (y_of(row) < y) ++row;
    while (y_of(row - 1) >= y) --row;
    return row;
  }

  void add_edge(RisingEdge edge) {
    if (edge.low.y() > edge.high.y()) std::swap(edge.low, edge.high);
    edges_.push_back(edge);
  }

  /// Adds an arc, divided at the highest and lowest points of its circle.
  void add_arc(
      const Stroke& stroke, const Place& centre, double radius, double begin, double sweep) {
    constexpr double kHalfTurn = std::numbers::pi;
    const double way = sweep < 0.0 ? -1.0 : 1.0;
    // Angle of the first extreme point after the beginning: an odd multiple of a quarter turn.
    double next = way * (std::floor(way * begin / kHalfTurn + 0.5) + 0.5) * kHalfTurn;
    double at = begin;
    Place from = stroke.from;
    const double end = begin + sweep;
    while (true) {
      const bool is_last = way * (end - next) <= 0.0;
      const double to_angle = is_last ? end : next;
      const Place to =
          is_last ? stroke.to
                  : Place{centre.x(), centre.y() + (std::sin(next) > 0.0 ? radius : -radius)};
      RisingEdge edge{.low = from, .high = to, .centre = centre, .radius = radius};
      edge.is_right = std::cos(0.5 * (at + to_angle)) > 0.0;
      add_edge(edge);
      if (is_last) return;
      from = to;
      at = next;
      next += way * kHalfTurn;
    }
  }

  double interval_mm_;
  std::vector<RisingEdge> edges_;
  std::int64_t first_ = 0;
  bool too_much_ = false;
};

Place turned(const Place& place, const Place& direction) {
  return {place.x() * direction.x() - place.y() * direction.y(),
          place.x() * direction.y() + place.y() * direction.x()};
}

/// Builds the path of a fill by appending one stroke after the other.
class FillPath {
 public:
  FillPath(const Place& direction, double overscan_mm)
      : direction_{direction}, overscan_mm_{overscan_mm} {}

  /// Appends the lines of one row. Their direction alternates from row to row.
  void add_row(const std::vector<double>& crossings, double y) {
    std::vector<std::pair<double, double>> lines;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const double from = crossings[i];
      const double to = crossings[i + 1];
      if (to - from < kShortestMm) continue;
      if (!lines.empty() && from - lines.back().second < kShortestMm) {
        lines.back().second = to;
      } else {
        lines.emplace_back(from, to);
      }
    }
    if (lines.empty()) return;
    if (is_backwards_) {
      std::ranges::reverse(lines);
      for (auto& [from, to] : lines) std::swap(from, to);
    }
    const double run = is_backwards_ ? -overscan_mm_ : overscan_mm_;
    go(lines.front().first - run, y, Purpose::kOverscan);
    for (const auto& [from, to] : lines) {
      go(from, y, Purpose::kOverscan);
      go(to, y, Purpose::kContour);
    }
    go(lines.back().second + run, y, Purpose::kOverscan);
    is_backwards_ = !is_backwards_;
  }

  std::vector<Stroke> take() { return std::move(strokes_); }

 private:
  /// Least length of lines and of gaps between them, mm. Shorter ones are left out.
  static constexpr double kShortestMm = 1.0e-3;

  void go(double x, double y, Purpose purpose) {
    const Place to = turned({x, y}, direction_);
    if (here_ && *here_ != to) strokes_.push_back({*here_, to, 0.0, purpose});
    here_ = to;
  }

  Place direction_;
  double overscan_mm_;
  bool is_backwards_ = false;
  std::optional<Place> here_{};
  std::vector<Stroke> strokes_;
};

/// The upright rectangle around some strokes.
struct Box {
  Place low{0.0, 0.0};
  Place high{0.0, 0.0};
};

Box box_of(const std::vector<Stroke>& strokes) {
  Box box{strokes.front().from, strokes.front().from};
  for (const Stroke& stroke : strokes) {
    // The ends of an arc are the points farthest from its middle.
    const double reach = 0.5 * drawing::distance(stroke.from, stroke.to) *
                         std::sqrt(1.0 + stroke.bulge * stroke.bulge);
    const Place middle =
        stroke.bulge == 0.0 ? 0.5 * (stroke.from + stroke.to) : place_at(stroke, 0.5);
    const Place far{reach, reach};
    box.low = box.low.cwiseMin(middle - far);
    box.high = box.high.cwiseMax(middle + far);
  }
  return box;
}

/// Disjoint sets of numbers that can be united.
class UnitedSets {
 public:
  explicit UnitedSets(std::size_t count) : first_(count) {
    std::iota(first_.begin(), first_.end(), std::size_t{0});
  }
  /// Returns the smallest member of the set that contains `member`.
  std::size_t first_of(std::size_t member) {
    while (first_[member] != member) member = first_[member] = first_[first_[member]];
    return member;
  }
  void unite(std::size_t a, std::size_t b) {
    const std::size_t x = first_of(a);
    const std::size_t y = first_of(b);
    first_[std::max(x, y)] = std::min(x, y);
  }

 private:
  std::vector<std::size_t> first_;
};

}  // namespace

std::optional<std::vector<Stroke>> fill_path(const std::vector<std::vector<Stroke>>& outlines,
                                             const FillSettings& fill,
                                             double overscan_mm) {
  const Place direction = drawing::direction(fill.angle_deg * std::numbers::pi / 180.0);
  const Place back{direction.x(), -direction.y()};
  RowCrossings crossings{fill.interval_mm};
  for (const std::vector<Stroke>& outline : outlines) {
    for (Stroke stroke : outline) {
      stroke.from = turned(stroke.from, back);
      stroke.to = turned(stroke.to, back);
      crossings.add(stroke);
    }
  }
  const std::vector<std::vector<double>> rows = crossings.rows();
  if (crossings.is_too_much()) return std::nullopt;
  FillPath path{direction, overscan_mm};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    path.add_row(rows[i], crossings.y_of(crossings.first_row() + static_cast<std::int64_t>(i)));
  }
  return path.take();
}

double overscan_for(double speed_mm_s, double angle_deg, const cnc::order::RapidLimits& limits) {
  const Place direction = drawing::direction(angle_deg * std::numbers::pi / 180.0);
  const std::array<double, 2> shares{std::abs(direction.x()), std::abs(direction.y())};
  double acceleration = std::numeric_limits<double>::max();
  double rise_s = 0.0;  // Time until the acceleration reaches its limit.
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (shares[axis] < 1.0e-6) continue;
    acceleration = std::min(acceleration, limits.acceleration_mm_s2[axis] / shares[axis]);
    const double jerk = limits.jerk_mm_s3[axis];
    if (jerk > 0.0) rise_s = std::max(rise_s, limits.acceleration_mm_s2[axis] / jerk);
  }
  constexpr double kMargin = 1.1;
  return kMargin * 0.5 * speed_mm_s * (speed_mm_s / acceleration + rise_s);
}

std::vector<std::vector<std::size_t>> groups_by_box(
    const std::vector<std::vector<Stroke>>& outlines) {
  std::vector<Box> boxes;
  boxes.reserve(outlines.size());
  for (const std::vector<Stroke>& outline : outlines) boxes.push_back(box_of(outline));
  std::vector<std::size_t> by_x(boxes.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::ranges::stable_sort(by_x, {}, [&](std::size_t i) { return boxes[i].low.x(); });
  UnitedSets sets{boxes.size()};
  std::vector<std::size_t> open;
  for (const std::size_t i : by_x) {
    std::erase_if(open, [&](std::size_t k) { return boxes[k].high.x() < boxes[i].low.x(); });
    for (const std::size_t k : open) {
      const bool meets =
          boxes[k].low.y() <= boxes[i].high.y() && boxes[i].low.y() <= boxes[k].high.y();
      if (meets) sets.unite(i, k);
    }
    open.push_back(i);
  }
  std::vector<std::vector<std::size_t>> groups;
  std::vector<std::size_t> group_of(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::size_t first = sets.first_of(i);
    if (first == i) {
      group_of[i] = groups.size();
      groups.emplace_back();
    }
    groups[group_of[first]].push_back(i);
  }
  return groups;
}

}  // namespace sim::cut
