#include "host-sim/surface/path/distance_loops.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "host-sim/surface/path/iso_lines.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;

/// The connected parts of an area in which the distance from the border exceeds `value_mm`.
class InnerParts {
 public:
  InnerParts(const DistanceMap& distances, double value_mm)
      : distances_{distances}, value_mm_{value_mm}, part_of_(distances.grid().size(), kNone) {
    for (std::size_t node = 0; node < part_of_.size(); ++node) {
      if (part_of_[node] == kNone && is_within(node)) fill(node);
    }
  }

  /// Returns the greatest distance from the border in the part that contains `node`.
  [[nodiscard]] double greatest_around(std::size_t node) const { return greatest_[part_of_[node]]; }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  [[nodiscard]] bool is_within(std::size_t node) const {
    const double distance = distances_.at(node);
    return distance > value_mm_ && std::isfinite(distance);
  }

  void fill(std::size_t first) {
    const std::size_t columns = distances_.grid().columns();
    const std::size_t part = greatest_.size();
    greatest_.push_back(0.0);
    open_.push_back(first);
    part_of_[first] = part;
    while (!open_.empty()) {
      const std::size_t node = open_.back();
      open_.pop_back();
      greatest_[part] = std::max(greatest_[part], distances_.at(node));
      const std::size_t column = node % columns;
      if (column > 0) reach(node - 1, part);
      if (column + 1 < columns) reach(node + 1, part);
      if (node >= columns) reach(node - columns, part);
      if (node + columns < part_of_.size()) reach(node + columns, part);
    }
  }

  void reach(std::size_t node, std::size_t part) {
    if (part_of_[node] != kNone || !is_within(node)) return;
    part_of_[node] = part;
    open_.push_back(node);
  }

  const DistanceMap& distances_;
  double value_mm_;
  std::vector<std::size_t> part_of_;
  std::vector<double> greatest_;
  std::vector<std::size_t> open_;
};

std::vector<IsoLine> lines_at(const DistanceMap& distances, double value_mm) {
  const PlanGrid& grid = distances.grid();
  const auto side_of = [&](std::size_t node) {
    const double distance = distances.at(node);
    if (!std::isfinite(distance)) return NodeSide::kNone;
    return distance > value_mm ? NodeSide::kHigh : NodeSide::kLow;
  };
  const auto is_high_in_middle = [&](std::size_t node) {
    const std::size_t above = node + grid.columns();
    return distances.at(node) + distances.at(node + 1) + distances.at(above) +
               distances.at(above + 1) >
           4.0 * value_mm;
  };
  return iso_lines(grid, side_of, is_high_in_middle);
}

LevelLoop loop_of(const DistanceMap& distances, const IsoLine& line, double value_mm) {
  constexpr double kMinWay = 1.0e-6;
  const PlanGrid& grid = distances.grid();
  LevelLoop loop{.level = 0, .level_mm = value_mm, .places = {}, .is_closed = line.is_closed};
  for (const CrossedEdge& edge : line.edges) {
    const double low = distances.at(edge.low);
    const double share = (value_mm - low) / (distances.at(edge.high) - low);
    const Vector2d from = grid.at(edge.low);
    const Vector2d place = from + share * (grid.at(edge.high) - from);
    const bool is_same = !loop.places.empty() && (place - loop.places.back()).norm() < kMinWay;
    if (!is_same) loop.places.push_back(place);
  }
  return loop;
}

/// Collects lines, and the distances of adjacent nodes from the lines.
class LoopLayer {
 public:
  explicit LoopLayer(const TipGrid& tips) : tips_{tips} {}

  void add(const DistanceMap& distances, const IsoLine& line, double value_mm, std::size_t level) {
    LevelLoop loop = loop_of(distances, line, value_mm);
    loop.level = level;
    if (loop.places.size() <= 2) return;
    loops_.push_back(std::move(loop));
    for (const CrossedEdge& edge : line.edges) {
      const double whole = (tips_.tip(edge.high) - tips_.tip(edge.low)).norm();
      const double low = distances.at(edge.low);
      const double share = (value_mm - low) / (distances.at(edge.high) - low);
      note(edge.low, edge, share * whole);
      note(edge.high, edge, (1.0 - share) * whole);
    }
  }

  /// A range of distances, above `from_mm` and up to `to_mm`.
  struct Range {
    double from_mm = 0.0;
    double to_mm = 0.0;
  };

  /// Adds the lines at the distance `value_mm` around the parts whose greatest distance from the
  /// border is in `range`.
  void add_round(const DistanceMap& distances, double value_mm, Range range, std::size_t level) {
    const InnerParts parts{distances, value_mm};
    for (const IsoLine& line : lines_at(distances, value_mm)) {
      const double greatest = parts.greatest_around(line.edges.front().high);
      if (greatest <= range.from_mm || greatest > range.to_mm) continue;
      add(distances, line, value_mm, level);
    }
  }

  /// Returns the nodes that are adjacent to lines, with their distances from the lines.
  [[nodiscard]] std::vector<DistanceSource> beside() const {
    std::vector<DistanceSource> sources;
    for (const auto& [node, ways] : beside_) {
      // If a line crosses a node's edges along X and along Y, it is nearer to the node than either
      // crossing.
      const double least = std::min(ways[0], ways[1]);
      const double ratio = least > 0.0 ? least / std::max(ways[0], ways[1]) : 0.0;
      sources.push_back({node, least / std::sqrt(1.0 + ratio * ratio)});
    }
    return sources;
  }
  [[nodiscard]] std::vector<LevelLoop> take() { return std::move(loops_); }

 private:
  /// Stores the distance between a node and a line, measured along one of the node's edges.
  void note(std::size_t node, const CrossedEdge& edge, double way_mm) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    const bool is_along_x = std::max(edge.low, edge.high) - std::min(edge.low, edge.high) == 1;
    auto& ways = beside_.try_emplace(node, std::array{kInfinite, kInfinite}).first->second;
    double& way = ways[is_along_x ? 0 : 1];
    way = std::min(way, way_mm);
  }

  const TipGrid& tips_;
  std::vector<LevelLoop> loops_;
  /// Distances of each adjacent node from the nearest line, along X and along Y, mm.
  std::map<std::size_t, std::array<double, 2>> beside_;
};

}  // namespace

std::vector<LevelLoop> distance_loops(const SurfaceTracer& tracer,
                                      const TipGrid& tips,
                                      double step_mm,
                                      double max_mm) {
  constexpr double kFirst = 0.25;  // Distance between the border and the first line, in steps.
  LoopLayer layer{tips};
  const DistanceMap distances{tips, border_sources(tracer, tips)};
  const double greatest = distances.greatest();
  for (std::size_t level = 0; static_cast<double>(level) * step_mm < greatest; ++level) {
    const double value = (static_cast<double>(level) + kFirst) * step_mm;
    for (const IsoLine& line : lines_at(distances, value)) layer.add(distances, line, value, level);
    // Adds lines half a step inside the previous line, in the parts that are too narrow for the
    // line at `value`.
    if (level == 0) continue;
    layer.add_round(distances, value - 0.5 * step_mm, {0.0, value}, level);
  }
  // Between straight lines, a point is at most half a step from a line. At corners of lines, the
  // distance may be greater. Additional lines surround the points that are too far from all lines.
  const double middle = 0.5 * (0.5 * step_mm + max_mm);
  const DistanceMap left{tips, layer.beside()};
  const auto last = static_cast<std::size_t>(std::ceil(greatest / step_mm));
  layer.add_round(left, middle, {max_mm, greatest + max_mm}, last + 1);
  return layer.take();
}

}  // namespace sim::surface
