#pragma once

#include <optional>
#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/corner.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Tolerance for measuring whether the beam is clear of parts, mm. A beam along its own contour has
/// no distance to spare.
inline constexpr double kClearSlackMm = 1.0e-5;
/// Length of the path that a pierce takes, mm. It is too short to be visible, and long enough for
/// the motors to make steps.
inline constexpr double kPierceWayMm = 0.1;

/// The space that must stay free of leads.
struct LeadRoom {
  const Clearance& parts;   ///< The drawn edges of all parts.
  double half_kerf_mm = 0;  ///< Minimum distance between a lead and the edges of `parts`.
};

/// The leads of a cut that begins at a certain point of its contour. A lead that is not required is
/// empty.
struct Leads {
  std::optional<Stroke> in{};
  std::optional<Stroke> out{};
};

/// Returns the leads at `share` of their set length. Does not check that they have free space.
/// @param way_mm distance along the loop to the beginning of the cut
[[nodiscard]] Leads leads_at(const MeasuredRow& loop,
                             double way_mm,
                             const LayerSettings& settings,
                             double share);

/// Returns whether both leads have free space, that is, keep their distance from all parts.
[[nodiscard]] bool have_room(const Leads& leads, const LeadRoom& room);

/// A point at which the cut of a closed loop or of a line may begin. It includes the points where
/// the rapid to the cut ends and where the rapid from the cut begins.
struct Beginning {
  double way_mm = 0.0;        ///< Distance along the loop to this point.
  bool has_leads = true;      ///< Whether the required leads have free space.
  double lead_share = 1.0;    ///< Share of the set length that the leads have.
  bool is_backwards = false;  ///< Whether an open line is cut from its end to its start.
  Place entry{0.0, 0.0};      ///< Point where the first stroke begins.
  Place exit{0.0, 0.0};       ///< Point where the last stroke ends.
};

struct LedCut {
  std::vector<Stroke> strokes{};
  bool has_leads = false;   ///< Whether the required leads have free space.
  double lead_share = 1.0;  ///< Share of the set length that the leads have.
  unsigned tabs = 0;        ///< Number of tabs for which there is enough space.
  CornerWork corners{};
};

/// Makes a cut of a closed row of strokes with the part on its left. The cut leads in from the
/// waste on the right, has the beam off along tabs, overcuts and leads out. Then its corners are
/// treated. A lead that is an arc makes a quarter turn and is tangential to the contour. A lead
/// that is a line is at 45 degrees to the contour. With StartAt::kTab the last tab ends where the
/// cut began, and there is no overcut and no lead-out.
/// @param tabs number of tabs, evenly spaced. Fewer are made if these would take half of the cut
[[nodiscard]] LedCut with_leads(const MeasuredRow& loop,
                                const LayerSettings& settings,
                                unsigned tabs,
                                const LeadRoom& room,
                                const Beginning& beginning);

}  // namespace sim::cut
