#include "host-sim/stock/mesh_file.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "host-sim/stock/binary_mesh.hpp"
#include "host-sim/stock/height_map.hpp"

namespace sim::stock {
namespace {

constexpr const char* kMeshTitle = "kerfline sim: carved stock, mm";

/// The material that is left of a stock, as points and triangles. The upper points form rows that
/// extend to the sides of the box. Each point of the rim has a point below it at the bottom, in the
/// order of rim_. One more point is in the middle of the bottom.
class BodyMesh {
 public:
  explicit BodyMesh(const Stock& stock) : map_{stock, kMaxMeshPoints} { list_rim(); }

  [[nodiscard]] std::uint32_t point_count() const {
    return columns() * rows() + static_cast<std::uint32_t>(rim_.size()) + 1;
  }
  [[nodiscard]] std::uint32_t triangle_count() const {
    return 2 * (columns() - 1) * (rows() - 1) + 3 * static_cast<std::uint32_t>(rim_.size());
  }

  [[nodiscard]] Eigen::Vector3d point(std::uint32_t index) const {
    const std::uint32_t upper = columns() * rows();
    const StockBox& box = map_.box();
    if (index < upper) return upper_point(index % columns(), index / columns());
    if (index - upper == rim_.size()) {
      return {0.5 * (box.x_min + box.x_max), 0.5 * (box.y_min + box.y_max), box.bottom};
    }
    const std::uint32_t above = rim_[index - upper];
    Eigen::Vector3d point = upper_point(above % columns(), above / columns());
    point.z() = box.bottom;
    return point;
  }

  /// Calls `take` with each triangle, counter-clockwise as seen from outside.
  template <typename Take>
  void each_triangle(Take take) const {
    for (std::uint32_t row = 0; row + 1 < rows(); ++row) {
      for (std::uint32_t column = 0; column + 1 < columns(); ++column) {
        const std::uint32_t corner = row * columns() + column;
        take(MeshTriangle{corner, corner + 1, corner + columns() + 1});
        take(MeshTriangle{corner, corner + columns() + 1, corner + columns()});
      }
    }
    const std::uint32_t upper = columns() * rows();
    const auto middle = static_cast<std::uint32_t>(upper + rim_.size());
    for (std::uint32_t i = 0; i < rim_.size(); ++i) {
      const auto next = static_cast<std::uint32_t>((i + 1) % rim_.size());
      take(MeshTriangle{rim_[i], upper + i, upper + next});
      take(MeshTriangle{rim_[i], upper + next, rim_[next]});
      take(MeshTriangle{upper + i, middle, upper + next});
    }
  }

 private:
  /// Returns the number of upper points in a row: one for each of the map's columns, and one at
  /// each side of the box. rows() counts in the same way.
  [[nodiscard]] std::uint32_t columns() const {
    return static_cast<std::uint32_t>(map_.columns()) + 2;
  }
  [[nodiscard]] std::uint32_t rows() const { return static_cast<std::uint32_t>(map_.rows()) + 2; }

  [[nodiscard]] Eigen::Vector3d upper_point(std::uint32_t column, std::uint32_t row) const {
    const int x = std::clamp(static_cast<int>(column) - 1, 0, map_.columns() - 1);
    const int y = std::clamp(static_cast<int>(row) - 1, 0, map_.rows() - 1);
    Eigen::Vector3d point{map_.x_of(x), map_.y_of(y), map_.height(x, y)};
    if (column == 0) point.x() = map_.box().x_min;
    if (column + 1 == columns()) point.x() = map_.box().x_max;
    if (row == 0) point.y() = map_.box().y_min;
    if (row + 1 == rows()) point.y() = map_.box().y_max;
    return point;
  }

  /// Lists the points of the rim counter-clockwise as seen from above, beginning at the corner with
  /// the lowest X and Y.
  void list_rim() {
    const std::uint32_t last_column = columns() - 1;
    const std::uint32_t last_row = rows() - 1;
    for (std::uint32_t i = 0; i < last_column; ++i) rim_.push_back(i);
    for (std::uint32_t i = 0; i < last_row; ++i) rim_.push_back(i * columns() + last_column);
    for (std::uint32_t i = last_column; i > 0; --i) rim_.push_back(last_row * columns() + i);
    for (std::uint32_t i = last_row; i > 0; --i) rim_.push_back(i * columns());
  }

  HeightMap map_;
  std::vector<std::uint32_t> rim_;
};

}  // namespace

void write_stl(const std::string& file, const Stock& stock) {
  write_binary_stl(file, kMeshTitle, BodyMesh{stock});
}

void write_ply(const std::string& file, const Stock& stock) {
  write_binary_ply(file, kMeshTitle, BodyMesh{stock});
}

}  // namespace sim::stock
