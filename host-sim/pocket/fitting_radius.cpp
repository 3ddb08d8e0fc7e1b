#include "host-sim/pocket/fitting_radius.hpp"

#include <cstddef>

#include "planner/pocket/loop_driver.hpp"

namespace sim::pocket {
namespace {

/// Returns the length of the boundary of the locus of the tool's centre, mm; 0 where the tool fits
/// nowhere.
double locus_length(const cnc::contour::ContourView<double>& pocket,
                    double radius_mm,
                    ContourOffset& offsetter) {
  const cnc::contour::ContourView<double> locus = offsetter.offset(pocket, -radius_mm);
  double length = 0.0;
  for (std::size_t loop = 0; loop < locus.loop_ends.size(); ++loop) {
    length += cnc::pocket::loop_length(locus, loop);
  }
  return length;
}

}  // namespace

/// Compares a slightly smaller and a slightly larger tool. In a slot as wide as the tool, the locus
/// of the smaller tool leads into the slot and back; that of the larger tool does not. With the
/// tool's own radius, rounding would decide.
double fitting_radius(const cnc::contour::ContourView<double>& pocket,
                      double tool_radius_mm,
                      ContourOffset& offsetter) {
  constexpr double kSlackMm = 0.5 * kSlotSlackMm;
  const double smaller_mm = locus_length(pocket, tool_radius_mm - kSlackMm, offsetter);
  if (smaller_mm == 0.0) return 0.0;
  const double greater_mm = locus_length(pocket, tool_radius_mm + kSlackMm, offsetter);
  const bool has_slot = greater_mm == 0.0 || smaller_mm - greater_mm > 2.0 * tool_radius_mm;
  return has_slot ? tool_radius_mm - kSlackMm : tool_radius_mm;
}

}  // namespace sim::pocket
