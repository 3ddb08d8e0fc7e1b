#include "host-sim/wall/carve/carved_mesh.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "host-sim/stock/binary_mesh.hpp"

namespace sim::wall {
namespace {

using Ranges = std::vector<HeightRange>;

/// Returns the parts of `solid` that are not in `other`. Both lists of ranges are sorted from below
/// upwards.
Ranges without(const Ranges& solid, const Ranges& other) {
  Ranges parts;
  for (HeightRange range : solid) {
    for (const HeightRange& hole : other) {
      if (hole.high <= range.low || hole.low >= range.high) continue;
      if (hole.low > range.low) parts.push_back({range.low, hole.low});
      range.low = hole.high;
    }
    if (range.low < range.high) parts.push_back(range);
  }
  return parts;
}

/// The remaining material of the columns, as a closed body of upright bars. Faces that two bars
/// share are left out. Edges are divided at the ends of neighbours' edges. So each edge of a facet
/// has exactly one other facet, or three if bars touch only along this edge.
class CarvedMesh {
 public:
  /// Uses one column for each square of `step` by `step` columns.
  CarvedMesh(const Columns& columns, int step);

  [[nodiscard]] std::uint32_t point_count() const { return first_.back(); }
  [[nodiscard]] std::uint32_t triangle_count() const { return triangle_count_; }
  [[nodiscard]] Eigen::Vector3d point(std::uint32_t index) const;

  /// Calls `take(triangle)` for each triangle. A triangle consists of three indices of points,
  /// counter-clockwise as seen from outside.
  template <typename Take>
  void each_triangle(Take take) const {
    for (int row = -1; row < rows_; ++row) {
      for (int column = -1; column < columns_; ++column) add_cell(column, row, take);
    }
  }

 private:
  [[nodiscard]] Ranges ranges(int column, int row) const;
  /// Returns the number of a cell's corner with the lowest X and Y.
  [[nodiscard]] std::size_t corner(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] std::vector<double> heights_at(int column, int row) const;
  [[nodiscard]] std::uint32_t index_of(std::size_t corner, double z) const;

  template <typename Take>
  void add_cell(int column, int row, Take& take) const;
  template <typename Take>
  void add_side(
      const Ranges& solid, const Ranges& other, std::size_t a, std::size_t b, Take& take) const;
  template <typename Take>
  void add_strip(std::size_t a, std::size_t b, const HeightRange& range, Take& take) const;

  const Columns& source_;
  int step_;
  int columns_;
  int rows_;
  /// Index of the first point of each corner. The last entry is the number of points.
  std::vector<std::uint32_t> first_;
  /// Heights of the points, from the lowest point of each corner upwards.
  std::vector<double> heights_;
  std::uint32_t triangle_count_ = 0;
};

CarvedMesh::CarvedMesh(const Columns& columns, int step)
    : source_{columns},
      step_{step},
      columns_{(columns.columns() + step - 1) / step},
      rows_{(columns.rows() + step - 1) / step} {
  first_.reserve(corner(0, rows_ + 1) + 1);
  for (int row = 0; row <= rows_; ++row) {
    for (int column = 0; column <= columns_; ++column) {
      first_.push_back(static_cast<std::uint32_t>(heights_.size()));
      const std::vector<double> heights = heights_at(column, row);
      heights_.insert(heights_.end(), heights.begin(), heights.end());
    }
  }
  first_.push_back(static_cast<std::uint32_t>(heights_.size()));
  each_triangle([this](const stock::MeshTriangle&) { ++triangle_count_; });
}

/// Returns the ends of the ranges of the four columns around a corner, sorted, without duplicates.
std::vector<double> CarvedMesh::heights_at(int column, int row) const {
  std::vector<double> heights;
  for (const int x : {column - 1, column}) {
    for (const int y : {row - 1, row}) {
      for (const HeightRange& range : ranges(x, y)) {
        heights.insert(heights.end(), {range.low, range.high});
      }
    }
  }
  std::ranges::sort(heights);
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

Eigen::Vector3d CarvedMesh::point(std::uint32_t index) const {
  const auto next = std::ranges::upper_bound(first_, index);
  const auto number = static_cast<int>(next - first_.begin()) - 1;
  const stock::StockBox& box = source_.box();
  const auto place = [this](int cells, double from, double cell_mm, double until) {
    return std::min(from + cells * step_ * cell_mm, until);
  };
  return {place(number % (columns_ + 1), box.x_min, source_.cell_x_mm(), box.x_max),
          place(number / (columns_ + 1), box.y_min, source_.cell_y_mm(), box.y_max),
          heights_[index]};
}

/// Returns the remaining ranges of a column, sorted from below upwards; no ranges outside the
/// block.
Ranges CarvedMesh::ranges(int column, int row) const {
  Ranges ranges;
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return ranges;
  const auto middle = [this](int index, int count) {
    return std::min(index * step_ + step_ / 2, count - 1);
  };
  source_.each_range(middle(column, source_.columns()),
                     middle(row, source_.rows()),
                     [&ranges](const HeightRange& range) { ranges.push_back(range); });
  std::ranges::reverse(ranges);
  return ranges;
}

std::uint32_t CarvedMesh::index_of(std::size_t corner, double z) const {
  const auto begin = heights_.begin() + first_[corner];
  const auto end = heights_.begin() + first_[corner + 1];
  return static_cast<std::uint32_t>(std::lower_bound(begin, end, z) - heights_.begin());
}

/// Passes the triangles of a column to `take`: its top and bottom faces, and the faces between it
/// and the next columns along X and along Y.
template <typename Take>
void CarvedMesh::add_cell(int column, int row, Take& take) const {
  const Ranges own = ranges(column, row);
  const Ranges right = ranges(column + 1, row);
  const Ranges behind = ranges(column, row + 1);
  if (row >= 0 && column >= 0) {
    for (const HeightRange& range : own) {
      const auto at = [&](int x, int y, double z) {
        return index_of(corner(column + x, row + y), z);
      };
      const double high = range.high;
      const double low = range.low;
      take({at(0, 0, high), at(1, 0, high), at(1, 1, high)});
      take({at(0, 0, high), at(1, 1, high), at(0, 1, high)});
      take({at(0, 0, low), at(1, 1, low), at(1, 0, low)});
      take({at(0, 0, low), at(0, 1, low), at(1, 1, low)});
    }
  }
  if (row >= 0) {
    const std::size_t a = corner(column + 1, row);
    const std::size_t b = corner(column + 1, row + 1);
    add_side(own, right, a, b, take);
    add_side(right, own, b, a, take);
  }
  if (column >= 0) {
    const std::size_t a = corner(column, row + 1);
    const std::size_t b = corner(column + 1, row + 1);
    add_side(own, behind, b, a, take);
    add_side(behind, own, a, b, take);
  }
}

/// Passes the side faces of a column to `take`, at the heights where its neighbour has no material.
/// @param a the corner on the left, seen from the neighbour
/// @param b the corner on the right, seen from the neighbour
template <typename Take>
void CarvedMesh::add_side(
    const Ranges& solid, const Ranges& other, std::size_t a, std::size_t b, Take& take) const {
  for (const HeightRange& range : without(solid, other)) add_strip(a, b, range, take);
}

template <typename Take>
void CarvedMesh::add_strip(std::size_t a,
                           std::size_t b,
                           const HeightRange& range,
                           Take& take) const {
  std::uint32_t left = index_of(a, range.low);
  std::uint32_t right = index_of(b, range.low);
  const std::uint32_t left_end = index_of(a, range.high);
  const std::uint32_t right_end = index_of(b, range.high);
  while (left < left_end || right < right_end) {
    const bool is_left =
        right == right_end || (left < left_end && heights_[left + 1] <= heights_[right + 1]);
    if (is_left) {
      take({left, right, left + 1});
      ++left;
    } else {
      take({left, right, right + 1});
      ++right;
    }
  }
}

}  // namespace

void write_carved(const std::string& file, const Columns& columns) {
  const double share = static_cast<double>(columns.columns()) * columns.rows() /
                       static_cast<double>(kMaxMeshColumns);
  const CarvedMesh mesh{columns, static_cast<int>(std::ceil(std::sqrt(std::max(1.0, share))))};
  constexpr const char* kTitle = "kerfline wall carve: stock that the beam leaves, mm";
  if (file.ends_with(".ply")) {
    stock::write_binary_ply(file, kTitle, mesh);
  } else {
    stock::write_binary_stl(file, kTitle, mesh);
  }
}

}  // namespace sim::wall
