#include "host-sim/wall/carve/section.hpp"

#include <algorithm>
#include <cmath>

namespace sim::wall {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Appends the part of the line from `a` to `b` that is between the ends of the section, if there
/// is one.
void add_within(Vector2d a,
                Vector2d b,
                double length,
                std::vector<std::array<Vector2d, 2>>& lines) {
  if (a.x() > b.x()) std::swap(a, b);
  if (b.x() < 0.0 || a.x() > length) return;
  const Vector2d way = b - a;
  const auto at = [&](double out) -> Vector2d {
    return way.x() == 0.0 ? a : Vector2d{a + (out - a.x()) / way.x() * way};
  };
  if (b.x() > length) b = at(length);
  if (a.x() < 0.0) a = at(0.0);
  lines.push_back({a, b});
}

}  // namespace

std::vector<SectionBar> section_of(const Columns& columns, const SectionLine& line) {
  const double length = line.length_mm();
  const double cell = std::min(columns.cell_x_mm(), columns.cell_y_mm());
  const auto count = static_cast<int>(std::ceil(2.0 * length / cell));
  const stock::StockBox& box = columns.box();
  std::vector<SectionBar> bars;
  int last_column = -1;
  int last_row = -1;
  std::size_t first = 0;  // Index of the first bar of the current column.
  for (int i = 0; i < count; ++i) {
    const Vector2d at = line.from + (i + 0.5) / count * (line.until - line.from);
    const auto column = static_cast<int>(std::floor((at.x() - box.x_min) / columns.cell_x_mm()));
    const auto row = static_cast<int>(std::floor((at.y() - box.y_min) / columns.cell_y_mm()));
    if (column < 0 || row < 0 || column >= columns.columns() || row >= columns.rows()) continue;
    const double until = length * (i + 1) / count;
    if (column == last_column && row == last_row) {
      for (std::size_t k = first; k < bars.size(); ++k) bars[k].until_mm = until;
      continue;
    }
    last_column = column;
    last_row = row;
    first = bars.size();
    columns.each_range(column, row, [&](const HeightRange& range) {
      bars.push_back({length * i / count, until, range});
    });
  }
  return bars;
}

std::vector<std::array<Vector2d, 2>> section_of(const surface::Mesh& mesh,
                                                const SectionLine& line) {
  const double length = line.length_mm();
  const Vector2d along = (line.until - line.from) / length;
  const auto seen = [&](const Vector3d& point) {
    const Vector2d way = point.head<2>() - line.from;
    return Vector3d{way.dot(along), along.x() * way.y() - along.y() * way.x(), point.z()};
  };
  std::vector<std::array<Vector2d, 2>> lines;
  for (const auto& facet : mesh.facets) {
    std::array<Vector2d, 2> ends{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d a = seen(mesh.points[facet[i]]);
      const Vector3d b = seen(mesh.points[facet[(i + 1) % 3]]);
      // A point exactly on the section plane counts as left of the plane.
      if ((a.y() < 0.0) == (b.y() < 0.0) || count == ends.size()) continue;
      const double share = a.y() / (a.y() - b.y());
      const Vector3d on = a + share * (b - a);
      ends[count++] = {on.x(), on.z()};
    }
    if (count == ends.size()) add_within(ends[0], ends[1], length, lines);
  }
  return lines;
}

}  // namespace sim::wall
