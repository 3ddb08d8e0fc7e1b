#include "host-sim/surface/triangle_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>

namespace sim::surface {
namespace {

static_assert(std::endian::native == std::endian::little);

template <typename Value>
void append(std::string& bytes, const Value& value) {
  std::array<char, sizeof(Value)> raw{};
  std::memcpy(raw.data(), &value, sizeof(Value));
  bytes.append(raw.data(), raw.size());
}

}  // namespace

std::string ply_of(const Mesh& mesh) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\n"
      "property list uchar uint vertex_indices\nend_header\n",
      mesh.points.size(),
      mesh.facets.size());
  bytes.reserve(bytes.size() + 24 * mesh.points.size() + 13 * mesh.facets.size());
  for (const Eigen::Vector3d& point : mesh.points) {
    for (const double part : point) append(bytes, part);
  }
  for (const auto& facet : mesh.facets) {
    append(bytes, std::uint8_t{3});
    for (const std::uint32_t corner : facet) append(bytes, corner);
  }
  return bytes;
}

}  // namespace sim::surface
