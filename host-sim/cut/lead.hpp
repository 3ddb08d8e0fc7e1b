#pragma once

#include <optional>
#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/corner.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Tolerance for measuring whether the beam is clear of parts, mm. A beam along the contour itself
/// is just clear.
inline constexpr double kClearSlackMm = 1.0e-5;
/// Length of the path during which a pierce takes its time, mm: too short to see, long enough to
/// need steps.
inline constexpr double kPierceWayMm = 0.1;

/// The space that leads must not enter.
struct LeadRoom {
  const Clearance& parts;   ///< All drawn edges of parts.
  double half_kerf_mm = 0;  ///< Least distance between a lead and any of these edges.
};

/// Both leads of a cut that begins at a point of its contour; a lead that is not required is empty.
struct Leads {
  std::optional<Stroke> in{};
  std::optional<Stroke> out{};
};

/// Returns the leads at `share` of their length, without a check of their free space.
/// @param way_mm distance along the loop to the beginning of the cut
[[nodiscard]] Leads leads_at(const MeasuredRow& loop,
                             double way_mm,
                             const LayerSettings& settings,
                             double share);

/// Returns whether both leads keep clear of all parts.
[[nodiscard]] bool have_room(const Leads& leads, const LeadRoom& room);

/// The beginning of a closed loop or line, with the points where the adjacent rapids end and begin.
struct Beginning {
  double way_mm = 0.0;        ///< Distance along the loop.
  bool has_leads = true;      ///< False if no required lead has free space.
  double lead_share = 1.0;    ///< Share of the leads' set length.
  bool is_backwards = false;  ///< Direction of an open line: it is cut from its end to its start.
  Place entry{0.0, 0.0};      ///< Point where the first stroke begins.
  Place exit{0.0, 0.0};       ///< Point where the last stroke ends.
};

struct LedCut {
  std::vector<Stroke> strokes{};
  bool has_leads = false;   ///< False if there was no free space for the required leads.
  double lead_share = 1.0;  ///< Share of the required length.
  unsigned tabs = 0;        ///< Number of tabs, as many as have free space.
  CornerWork corners{};
};

/// Makes a cut of a closed row of strokes with the part on its left. The cut leads in from the
/// waste on the right, has the beam off at tabs, overcuts and leads out. Then its corners are
/// treated. A lead that is an arc makes a quarter turn and is tangential to the contour. A line
/// meets the contour at 45 degrees. With StartAt::kTab the last tab ends where the cut began, and
/// there is no overcut and no lead-out.
/// @param tabs number of tabs, evenly spaced; fewer if they would take half of the cut
[[nodiscard]] LedCut with_leads(const MeasuredRow& loop,
                                const LayerSettings& settings,
                                unsigned tabs,
                                const LeadRoom& room,
                                const Beginning& beginning);

}  // namespace sim::cut
