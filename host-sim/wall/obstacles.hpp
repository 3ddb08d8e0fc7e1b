#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/surface/box_tree.hpp"
#include "host-sim/surface/mesh.hpp"
#include "host-sim/wall/least_tilt.hpp"
#include "planner/wall/beam.hpp"

namespace sim::wall {

/// A facet, and its clearance from a beam.
struct NearestFacet {
  std::uint32_t facet = 0;
  Triangle obstacle;          ///< The facet as an obstacle for the beam, see as_obstacle().
  double clearance_mm = 0.0;  ///< Clearance between beam and facet; < 0 if the beam hits the facet.
};

/// The facets of a part in a tree, which finds facets near a beam quickly. Lengths are mm.
class Obstacles {
 public:
  /// @param touch_mm distance up to which a tip counts as on the plane of a facet
  /// @pre the mesh's indices are valid
  explicit Obstacles(const surface::Mesh& mesh, double touch_mm = kTouchMm);

  [[nodiscard]] std::size_t count() const { return facets_.size(); }

  /// Returns the facet with the least clearance from a beam, among the facets with less clearance
  /// than `max_mm`. A beam only touches a facet whose plane contains the tip. A leaning beam with a
  /// waist would enter the floor under its tip. So facets whose plane contains the tip are ignored
  /// for a beam with a waist.
  [[nodiscard]] std::optional<NearestFacet> nearest(const Beam& beam, double max_mm) const;

  /// Returns whether a beam hits any facet. A touch at the tip is not a hit.
  [[nodiscard]] bool meets(const Beam& beam) const;

 private:
  double touch_mm_;
  std::vector<Triangle> facets_;
  surface::BoxTree tree_;
};

/// Returns the beam from a tip on the axis nearest to the wanted axis that clears all obstacles;
/// nothing if no axis within the rules clears all obstacles.
[[nodiscard]] std::optional<Beam> least_tilt(const Obstacles& obstacles,
                                             const Eigen::Vector3d& tip,
                                             const TiltRules& rules);

}  // namespace sim::wall
