#include <fmt/format.h>

#include <cmath>

#include "host-sim/surface/byte_reader.hpp"
#include "host-sim/surface/point_merger.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/stl_reader.hpp"

namespace sim::surface {
namespace {

constexpr std::size_t kStlHeaderBytes = 80;
constexpr std::size_t kStlNormalBytes = 12;
constexpr std::size_t kStlFacetBytes = 50;

}  // namespace

bool has_length_of_stl(std::string_view bytes) {
  if (bytes.size() < kStlHeaderBytes + 4) return false;
  ByteReader reader{bytes.substr(kStlHeaderBytes), ByteOrder::kLittleEndian};
  const std::size_t count = reader.take<std::uint32_t>();
  return reader.left() == kStlFacetBytes * count;
}

MeshDraft read_binary_stl(std::string_view bytes, const std::string& name) {
  ByteReader reader{bytes, ByteOrder::kLittleEndian};
  if (reader.left() < kStlHeaderBytes + 4) {
    refuse(name, 0, "is too short for binary STL", "export the mesh again");
  }
  reader.skip(kStlHeaderBytes);
  const std::size_t count = reader.take<std::uint32_t>();
  if (reader.left() != kStlFacetBytes * count) {
    refuse(name,
           0,
           fmt::format("announces {} facets of binary STL, but has bytes for {}",
                       count,
                       reader.left() / kStlFacetBytes),
           "it is cut off or of another format; export the mesh again");
  }
  if (count > 2 * kMaxPoints) refuse(name, 0, "too many facets", "thin the mesh out");
  MeshDraft draft{.name = name};
  draft.mesh.facets.resize(count);
  PointMerger merger;
  for (std::size_t i = 0; i < count; ++i) {
    reader.skip(kStlNormalBytes);
    for (std::uint32_t& corner : draft.mesh.facets[i]) {
      const double x = reader.take_float();
      const double y = reader.take_float();
      const double z = reader.take_float();
      if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
        refuse(name,
               0,
               fmt::format("facet {} has a coordinate that is not finite", i + 1),
               "export the mesh again without such points");
      }
      corner = merger.number({x, y, z});
    }
    reader.skip(2);
  }
  draft.mesh.points = merger.take_points();
  return draft;
}

}  // namespace sim::surface
