#pragma once

#include <Eigen/Geometry>
#include <boost/polygon/polygon.hpp>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/mesh.hpp"
#include "host-sim/wall/layer/section_sweep.hpp"
#include "host-sim/wall/layer/whole_grid.hpp"

namespace sim::wall {

/// The area in which a part overhangs material below it.
struct Undercut {
  double area_mm2 = 0.0;  ///< Area in plan that no beam from above reaches.
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< Middle of the largest overhanging facet.
};

/// The shadow, in plan, of the part above a plane that is lowered step by step.
///
/// The shadow consists of the section of the part with the plane and of the area that
/// downward-facing facets above the plane hide.
class FallingShadow {
 public:
  /// @param part must outlive this object
  /// @pre require_solid() accepts the part
  FallingShadow(const surface::Mesh& part, const Eigen::AlignedBox2d& stock);

  /// Lowers the plane to a height, mm. Returns the areas of the stock outside the shadow. Throws
  /// std::invalid_argument if the part intersects itself so that no valid section can be found.
  [[nodiscard]] std::vector<Contour> lower_to(double height_mm);

  /// Returns the undercut: the area by which the shadow exceeds the last section, and the middle of
  /// the largest overhanging facet.
  [[nodiscard]] Undercut undercut() const;

 private:
  using PolygonSet = boost::polygon::polygon_set_data<int>;

  [[nodiscard]] double top_of(std::uint32_t facet) const;
  void insert(const SectionLoop& loop, PolygonSet& set) const;
  void pass_facets(double height_mm);
  [[nodiscard]] SectionLoop part_above(std::uint32_t facet, double height_mm) const;

  const surface::Mesh* part_;
  WholeGrid grid_;
  std::pair<WholePoint, WholePoint> stock_;  ///< Lower and upper corner of the stock.
  SectionSweep sweep_;
  /// Area hidden by overhanging facets that are completely above the plane.
  PolygonSet hidden_;
  double section_area_ = 0.0;  ///< Area of the last section, in squares of the grid.
  double shadow_area_ = 0.0;
  /// Facets that face downwards, sorted by their highest point, the highest first.
  std::vector<std::uint32_t> overhanging_;
  /// Number of overhanging facets that reach above the plane.
  std::size_t passed_ = 0;
  std::vector<std::uint32_t> open_;  ///< Overhanging facets that the plane crosses.
};

}  // namespace sim::wall
