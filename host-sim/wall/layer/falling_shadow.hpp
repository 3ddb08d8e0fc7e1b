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

/// A place where the part overhangs material below it.
struct Undercut {
  double area_mm2 = 0.0;  ///< Area in plan that no beam from above reaches.
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< Point on the largest overhanging facet.
};

/// The part above a falling plane, as seen from above.
///
/// The shadow consists of the section of the part and of everything that downward-facing facets
/// hide below them.
class FallingShadow {
 public:
  /// @param part the part; it outlives this object
  /// @pre require_solid() accepts the part
  FallingShadow(const surface::Mesh& part, const Eigen::AlignedBox2d& stock);

  /// Lowers the plane to a height, mm. Returns the areas of the stock that have no part of the
  /// solid above them. Throws std::invalid_argument for a part that crosses itself beyond repair.
  [[nodiscard]] std::vector<Contour> lower_to(double height_mm);

  /// Returns the undercut: the area by which the shadow exceeds the last section, and a point on
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
  std::pair<WholePoint, WholePoint> stock_;  ///< Least and greatest corner of the stock.
  SectionSweep sweep_;
  /// Area hidden by overhanging facets that are completely above the plane.
  PolygonSet hidden_;
  double section_area_ = 0.0;  ///< Area of the last section, in squares of the grid.
  double shadow_area_ = 0.0;
  std::vector<std::uint32_t> overhanging_;  ///< Facets that face downwards, the highest first.
  /// Number of overhanging facets that reach above the plane.
  std::size_t passed_ = 0;
  std::vector<std::uint32_t> open_;  ///< Overhanging facets that the plane crosses.
};

}  // namespace sim::wall
