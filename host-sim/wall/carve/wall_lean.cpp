#include "host-sim/wall/carve/wall_lean.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace sim::wall {
namespace {

using Eigen::Vector2d;

constexpr double kInDegrees = 180.0 / std::numbers::pi;

/// Distance, in cells, beyond the limit of the search outwards. Columns up to this distance are
/// included in the search, so that the middle of at least one column is outside the drawn wall.
constexpr double kSightCells = 1.0;

/// A column near a section, and its distance from the wall.
struct NearColumn {
  double out = 0.0;  ///< Distance of the column's middle outwards from the wall's point `at`.
  int column = 0;
  int row = 0;
};

struct SectionPoint {
  double out = 0.0;
  double z = 0.0;
};

/// Returns the columns near the section through a wall at `place`, the outermost column first.
std::vector<NearColumn> columns_near(const Columns& columns, const WallPlace& place) {
  const double cell = std::max(columns.cell_x_mm(), columns.cell_y_mm());
  const double outward =
      kSightCells * cell + std::max(place.reach_mm(place.low_mm), place.reach_mm(place.high_mm));
  const Vector2d reach = Vector2d::Constant(place.inward_mm + outward + cell);
  const stock::StockBox& box = columns.box();
  const auto cells = [](double way, double cell_mm, int count) {
    return static_cast<int>(std::clamp(way / cell_mm, 0.0, static_cast<double>(count)));
  };
  const Vector2d low = place.at - reach - Vector2d{box.x_min, box.y_min};
  const Vector2d high = low + 2.0 * reach;
  const int last_row = cells(high.y(), columns.cell_y_mm(), columns.rows() - 1);
  const int last = cells(high.x(), columns.cell_x_mm(), columns.columns() - 1);
  std::vector<NearColumn> near;
  for (int row = cells(low.y(), columns.cell_y_mm(), columns.rows()); row <= last_row; ++row) {
    int column = cells(low.x(), columns.cell_x_mm(), columns.columns());
    for (; column <= last; ++column) {
      const Vector2d way = Vector2d{columns.x_of(column), columns.y_of(row)} - place.at;
      const double out = way.dot(place.outward);
      const double beside = way.x() * place.outward.y() - way.y() * place.outward.x();
      if (std::abs(beside) > 0.75 * cell || out < -place.inward_mm || out > outward) {
        continue;
      }
      near.push_back({out, column, row});
    }
  }
  std::ranges::sort(near, std::greater{}, &NearColumn::out);
  return near;
}

/// Section of a carved wall, derived from columns. Distances are outwards from the wall's point
/// `at`, mm.
struct Section {
  std::vector<SectionPoint> points;
  double last_free = std::numeric_limits<double>::infinity();
  double first_full = -std::numeric_limits<double>::infinity();
};

/// Returns the fraction of the wall's upper half that the material of a column fills.
double share_of(const Columns& columns, const NearColumn& near, const WallPlace& place) {
  const double middle = place.middle_mm();
  double filled = 0.0;
  columns.each_range(near.column, near.row, [&](const HeightRange& range) {
    filled += std::max(0.0, std::min(range.high, place.high_mm) - std::max(range.low, middle));
  });
  return filled / (place.high_mm - middle);
}

/// Adds the ends of a column's ranges that are visible from outside the drawn wall.
void add_points(const Columns& columns,
                const std::vector<NearColumn>& near,
                const NearColumn& column,
                const WallPlace& place,
                Section& section) {
  const auto hides = [&](const NearColumn& other, double z) {
    return other.out > column.out && other.out <= place.reach_mm(z) &&
           columns.has(other.column, other.row, z);
  };
  columns.each_range(column.column, column.row, [&](const HeightRange& range) {
    for (const double z : {range.low, range.high}) {
      if (z <= place.low_mm || z >= place.high_mm || column.out > place.reach_mm(z)) continue;
      const bool is_hidden =
          std::ranges::any_of(near, [&](const NearColumn& other) { return hides(other, z); });
      if (!is_hidden) section.points.push_back({column.out, z});
    }
  });
}

/// Returns the section through a carved wall at `place`.
/// @param near columns near the section, the outermost column first
Section section_of(const Columns& columns,
                   const std::vector<NearColumn>& near,
                   const WallPlace& place) {
  Section section;
  for (const NearColumn& column : near) {
    const double share = share_of(columns, column, place);
    if (share == 0.0) section.last_free = column.out;
    add_points(columns, near, column, place, section);
    if (share < 1.0 || !std::isinf(section.first_full)) continue;
    section.first_full = column.out;
  }
  return section;
}

/// Returns the lean of the line that is fitted to the points by least squares.
/// @pre there are at least two points, of different heights
WallLean fitted(const std::vector<SectionPoint>& points, double cell_mm) {
  const auto count = static_cast<double>(points.size());
  SectionPoint mean;
  for (const SectionPoint& point : points) {
    mean.out += point.out / count;
    mean.z += point.z / count;
  }
  double mixed = 0.0;
  double square = 0.0;
  for (const SectionPoint& point : points) {
    mixed += (point.out - mean.out) * (point.z - mean.z);
    square += (point.z - mean.z) * (point.z - mean.z);
  }
  const double slope = mixed / square;
  double off = 0.0;
  for (const SectionPoint& point : points) {
    const double error = point.out - mean.out - slope * (point.z - mean.z);
    off += error * error;
  }
  // Two points have no deviation from the line through them, so half a cell is used as their
  // standard deviation.
  const double rest = points.size() > 2 ? off / (count - 2.0) : 0.25 * cell_mm * cell_mm;
  const double deviation = std::sqrt(rest / square);
  return {std::atan(-slope) * kInDegrees, 2.0 * std::atan(deviation) * kInDegrees, points.size()};
}

/// Returns the mean lean of all lines that pass between two columns of the section: the column at
/// `last_free`, which has no material in the upper half of the wall, and the column at
/// `first_full`, which is full in this half. If the section has a point, only lines through its
/// first point count.
std::optional<WallLean> between_columns(const Section& section, const WallPlace& place) {
  const double height = place.high_mm - place.low_mm;
  const double gap = section.last_free - section.first_full;
  if (!std::isfinite(gap)) return {};
  double most = std::atan(gap / height) * kInDegrees;
  if (section.points.empty()) return WallLean{0.0, most, 0};
  // Greatest inclination at which a line through the point stays between the two columns.
  const SectionPoint& point = section.points.front();
  const double up = (point.out - section.first_full) / (place.high_mm - point.z);
  const double down = (section.last_free - point.out) / (point.z - place.low_mm);
  most = std::atan(std::min(std::abs(up), std::abs(down))) * kInDegrees;
  return WallLean{0.5 * most, 0.5 * most, section.points.size()};
}

}  // namespace

std::optional<WallLean> lean_at(const Columns& columns, const WallPlace& place) {
  const std::vector<NearColumn> near = columns_near(columns, place);
  const double cell = std::max(columns.cell_x_mm(), columns.cell_y_mm());
  const double sight = place.reach_mm(place.middle_mm()) + kSightCells * cell;
  const auto first =
      std::ranges::find_if(near, [sight](const NearColumn& column) { return column.out <= sight; });
  const bool is_carved = first != near.end() && first->out > 0.0 &&
                         !columns.has(first->column, first->row, place.middle_mm());
  if (!is_carved) return {};
  const Section section = section_of(columns, near, place);
  const auto heights = std::ranges::minmax_element(section.points, {}, &SectionPoint::z);
  const double height = place.high_mm - place.low_mm;
  const bool is_tall =
      section.points.size() >= 2 && heights.max->z - heights.min->z > 0.25 * height;
  return is_tall ? fitted(section.points, cell) : between_columns(section, place);
}

}  // namespace sim::wall
