#pragma once

#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/corner.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// The beam is measured to be clear within this; the contour itself just is, mm.
inline constexpr double kClearSlackMm = 1.0e-5;
/// Under which a pierce takes its time: too short to see, long enough to take steps, mm.
inline constexpr double kPierceWayMm = 0.1;

/// Where a lead must not be.
struct LeadRoom {
  const Clearance& parts;   ///< All drawn edges of parts.
  double half_kerf_mm = 0;  ///< No nearer to any of them.
};

struct LedCut {
  std::vector<Stroke> strokes{};
  bool has_leads = false;   ///< Or there was no room for those that were asked for.
  double lead_share = 1.0;  ///< Of the length that was asked for.
  unsigned tabs = 0;        ///< As many as have room.
  CornerWork corners{};
};

/// A closed row of strokes with the part on its left, as a cut: begun where there is room for the
/// leads, in the middle of a long stroke rather than at a corner, led in from the waste on the
/// right, with the beam off at tabs, overcut and led out. Leads are shortened to an eighth before
/// they are left out; then corners are treated. An arc is a quarter turn and touches the contour, a
/// line comes at 45 degrees.
/// @param tabs their number, evenly spaced; fewer where they would take half of the cut
[[nodiscard]] LedCut with_leads(const MeasuredRow& loop,
                                const LayerSettings& settings,
                                unsigned tabs,
                                const LeadRoom& room);

}  // namespace sim::cut
