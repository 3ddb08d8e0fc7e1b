#include "host-sim/stock/mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <vector>

#include "host-sim/stock/height_map.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim::stock {
namespace {

struct MeshPoint {
  double x;
  double y;
  double z;
};
using Triangle = std::array<std::uint32_t, 3>;

/// The rest of a stock as points and triangles. The upper points stand in rows, from the first
/// side of the box to the last; those of the rim have one below them at the bottom, in the order
/// of rim_, and one more is in the middle of the bottom.
class BodyMesh {
 public:
  explicit BodyMesh(const Stock& stock) : map_{stock, kMostMeshPoints} { list_rim(); }

  [[nodiscard]] std::uint32_t point_count() const {
    return columns() * rows() + static_cast<std::uint32_t>(rim_.size()) + 1;
  }
  [[nodiscard]] std::uint32_t triangle_count() const {
    return 2 * (columns() - 1) * (rows() - 1) + 3 * static_cast<std::uint32_t>(rim_.size());
  }

  [[nodiscard]] MeshPoint point(std::uint32_t index) const {
    const std::uint32_t upper = columns() * rows();
    const StockBox& box = map_.box();
    if (index < upper) return upper_point(index % columns(), index / columns());
    if (index - upper == rim_.size()) {
      return {0.5 * (box.x_min + box.x_max), 0.5 * (box.y_min + box.y_max), box.bottom};
    }
    const std::uint32_t above = rim_[index - upper];
    MeshPoint point = upper_point(above % columns(), above / columns());
    point.z = box.bottom;
    return point;
  }

  /// Calls `take` with each triangle, counter-clockwise as seen from outside.
  template <typename Take>
  void each_triangle(Take take) const {
    for (std::uint32_t row = 0; row + 1 < rows(); ++row) {
      for (std::uint32_t column = 0; column + 1 < columns(); ++column) {
        const std::uint32_t corner = row * columns() + column;
        take(Triangle{corner, corner + 1, corner + columns() + 1});
        take(Triangle{corner, corner + columns() + 1, corner + columns()});
      }
    }
    const std::uint32_t upper = columns() * rows();
    const auto middle = static_cast<std::uint32_t>(upper + rim_.size());
    for (std::uint32_t i = 0; i < rim_.size(); ++i) {
      const auto next = static_cast<std::uint32_t>((i + 1) % rim_.size());
      take(Triangle{rim_[i], upper + i, upper + next});
      take(Triangle{rim_[i], upper + next, rim_[next]});
      take(Triangle{upper + i, middle, upper + next});
    }
  }

 private:
  /// The map's blocks, and a point more at each side of the box.
  [[nodiscard]] std::uint32_t columns() const {
    return static_cast<std::uint32_t>(map_.columns()) + 2;
  }
  [[nodiscard]] std::uint32_t rows() const { return static_cast<std::uint32_t>(map_.rows()) + 2; }

  [[nodiscard]] MeshPoint upper_point(std::uint32_t column, std::uint32_t row) const {
    const int x = std::clamp(static_cast<int>(column) - 1, 0, map_.columns() - 1);
    const int y = std::clamp(static_cast<int>(row) - 1, 0, map_.rows() - 1);
    MeshPoint point{map_.x_of(x), map_.y_of(y), map_.height(x, y)};
    if (column == 0) point.x = map_.box().x_min;
    if (column + 1 == columns()) point.x = map_.box().x_max;
    if (row == 0) point.y = map_.box().y_min;
    if (row + 1 == rows()) point.y = map_.box().y_max;
    return point;
  }

  /// Counter-clockwise as seen from above, from the corner of least X and Y.
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

/// Little-endian bytes of a file, whatever the machine's are.
class BinaryFile {
 public:
  explicit BinaryFile(const std::string& name) : file_{name} {}

  void add_text(std::string_view text) { file_.buffer().append(text); }
  void add_byte(std::uint8_t byte) { file_.buffer().push_back(static_cast<char>(byte)); }
  void add_whole(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) add_byte(static_cast<std::uint8_t>(value >> shift));
    file_.drain_when_full();
  }
  void add_real(double value) {
    add_whole(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  }
  void add_point(const MeshPoint& point) {
    add_real(point.x);
    add_real(point.y);
    add_real(point.z);
  }
  void close() { file_.close(); }

 private:
  OutputFile file_;
};

/// Of unit length; zero for a triangle without area.
MeshPoint normal_of(const std::array<MeshPoint, 3>& corners) {
  const auto [a, b, c] = corners;
  const MeshPoint u{b.x - a.x, b.y - a.y, b.z - a.z};
  const MeshPoint v{c.x - a.x, c.y - a.y, c.z - a.z};
  const MeshPoint n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  if (length == 0.0) return {0.0, 0.0, 0.0};
  return {n.x / length, n.y / length, n.z / length};
}

}  // namespace

void write_stl(const std::string& file, const Stock& stock) {
  constexpr std::size_t kHeaderBytes = 80;
  const BodyMesh mesh{stock};
  BinaryFile out{file};
  out.add_text(fmt::format("{:<{}}", "kerfline sim: carved stock, mm", kHeaderBytes));
  out.add_whole(mesh.triangle_count());
  mesh.each_triangle([&](const Triangle& triangle) {
    const std::array<MeshPoint, 3> corners{
        mesh.point(triangle[0]), mesh.point(triangle[1]), mesh.point(triangle[2])};
    out.add_point(normal_of(corners));
    for (const MeshPoint& corner : corners) out.add_point(corner);
    out.add_byte(0);
    out.add_byte(0);
  });
  out.close();
}

void write_ply(const std::string& file, const Stock& stock) {
  const BodyMesh mesh{stock};
  BinaryFile out{file};
  out.add_text(
      fmt::format("ply\nformat binary_little_endian 1.0\n"
                  "comment kerfline sim: carved stock, mm\n"
                  "element vertex {}\nproperty float x\nproperty float y\n"
                  "property float z\nelement face {}\n"
                  "property list uchar uint vertex_indices\nend_header\n",
                  mesh.point_count(),
                  mesh.triangle_count()));
  for (std::uint32_t i = 0; i < mesh.point_count(); ++i) out.add_point(mesh.point(i));
  mesh.each_triangle([&](const Triangle& triangle) {
    out.add_byte(3);
    for (const std::uint32_t corner : triangle) out.add_whole(corner);
  });
  out.close();
}

}  // namespace sim::stock
