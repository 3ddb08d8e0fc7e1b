#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/surface/mesh.hpp"

namespace sim::wall {

/// A closed line around the solid, or around a hole in it, at one height: the solid is on its left
/// as seen from above. The last place leads to the first, which is not repeated; mm.
using SectionLoop = std::vector<Eigen::Vector2d>;

/// Cuts a solid with level planes, from the top down.
///
/// A point of the mesh at the height of a plane counts as below it, and the place of a crossing
/// depends on the two points of its edge alone. So all loops are closed, whatever lies in a plane,
/// and no two facets disagree about the edge that they share.
class SectionSweep {
 public:
  /// @param solid must outlive this @pre require_solid() accepts it
  explicit SectionSweep(const surface::Mesh& solid);

  /// Returns the loops at a height, no longer than the time of the facets that it passes takes.
  /// Loops touch where the solid does. @pre the height is not above that of the call before
  [[nodiscard]] std::vector<SectionLoop> loops_at(double height_mm);

 private:
  /// The part of a facet in the plane, between two of its edges.
  struct Segment {
    std::uint64_t from = 0;  ///< Edge as the numbers of its two points.
    std::uint64_t to = 0;
    bool is_taken = false;
  };

  [[nodiscard]] double top_of(std::uint32_t facet) const;
  [[nodiscard]] double bottom_of(std::uint32_t facet) const;
  void advance(double height_mm);
  [[nodiscard]] Segment segment_of(std::uint32_t facet, double height_mm) const;
  [[nodiscard]] Eigen::Vector2d crossing_of(std::uint64_t edge, double height_mm) const;

  const surface::Mesh* solid_;
  std::vector<std::uint32_t> by_top_;   ///< Facets, the highest first.
  std::size_t next_ = 0;                ///< The first of them that the planes have not reached.
  std::vector<std::uint32_t> crossed_;  ///< Facets that the last plane crosses.
};

}  // namespace sim::wall
