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

/// A place where the part overhangs what is below it.
struct Undercut {
  double area_mm2 = 0.0;  ///< That no beam from above reaches, seen from above.
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< On the largest overhanging facet.
};

/// The part above a falling plane as it is seen from above.
///
/// It is the section of the part, and all that facets which look down hide below them.
class FallingShadow {
 public:
  /// @param part must outlive this @pre require_solid() accepts it
  FallingShadow(const surface::Mesh& part, const Eigen::AlignedBox2d& stock);

  /// Lets the plane fall to a height, mm. Returns the areas of the stock that nothing is above.
  /// Throws std::invalid_argument for a part that crosses itself beyond repair.
  [[nodiscard]] std::vector<Contour> lower_to(double height_mm);

  /// Returns by how much the shadow is larger than the last section.
  [[nodiscard]] Undercut undercut() const;

 private:
  using PolygonSet = boost::polygon::polygon_set_data<int>;

  [[nodiscard]] double top_of(std::uint32_t facet) const;
  void insert(const SectionLoop& loop, PolygonSet& set) const;
  void pass_facets(double height_mm);
  [[nodiscard]] SectionLoop part_above(std::uint32_t facet, double height_mm) const;

  const surface::Mesh* part_;
  WholeGrid grid_;
  std::pair<WholePoint, WholePoint> stock_;  ///< Least and greatest corner.
  SectionSweep sweep_;
  PolygonSet hidden_;          ///< By overhanging facets that are wholly above the plane.
  double section_area_ = 0.0;  ///< That of the last section, in squares of the grid.
  double shadow_area_ = 0.0;
  std::vector<std::uint32_t> overhanging_;  ///< Facets that look down, the highest first.
  std::size_t passed_ = 0;                  ///< Those of them that reach above the plane.
  std::vector<std::uint32_t> open_;         ///< Those of these that the plane crosses.
};

}  // namespace sim::wall
