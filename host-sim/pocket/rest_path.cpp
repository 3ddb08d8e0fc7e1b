#include "host-sim/pocket/rest_path.hpp"

namespace sim::pocket {

StockParts rest_path(const cnc::contour::ContourView<double>& pocket,
                     double former_radius_mm,
                     const std::vector<Contour>& passes,
                     const PartOptions& options) {
  // Distance by which the cleared area is reduced, mm, far below kThinRestMm. If the locus of the
  // former tool were grown by exactly the tool's radius, the arcs of the locus around corners would
  // become points.
  constexpr double kLessMm = 1.0e-4;
  ContourOffset offsetter;
  const Contour locus = copy_of(offsetter.offset(pocket, -options.tool_radius_mm));
  const Contour former = copy_of(offsetter.offset(pocket, -former_radius_mm));
  const Contour cleared = copy_of(offsetter.offset(former.view(), former_radius_mm - kLessMm));
  const Contour idle =
      copy_of(offsetter.offset(cleared.view(), kThinRestMm - options.tool_radius_mm));
  const OwnedArea locus_area{locus.view()};
  const OwnedArea cleared_area{cleared.view()};
  const OwnedArea idle_area{idle.view()};
  return parts_in_stock(passes, {locus_area, cleared_area, idle_area}, options);
}

}  // namespace sim::pocket
