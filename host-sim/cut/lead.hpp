#pragma once

#include <optional>
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

/// Both leads of a cut that begins at a point of its contour; nothing where none are required.
struct Leads {
  std::optional<Stroke> in{};
  std::optional<Stroke> out{};
};

/// Returns the leads at `share` of their length, room or not.
/// @param way_mm along the loop to where the cut begins
[[nodiscard]] Leads leads_at(const MeasuredRow& loop,
                             double way_mm,
                             const LayerSettings& settings,
                             double share);

/// Returns whether both leads keep clear of all parts.
[[nodiscard]] bool have_room(const Leads& leads, const LeadRoom& room);

/// Where a closed loop is begun, and what the rapids before and after it see of that.
struct Beginning {
  double way_mm = 0.0;        ///< Along the loop.
  bool has_leads = true;      ///< False where none that are required have room.
  double lead_share = 1.0;    ///< Of their length.
  bool is_backwards = false;  ///< Of an open line: it is cut from its end to its start.
  Place entry{0.0, 0.0};      ///< Where the first stroke begins.
  Place exit{0.0, 0.0};       ///< Where the last stroke ends.
};

struct LedCut {
  std::vector<Stroke> strokes{};
  bool has_leads = false;   ///< Or there was no room for those that were asked for.
  double lead_share = 1.0;  ///< Of the length that was asked for.
  unsigned tabs = 0;        ///< As many as have room.
  CornerWork corners{};
};

/// A closed row of strokes with the part on its left, as a cut: led in from the waste on the right,
/// with the beam off at tabs, overcut and led out; then corners are treated. An arc is a quarter
/// turn and touches the contour, a line comes at 45 degrees.
/// With StartAt::kTab the last tab ends where the cut began, and there is no overcut and no lead
/// out.
/// @param tabs their number, evenly spaced; fewer where they would take half of the cut
[[nodiscard]] LedCut with_leads(const MeasuredRow& loop,
                                const LayerSettings& settings,
                                unsigned tabs,
                                const LeadRoom& room,
                                const Beginning& beginning);

}  // namespace sim::cut
