#include "host-sim/surface/ply_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "host-sim/surface/ply_header.hpp"
#include "host-sim/surface/ply_source.hpp"
#include "host-sim/surface/refusal.hpp"

namespace sim::surface {
namespace {

constexpr double kGreatestIndex = 4'294'967'294.0;

/// Reads the elements of a PLY file from PlyText or PlyBytes.
template <typename Source>
class PlyElements {
 public:
  PlyElements(const PlyHeader& header, const std::string& name)
      : name_{name}, source_{header, name}, draft_{.name = name} {}

  void read(const PlyElement& element) {
    if (element.name == "vertex") {
      read_points(element);
    } else if (element.name == "face") {
      read_facets(element, [this](const PlyProperty& list, std::uint64_t number) {
        read_fan(list, number);
      });
    } else if (element.name == "tristrips") {
      read_facets(element, [this](const PlyProperty& list, std::uint64_t) { read_strips(list); });
    } else {
      for (std::uint64_t i = 0; i < element.count; ++i) {
        for (const PlyProperty& property : element.properties) skip(property);
      }
    }
  }
  MeshDraft take() { return std::move(draft_); }

 private:
  /// Reads the length of a list and checks that the file has enough bytes for the list.
  std::size_t take_length(const PlyProperty& property) {
    if (!property.list_count) return 1;
    const double length = source_.take(*property.list_count);
    // Each number takes at least a byte.
    if (length >= 0.0 && length <= static_cast<double>(source_.left())) {
      return static_cast<std::size_t>(length);
    }
    refuse(name_,
           source_.line(),
           fmt::format("has a list of {} numbers", length),
           "the file is damaged; export it again");
  }

  void skip(const PlyProperty& property) {
    const std::size_t length = take_length(property);
    for (std::size_t i = 0; i < length; ++i) source_.take(property.scalar);
  }

  void read_points(const PlyElement& element) {
    const std::array<std::size_t, 3> axes{
        element.index("x"), element.index("y"), element.index("z")};
    for (const std::size_t axis : axes) {
      if (axis < element.properties.size() && !element.properties[axis].list_count) continue;
      refuse(name_, 0, "its vertices have no x, y or z", "export the mesh again");
    }
    if (element.count > kMaxPoints) refuse(name_, 0, "too many points", "thin the mesh out");
    draft_.mesh.points.reserve(draft_.mesh.points.size() + element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      Eigen::Vector3d point{0.0, 0.0, 0.0};
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const auto* const axis = std::ranges::find(axes, p);
        if (axis == axes.end()) {
          skip(element.properties[p]);
        } else {
          point[axis - axes.begin()] = source_.take(element.properties[p].scalar);
        }
      }
      draft_.mesh.points.push_back(point);
    }
  }

  /// Reads all facets. Calls `read_list(property, number)` for the list of corners of each facet;
  /// `number` counts from 1.
  template <typename ReadList>
  void read_facets(const PlyElement& element, const ReadList& read_list) {
    std::size_t corners = element.index("vertex_indices");
    if (corners == element.properties.size()) corners = element.index("vertex_index");
    if (corners == element.properties.size() || !element.properties[corners].list_count) {
      refuse(name_, 0, "its faces have no list vertex_indices", "export the mesh again");
    }
    if (element.count > 2 * kMaxPoints) refuse(name_, 0, "too many facets", "thin the mesh out");
    draft_.mesh.facets.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        if (p == corners) {
          read_list(element.properties[p], i + 1);
        } else {
          skip(element.properties[p]);
        }
      }
    }
  }

  std::uint32_t index_of(double value, std::uint64_t number) const {
    if (value >= 0.0 && value <= kGreatestIndex && value == std::floor(value)) {
      return static_cast<std::uint32_t>(value);
    }
    refuse(name_,
           source_.line(),
           fmt::format("facet {} has point {}", number, value),
           "export the mesh again");
  }

  /// Adds the triangles of strips, which are separated by -1. Each corner from the third on forms a
  /// triangle with the two corners before it. The order of corners is reversed in every second
  /// triangle. Triangles with equal corners, which only join strips, are left out.
  void read_strips(const PlyProperty& property) {
    const std::size_t length = take_length(property);
    std::array<std::uint32_t, 3> last{};
    std::size_t count = 0;  // Number of corners of this strip so far.
    for (std::size_t i = 0; i < length; ++i) {
      const double value = source_.take(property.scalar);
      if (value == -1.0) {
        count = 0;
        continue;
      }
      const auto number = static_cast<std::uint64_t>(draft_.mesh.facets.size() + 1);
      last = {last[1], last[2], index_of(value, number)};
      if (++count < 3 || last[0] == last[1] || last[1] == last[2] || last[2] == last[0]) continue;
      if (number > 2 * kMaxPoints) refuse(name_, 0, "too many facets", "thin the mesh out");
      draft_.mesh.facets.push_back(count % 2 == 1 ? last : std::array{last[1], last[0], last[2]});
      draft_.numbers.push_back(static_cast<std::uint32_t>(number));
    }
  }

  /// Adds the triangles of the polygon `number`, counted from 1.
  void read_fan(const PlyProperty& property, std::uint64_t number) {
    const std::size_t length = take_length(property);
    std::array<std::uint32_t, 3> facet{};
    for (std::size_t i = 0; i < length; ++i) {
      const std::uint32_t index = index_of(source_.take(property.scalar), number);
      facet[i == 0 ? 0 : 2] = index;
      if (i >= 2) {
        draft_.mesh.facets.push_back(facet);
        draft_.numbers.push_back(static_cast<std::uint32_t>(number));
      }
      if (i >= 1) facet[1] = facet[2];
    }
  }

  const std::string& name_;
  Source source_;
  MeshDraft draft_;
};

template <typename Source>
MeshDraft read_ply_elements(const PlyHeader& header, const std::string& name) {
  PlyElements<Source> elements{header, name};
  for (const PlyElement& element : header.elements) elements.read(element);
  return elements.take();
}

}  // namespace

MeshDraft read_ply(std::string_view bytes, const std::string& name) {
  const PlyHeader header = read_ply_header(bytes, name);
  const auto has = [&](std::string_view element) {
    return std::ranges::count(header.elements, element, &PlyElement::name) == 1;
  };
  if (!has("vertex") || has("face") == has("tristrips")) {
    refuse(name,
           0,
           "needs a list of vertices, and a list of either faces or tristrips",
           "export a mesh; points alone are read as XYZ text in rows");
  }
  if (header.format == PlyFormat::kAscii) return read_ply_elements<PlyText>(header, name);
  return read_ply_elements<PlyBytes>(header, name);
}

}  // namespace sim::surface
