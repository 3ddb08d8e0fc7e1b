#include "host-sim/surface/path/scallop_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "planner/surface/drop.hpp"

namespace sim::surface {
namespace {

/// Maximum number of halvings of the distance between rows. The limit is necessary at vertical
/// walls, where no number of rows is sufficient.
constexpr int kMaxHalvings = 7;

}  // namespace

double level_step(const cnc::surface::Profile& tool, double scallop_mm) {
  constexpr double kMaxRadii = 1.6;
  constexpr int kHalvings = 50;
  double low = 0.0;
  double high = 0.5 * kMaxRadii * tool.radius_mm;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    const double left = height_at(tool, middle) - tool.tip_mm;
    (left <= scallop_mm ? low : high) = middle;
  }
  return 2.0 * low;
}

double step_of(const RowOptions& options) {
  if (options.scallop_mm == 0.0) return options.step_mm;
  const double level = level_step(options.tool, options.scallop_mm - options.tolerance_mm);
  return options.step_mm > 0.0 ? std::min(options.step_mm, level) : level;
}

ScallopRows::ScallopRows(const SurfaceTracer& tracer,
                         const RowFrame& frame,
                         const cnc::surface::Profile& tool,
                         double scallop_mm)
    : tracer_{&tracer},
      frame_{frame},
      tool_{tool},
      scallop_mm_{scallop_mm},
      // This distance between samples is so small that the computed stock exceeds the stock after
      // continuous motion only slightly.
      look_mm_{std::min(0.125 * tool.radius_mm, std::sqrt(0.24 * tool.radius_mm * scallop_mm))} {}

/// Two rows, the lines between them at which the stock is checked, and the heights of the tip at
/// equal distances along rows and lines. A ball leaves the most stock half way between the rows, so
/// that one line is enough. A tool with a flat bottom needs more lines, because it touches at other
/// points.
class ScallopRows::Strip {
 public:
  Strip(const ScallopRows& rows, const Gap& gap)
      : rows_{rows},
        width_{gap.high_row - gap.low.row},
        around_{static_cast<int>(std::ceil(rows.tool_.radius_mm / rows.look_mm_))},
        begin_{gap.low.begin - around_ * rows.look_mm_},
        looks_{1 + static_cast<int>(std::ceil((gap.low.end - gap.low.begin) / rows.look_mm_))},
        heights_(rows.tool_.flat_mm > 0.0 ? 5 : 3) {
    for (std::size_t row = 0; row < heights_.size(); ++row) {
      const double way = gap.low.row + across(row);
      const int last = looks_ + 2 * around_;
      heights_[row].reserve(static_cast<std::size_t>(last) + 1);
      for (int i = 0; i <= last; ++i) {
        heights_[row].push_back(rows.tracer_->height(rows.frame_.at(along(i), way)));
      }
    }
  }

  [[nodiscard]] int first() const { return around_; }
  [[nodiscard]] int last() const { return around_ + looks_; }
  [[nodiscard]] double along(int index) const { return begin_ + index * rows_.look_mm_; }

  /// Returns the greatest height of the stock that the two rows leave at the points that the tool
  /// would touch between them.
  [[nodiscard]] double scallop(int index) const {
    double greatest = 0.0;
    for (std::size_t row = 1; row + 1 < heights_.size(); ++row) {
      const double climb =
          (height(row, index + 1) - height(row, index - 1)) / (2.0 * rows_.look_mm_);
      const double below = (height(row, index) - height(row - 1, index)) / across(1);
      const double above = (height(row + 1, index) - height(row, index)) / across(1);
      // Checks the rises of both sides, because a tool at the bottom of a valley touches both
      // sides.
      for (const double rise : {below, 0.5 * (below + above), above}) {
        greatest = std::max(greatest, left_beside(row, index, {climb, rise}));
      }
    }
    return greatest;
  }

 private:
  [[nodiscard]] double height(std::size_t row, int index) const {
    return heights_[row][static_cast<std::size_t>(index)];
  }

  /// Returns the distance of a line from the low row, mm.
  [[nodiscard]] double across(std::size_t row) const {
    return width_ * static_cast<double>(row) / static_cast<double>(heights_.size() - 1);
  }

  /// Returns the height, perpendicular to the surface, of the stock that the two rows leave above
  /// the point of contact. `rise` is the rise of the surface at this point.
  [[nodiscard]] double left_beside(std::size_t from, int index, const Eigen::Vector2d& rise) const {
    const double slope = rise.norm();
    const cnc::surface::PlaneContact contact = contact_with_plane(rows_.tool_, slope);
    Eigen::Vector2d place{along(index), across(from)};
    if (slope > 0.0) place += contact.out / slope * rise;
    double left = std::numeric_limits<double>::infinity();
    for (const std::size_t row : {std::size_t{0}, heights_.size() - 1}) {
      const double beside = place.y() - across(row);
      for (int i = index - around_; i <= index + around_; ++i) {
        const double distance = std::hypot(place.x() - along(i), beside);
        if (distance > rows_.tool_.radius_mm) continue;
        left = std::min(left, height(row, i) + height_at(rows_.tool_, distance));
      }
    }
    return (left - height(from, index) - contact.height) / std::sqrt(1.0 + slope * slope);
  }

  const ScallopRows& rows_;
  double width_;
  int around_;
  double begin_;
  int looks_;
  /// Heights along both rows and the lines between them, the low row first.
  std::vector<std::vector<double>> heights_;
};

void ScallopRows::divide(const Gap& gap,
                         std::vector<Gap>& pending,
                         std::vector<RowPart>& parts) const {
  const Strip strip{*this, gap};
  RowPart part{0.5 * (gap.low.row + gap.high_row), 0.0, -1.0};
  const auto take = [&] {
    if (part.end < part.begin) return;
    parts.push_back(part);
    pending.push_back({{gap.low.row, part.begin, part.end}, part.row, gap.depth + 1});
    pending.push_back({part, gap.high_row, gap.depth + 1});
  };
  for (int i = strip.first(); i <= strip.last(); ++i) {
    if (strip.scallop(i) <= scallop_mm_) continue;
    const double begin = std::max(gap.low.begin, strip.along(i) - overlap_mm());
    if (part.end < part.begin || begin > part.end + 2.0 * overlap_mm()) {
      take();
      part.begin = begin;
    }
    part.end = std::min(gap.low.end, strip.along(i) + overlap_mm());
  }
  take();
}

std::vector<RowPart> ScallopRows::between(double low_row, double high_row) const {
  std::vector<RowPart> parts;
  std::vector<Gap> pending{{frame_.whole(low_row), high_row, 0}};
  while (!pending.empty()) {
    const Gap gap = pending.back();
    pending.pop_back();
    if (gap.depth < kMaxHalvings) divide(gap, pending, parts);
  }
  return parts;
}

}  // namespace sim::surface
