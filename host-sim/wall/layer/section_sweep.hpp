#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/surface/mesh.hpp"

namespace sim::wall {

/// A closed line around the solid, or around a hole in it, at one height, mm. Seen from above, the
/// solid is on its left. The last place leads to the first, which is not repeated.
using SectionLoop = std::vector<Eigen::Vector2d>;

/// Cuts a solid with level planes, from the top down.
///
/// A point of the mesh at the height of a plane counts as below the plane, and a crossing depends
/// only on the two points of its edge. Therefore all loops are closed, even if facets lie in a
/// plane, and two facets always agree about the edge that they share.
class SectionSweep {
 public:
  /// @param solid the solid; it outlives this object
  /// @pre require_solid() accepts the solid
  explicit SectionSweep(const surface::Mesh& solid);

  /// Returns the loops at a height. The time is proportional to the number of facets that the plane
  /// passes or crosses, apart from sorting. Loops touch where the solid touches itself.
  /// @pre the height is not above that of the previous call
  [[nodiscard]] std::vector<SectionLoop> loops_at(double height_mm);

 private:
  /// The part of a facet in the plane, between two of its edges.
  struct Segment {
    std::uint64_t from = 0;  ///< Edge, given by the numbers of its two points.
    std::uint64_t to = 0;
    bool is_taken = false;
  };

  [[nodiscard]] double top_of(std::uint32_t facet) const;
  [[nodiscard]] double bottom_of(std::uint32_t facet) const;
  void advance(double height_mm);
  [[nodiscard]] Segment segment_of(std::uint32_t facet, double height_mm) const;
  [[nodiscard]] Eigen::Vector2d crossing_of(std::uint64_t edge, double height_mm) const;

  const surface::Mesh* solid_;
  /// Facets sorted by their highest point, the highest first.
  std::vector<std::uint32_t> by_top_;
  /// Index of the first facet that the planes have not reached.
  std::size_t next_ = 0;
  std::vector<std::uint32_t> crossed_;  ///< Facets that the last plane crosses.
};

}  // namespace sim::wall
