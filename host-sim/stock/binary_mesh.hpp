#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "host-sim/trace/output_file.hpp"

namespace sim::stock {

/// Indices of a triangle's points, counter-clockwise as seen from outside.
using MeshTriangle = std::array<std::uint32_t, 3>;

/// Writes little-endian bytes to a file, on computers of any byte order.
class BinaryFile {
 public:
  explicit BinaryFile(const std::string& name) : file_{name} {}

  void add_text(std::string_view text) { file_.buffer().append(text); }
  void add_byte(std::uint8_t byte) { file_.buffer().push_back(static_cast<char>(byte)); }
  void add_whole(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) add_byte(static_cast<std::uint8_t>(value >> shift));
    file_.drain_when_full();
  }
  void add_point(const Eigen::Vector3d& point) {
    for (const double value : point) {
      add_whole(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
    }
  }
  void close() { file_.close(); }

 private:
  OutputFile file_;
};

/// Returns the normal of a triangle, a unit vector; zero for a triangle without area.
[[nodiscard]] inline Eigen::Vector3d normal_of(const std::array<Eigen::Vector3d, 3>& corners) {
  const Eigen::Vector3d across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double length = across.norm();
  if (length == 0.0) return Eigen::Vector3d::Zero();
  return across / length;
}

/// Writes a mesh as binary STL, with 50 bytes for each triangle, or as binary PLY (little-endian),
/// with 13 bytes for each triangle and 12 for each point. Throws std::system_error with the name of
/// the file.
/// @param title a line of at most 80 characters
/// @param mesh has point_count(), triangle_count(), point(index) in mm, and each_triangle(take),
/// which calls `take` with each MeshTriangle
template <typename Mesh>
void write_binary_stl(const std::string& file, std::string_view title, const Mesh& mesh) {
  constexpr std::size_t kHeaderBytes = 80;
  BinaryFile out{file};
  out.add_text(fmt::format("{:<{}}", title, kHeaderBytes));
  out.add_whole(mesh.triangle_count());
  mesh.each_triangle([&](const MeshTriangle& triangle) {
    const std::array<Eigen::Vector3d, 3> corners{
        mesh.point(triangle[0]), mesh.point(triangle[1]), mesh.point(triangle[2])};
    out.add_point(normal_of(corners));
    for (const Eigen::Vector3d& corner : corners) out.add_point(corner);
    out.add_byte(0);
    out.add_byte(0);
  });
  out.close();
}

template <typename Mesh>
void write_binary_ply(const std::string& file, std::string_view title, const Mesh& mesh) {
  BinaryFile out{file};
  out.add_text(
      fmt::format("ply\nformat binary_little_endian 1.0\n"
                  "comment {}\n"
                  "element vertex {}\nproperty float x\nproperty float y\n"
                  "property float z\nelement face {}\n"
                  "property list uchar uint vertex_indices\nend_header\n",
                  title,
                  mesh.point_count(),
                  mesh.triangle_count()));
  for (std::uint32_t i = 0; i < mesh.point_count(); ++i) out.add_point(mesh.point(i));
  mesh.each_triangle([&](const MeshTriangle& triangle) {
    out.add_byte(3);
    for (const std::uint32_t corner : triangle) out.add_whole(corner);
  });
  out.close();
}

}  // namespace sim::stock
