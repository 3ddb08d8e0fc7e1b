#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/surface/mesh.hpp"

namespace sim::wall {

/// A closed line around a solid, or around a hole in the solid, at one height, mm. Seen from above,
/// the solid is on the left of the line. The last point is connected to the first point, which is
/// not repeated.
using SectionLoop = std::vector<Eigen::Vector2d>;

/// Cuts a solid with horizontal planes, from the top down.
///
/// A point of the mesh at the height of a plane counts as below the plane. The crossing of an edge
/// depends only on the two points of the edge, so that it is the same for both facets at the edge.
/// Therefore all loops are closed, even if facets are in the plane.
class SectionSweep {
 public:
  /// @param solid must outlive this object
  /// @pre require_solid() accepts the solid
  explicit SectionSweep(const surface::Mesh& solid);

  /// Returns the loops at a height. Without sorting, the time is proportional to the number of
  /// facets that the plane crosses or has passed since the previous call. Loops touch where the
  /// solid touches itself.
  /// @pre the height is not above the height of the previous call
  [[nodiscard]] std::vector<SectionLoop> loops_at(double height_mm);

 private:
  /// The line in which the plane cuts a facet, from one of its edges to another.
  struct Segment {
    std::uint64_t from = 0;  ///< Edge at the start, given by the numbers of its two points.
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
  /// Index in by_top_ of the first facet that no plane has reached.
  std::size_t next_ = 0;
  std::vector<std::uint32_t> crossed_;  ///< Facets that the last plane crosses.
};

}  // namespace sim::wall
