#include "host-sim/surface/path/pencil_path.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "host-sim/surface/path/crease_lines.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using PlanLine = std::vector<Vector2d>;

/// Pitch of the grid, relative to the tool's radius.
constexpr double kGridShare = 0.125;

double length_of(const CreaseLine& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length += (line[i].place - line[i - 1].place).norm();
  }
  return length;
}

/// Joins lines whose ends are at most `max_mm` apart. The lines were divided at a short branch,
/// which was left out.
void join_lines(std::vector<CreaseLine>& lines, double max_mm) {
  const auto is_near = [max_mm](const CreasePlace& one, const CreasePlace& other) {
    return (one.place - other.place).norm() <= max_mm;
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = i + 1; k < lines.size();) {
      CreaseLine& line = lines[i];
      CreaseLine& other = lines[k];
      if (is_near(line.front(), other.front()) || is_near(line.front(), other.back())) {
        std::ranges::reverse(line);
      }
      if (is_near(line.back(), other.back())) std::ranges::reverse(other);
      if (!is_near(line.back(), other.front()) || is_near(line.front(), line.back())) {
        ++k;
        continue;
      }
      line.insert(line.end(), other.begin() + 1, other.end());
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(k));
      k = i + 1;
    }
  }
}

double distance_to(const Vector2d& place, const Vector2d& from, const Vector2d& to) {
  const Vector2d way = to - from;
  const double square = way.squaredNorm();
  const double share = square > 0.0 ? std::clamp(way.dot(place - from) / square, 0.0, 1.0) : 0.0;
  return (place - from - share * way).norm();
}

/// Appends the points between indices `from` and `to` that a polyline needs to stay within `max_mm`
/// of all points of `line`.
void add_needed(
    const PlanLine& line, std::size_t from, std::size_t to, double max_mm, PlanLine& out) {
  std::vector<std::pair<std::size_t, std::size_t>> pending{{from, to}};
  while (!pending.empty()) {
    const auto [first, last] = pending.back();
    pending.pop_back();
    std::size_t farthest = first;
    double distance = max_mm;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double beside = distance_to(line[i], line[first], line[last]);
      if (beside <= distance) continue;
      distance = beside;
      farthest = i;
    }
    if (farthest == first) {
      out.push_back(line[last]);
      continue;
    }
    pending.emplace_back(farthest, last);
    pending.emplace_back(first, farthest);
  }
}

/// Returns a line with fewer points that stays within `max_mm` of all points of `line`.
PlanLine simplified(const PlanLine& line, double max_mm) {
  PlanLine out{line.front()};
  // The line is divided in the middle, because a closed line has no chord between its ends.
  const std::size_t middle = line.size() / 2;
  if (middle > 0) add_needed(line, 0, middle, max_mm, out);
  add_needed(line, middle, line.size() - 1, max_mm, out);
  return out;
}

/// Converts creases to lines in plan. The lines follow the creases within a part of the tolerance;
/// next to walls they are on the low side.
class CreaseDrawer {
 public:
  CreaseDrawer(const ToolHeights& heights, const CreaseFinder& finder, double tolerance_mm)
      : heights_{heights}, finder_{finder}, tolerance_mm_{tolerance_mm} {}

  [[nodiscard]] PlanLine drawn(const CreaseLine& line, double pitch_mm) const {
    constexpr int kHalvings = 3;
    CreaseLine fine = line;
    for (int i = 0; i < kHalvings; ++i) fine = refined(fine, 0.5 * pitch_mm);
    PlanLine places;
    for (std::size_t i = 0; i < fine.size(); ++i) places.push_back(shifted(fine, i));
    return simplified(places, 0.25 * tolerance_mm_);
  }

 private:
  /// Returns the line with an additional point in each piece that deviates from the crease.
  [[nodiscard]] CreaseLine refined(const CreaseLine& line, double reach_mm) const {
    CreaseLine fine{line.front()};
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vector2d way = line[i].place - line[i - 1].place;
      if (way.norm() > 0.01 * reach_mm) {
        const Vector2d middle = 0.5 * (line[i].place + line[i - 1].place);
        const Vector2d beside = reach_mm / way.norm() * Vector2d{-way.y(), way.x()};
        const auto found =
            finder_.between(finder_.pose_at(middle - beside), finder_.pose_at(middle + beside));
        if (found && (found->place - middle).norm() > 0.1 * tolerance_mm_) fine.push_back(*found);
      }
      fine.push_back(line[i]);
    }
    return fine;
  }

  /// Returns a point of the line. At a wall, the point is moved by half the tolerance to the low
  /// side, so that chords stay on the low side.
  [[nodiscard]] Vector2d shifted(const CreaseLine& line, std::size_t index) const {
    const Vector2d& place = line[index].place;
    if (!line[index].is_wall) return place;
    const Vector2d& before = line[index > 0 ? index - 1 : index].place;
    const Vector2d& behind = line[index + 1 < line.size() ? index + 1 : index].place;
    const Vector2d way = behind - before;
    if (way.norm() == 0.0) return place;
    const Vector2d beside = 0.5 * tolerance_mm_ / way.norm() * Vector2d{-way.y(), way.x()};
    const double side = heights_(place + beside) < heights_(place - beside) ? 1.0 : -1.0;
    return place + side * beside;
  }

  const ToolHeights& heights_;
  const CreaseFinder& finder_;
  double tolerance_mm_;
};

/// Plans the path along lines. The nearest remaining line always comes next.
class PencilDriver {
 public:
  PencilDriver(const Mesh& mesh, const RowOptions& options)
      : options_{options},
        tracer_{mesh, options},
        stock_top_mm_{options.stock_top_mm.value_or(top_of(mesh))} {}

  [[nodiscard]] const cnc::surface::Profile& profile() const { return tracer_.profile(); }

  SurfacePath drive(std::vector<PlanLine> lines) {
    Vector2d here = Vector2d::Zero();
    while (!lines.empty()) {
      const auto distance = [&here](const PlanLine& line) {
        return std::min((line.front() - here).norm(), (line.back() - here).norm());
      };
      const auto nearest = std::ranges::min_element(lines, {}, distance);
      PlanLine line = std::move(*nearest);
      lines.erase(nearest);
      if ((line.back() - here).norm() < (line.front() - here).norm()) std::ranges::reverse(line);
      drive(line);
      here = line.back();
    }
    path_.without_arcs = tracer_.without_arcs();
    return std::move(path_);
  }

 private:
  void drive(const PlanLine& line) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      if ((line[i] - line[i - 1]).norm() < kMinPiece) continue;
      const Slice slice = slice_between(line[i - 1], line[i]);
      const SliceParts parts = common_parts(options_.regions, slice, tracer_.parts_over(slice));
      for (const auto& [begin, end] : parts) {
        if (begin > kMinPiece) end_run();
        path_.stretches.push_back(tracer_.trace(slice, begin, end, StretchUse::kRow));
        if (end < slice.length - kMinPiece) end_run();
      }
      if (parts.empty()) end_run();
    }
    end_run();
  }

  void end_run() {
    const std::size_t begin = path_.runs.empty() ? 0 : path_.runs.back().end;
    if (begin == path_.stretches.size()) return;
    path_.runs.push_back({path_.stretches.size(), stock_top_mm_});
  }

  static constexpr double kMinPiece = 1.0e-3;

  const RowOptions& options_;
  SurfaceTracer tracer_;
  double stock_top_mm_;
  SurfacePath path_;
};

}  // namespace

PencilPath pencil_path(const Mesh& mesh, const RowOptions& options, const PencilOptions& pencil) {
  PencilDriver driver{mesh, options};
  const ToolHeights heights{mesh, driver.profile(), options.floor_mm};
  const CreaseFinder finder{heights, pencil.angle_rad};
  const CreaseDrawer drawer{heights, finder, options.tolerance_mm};
  const double pitch = kGridShare * options.tool.radius_mm;
  std::vector<CreaseLine> found = crease_lines(mesh, finder, pitch);
  PencilPath result;
  result.left_out =
      std::erase_if(found, [&](const CreaseLine& line) { return length_of(line) < pencil.min_mm; });
  join_lines(found, 0.1 * pitch);
  std::vector<PlanLine> lines;
  lines.reserve(found.size());
  for (const CreaseLine& line : found) lines.push_back(drawer.drawn(line, pitch));
  result.path = driver.drive(std::move(lines));
  if (result.path.stretches.empty()) {
    throw std::invalid_argument{
        "the surface has no valley in which the tool touches both sides: check --pencil-angle, or "
        "choose a larger tool"};
  }
  return result;
}

}  // namespace sim::surface
