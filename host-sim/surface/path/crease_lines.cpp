#include "host-sim/surface/path/crease_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace sim::surface {
namespace {

using Eigen::Vector2d;

/// Maximum length of a bridged gap between two ends, in cells.
constexpr double kBridgedCells = 2.0;

/// A graph of points on creases, with links between neighbours.
class CreaseGraph {
 public:
  std::size_t add(const CreasePlace& place) {
    places_.push_back(place);
    links_.emplace_back();
    return places_.size() - 1;
  }

  void link(std::size_t one, std::size_t other) {
    links_[one].push_back(other);
    links_[other].push_back(one);
  }

  [[nodiscard]] double distance(std::size_t one, std::size_t other) const {
    return (places_[one].place - places_[other].place).norm();
  }

  /// Links each end of a line to the nearest unlinked end within `max_mm`.
  void bridge(double max_mm) {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (links_[i].size() <= 1) ends.push_back(i);
    }
    for (const std::size_t end : ends) {
      if (links_[end].size() > 1) continue;
      std::optional<std::size_t> nearest;
      for (const std::size_t other : ends) {
        const bool is_free = other != end && links_[other].size() <= 1 &&
                             std::ranges::find(links_[end], other) == links_[end].end();
        if (!is_free || distance(end, other) > max_mm) continue;
        if (!nearest || distance(end, other) < distance(end, *nearest)) nearest = other;
      }
      if (nearest) link(end, *nearest);
    }
  }

  /// Removes all lines from the graph and returns them: first the lines between ends and branches,
  /// then the closed lines.
  std::vector<CreaseLine> take_lines() {
    std::vector<CreaseLine> lines;
    for (const bool is_closed : {false, true}) {
      for (std::size_t i = 0; i < links_.size(); ++i) {
        while (!links_[i].empty() && (is_closed || links_[i].size() != 2)) {
          lines.push_back(take_line(i));
        }
      }
    }
    return lines;
  }

 private:
  /// Removes and returns the line from a point to the next end or branch, or around a closed line
  /// back to the point.
  CreaseLine take_line(std::size_t first) {
    CreaseLine line{places_[first]};
    std::size_t at = first;
    do {
      const std::size_t next = links_[at].back();
      links_[at].pop_back();
      auto& back = links_[next];
      back.erase(std::ranges::find(back, at));
      line.push_back(places_[next]);
      at = next;
    } while (links_[at].size() == 1 && at != first);
    return line;
  }

  std::vector<CreasePlace> places_;
  std::vector<std::vector<std::size_t>> links_;
};

/// Searches for crossings of creases with the edges of a grid, row by row.
class CreaseGrid {
 public:
  CreaseGrid(const Mesh& mesh, const CreaseFinder& finder, double pitch_mm)
      : finder_{finder}, pitch_mm_{pitch_mm} {
    min_ = mesh.points.front().head<2>();
    max_ = min_;
    for (const Eigen::Vector3d& point : mesh.points) {
      min_ = min_.cwiseMin(point.head<2>());
      max_ = max_.cwiseMax(point.head<2>());
    }
    // The offset makes it unlikely that a valley along an axis coincides with edges of the grid.
    first_ = min_ - 0.37 * pitch_mm_ * Vector2d{1.0, 0.9};
    columns_ = 2 + static_cast<std::size_t>(std::ceil((max_.x() - first_.x()) / pitch_mm_));
    rows_ = 2 + static_cast<std::size_t>(std::ceil((max_.y() - first_.y()) / pitch_mm_));
  }

  std::vector<CreaseLine> lines() {
    std::vector<ToolPose> below = row_of(0);
    Crossings bottom = along(below);
    for (std::size_t row = 1; row < rows_; ++row) {
      const std::vector<ToolPose> above = row_of(row);
      const Crossings top = along(above);
      const Crossings sides = across(below, above);
      for (std::size_t i = 0; i + 1 < columns_; ++i) {
        link_cell({bottom[i], top[i], sides[i], sides[i + 1]});
      }
      below = above;
      bottom = top;
    }
    graph_.bridge(kBridgedCells * pitch_mm_);
    return graph_.take_lines();
  }

 private:
  /// Index in the graph of each edge's crossing; empty if the edge has no crossing.
  using Crossings = std::vector<std::optional<std::size_t>>;

  std::vector<ToolPose> row_of(std::size_t row) const {
    std::vector<ToolPose> poses;
    for (std::size_t i = 0; i < columns_; ++i) {
      const Vector2d place =
          first_ + pitch_mm_ * Vector2d{static_cast<double>(i), static_cast<double>(row)};
      poses.push_back(finder_.pose_at(place.cwiseMax(min_).cwiseMin(max_)));
    }
    return poses;
  }

  std::optional<std::size_t> crossing(const ToolPose& from, const ToolPose& to) {
    const std::optional<CreasePlace> found = finder_.between(from, to);
    if (!found) return {};
    return graph_.add(*found);
  }

  Crossings along(const std::vector<ToolPose>& row) {
    Crossings found;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) found.push_back(crossing(row[i], row[i + 1]));
    return found;
  }

  Crossings across(const std::vector<ToolPose>& below, const std::vector<ToolPose>& above) {
    Crossings found;
    for (std::size_t i = 0; i < below.size(); ++i) found.push_back(crossing(below[i], above[i]));
    return found;
  }

  /// Links the crossings of a cell: first crossings on opposite edges, then a third crossing to the
  /// nearer of the two.
  void link_cell(const std::array<std::optional<std::size_t>, 4>& edges) {
    std::vector<std::size_t> found;
    for (const auto& edge : edges) {
      if (edge) found.push_back(*edge);
    }
    if (found.size() < 2) return;
    if (found.size() == 2) return graph_.link(found[0], found[1]);
    if (edges[0] && edges[1]) graph_.link(*edges[0], *edges[1]);
    if (edges[2] && edges[3]) graph_.link(*edges[2], *edges[3]);
    if (found.size() == 4) return;
    const bool is_beside = edges[0] && edges[1];
    const std::size_t third = is_beside ? edges[2].value_or(edges[3].value_or(0))
                                        : edges[0].value_or(edges[1].value_or(0));
    const std::size_t left = *edges[is_beside ? 0 : 2];
    const std::size_t right = *edges[is_beside ? 1 : 3];
    const bool is_left = graph_.distance(left, third) < graph_.distance(right, third);
    graph_.link(third, is_left ? left : right);
  }

  const CreaseFinder& finder_;
  double pitch_mm_;
  /// Lower corner of the mesh's bounding box. Points of the grid beyond the box are moved to the
  /// box's border.
  Vector2d min_ = Vector2d::Zero();
  Vector2d max_ = Vector2d::Zero();
  Vector2d first_ = Vector2d::Zero();
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  CreaseGraph graph_;
};

}  // namespace

std::vector<CreaseLine> crease_lines(const Mesh& mesh,
                                     const CreaseFinder& finder,
                                     double pitch_mm) {
  return CreaseGrid{mesh, finder, pitch_mm}.lines();
}

}  // namespace sim::surface
