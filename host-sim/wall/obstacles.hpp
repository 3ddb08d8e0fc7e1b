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

/// A facet, and how far a beam is from it.
struct NearestFacet {
  std::uint32_t facet = 0;
  Triangle obstacle;          ///< As it stands in the way of the beam.
  double clearance_mm = 0.0;  ///< Below 0 where the beam meets it.
};

/// The facets of a part, sorted so that those near a beam are found soon. Lengths are mm.
class Obstacles {
 public:
  /// @param touch_mm distance up to which a tip is on the plane of a facet
  /// @pre the mesh's indices are those of points
  explicit Obstacles(const surface::Mesh& mesh, double touch_mm = kTouchMm);

  [[nodiscard]] std::size_t count() const { return facets_.size(); }

  /// Returns the facet that a beam is nearest to or deepest in, among those that it is nearer to
  /// than `most_mm`; facets with the tip on their plane only touch it there. A beam with a waist
  /// dips into the floor that its tip is on as it leans: such facets do not count for it.
  [[nodiscard]] std::optional<NearestFacet> nearest(const Beam& beam, double most_mm) const;

  /// Returns whether a beam meets any facet by more than a touch at its tip.
  [[nodiscard]] bool meets(const Beam& beam) const;

 private:
  double touch_mm_;
  std::vector<Triangle> facets_;
  surface::BoxTree tree_;
};

/// Returns the beam from a tip on the axis nearest to the wanted one that clears all obstacles;
/// nothing where there is none within the rules.
[[nodiscard]] std::optional<Beam> least_tilt(const Obstacles& obstacles,
                                             const Eigen::Vector3d& tip,
                                             const TiltRules& rules);

}  // namespace sim::wall
