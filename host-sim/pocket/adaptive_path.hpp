#pragma once

#include <optional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "host-sim/pocket/stock_box.hpp"
#include "planner/pocket/pocket_entry.hpp"

namespace sim::pocket {

struct AdaptiveOptions {
  double tool_radius_mm = 3.0;
  /// Greatest engagement: the angle of the tool's circumference that cuts.
  double engagement_deg = 60.0;
  double depth_mm = 1.0;  ///< Depth of the floor below the top.
  cnc::pocket::EntryKind entry = cnc::pocket::EntryKind::kHelix;
  /// Steepest descent of helices and ramps divided by their length, above 0, at most 1.
  double slope = 0.05;
  /// Greatest length of a return over cleared stock, mm; for a longer return the tool is lifted.
  double return_limit_mm = 100.0;
  /// The stock, if the area is that around a stock: see with_surroundings().
  std::optional<StockBox> stock{};
};

/// Returns the factor by which the feed may be raised so that chips are as thick as with half of
/// the tool or more engaged: 1 / sin(engagement), at least 1.
[[nodiscard]] double thin_chip_factor(double engagement_deg);

inline constexpr double kMinEngagementDeg = 10.0;
inline constexpr double kGreatestEngagementDeg = 150.0;

/// A stretch that is too narrow for crescents: there the tool cuts with more of its circumference.
struct NarrowStretch {
  std::vector<cnc::WideVec2> places;  ///< Points along the middle of the stretch, with both ends.
  double width_mm = 0.0;              ///< Least width.
  double length_mm = 0.0;             ///< Length along the middle.
};

/// A pocket that is cleared with bounded engagement.
struct AdaptivePath : PathRows {
  std::vector<NarrowStretch> narrow;
};

/// Pockets narrower than this number of tool diameters are cut as slots.
inline constexpr double kNarrowDiameters = 1.2;

/// Clears an area down to one depth. In each part that the tool reaches, it enters at the widest
/// point: by a helix or, where no helix fits, by a ramp along the medial axis (see enter_stock()).
/// Then it opens a disc by a spiral, and follows the medial axis by crescents. Crescents are arcs
/// of the largest circles that fit; the engagement limits the distance from one to the next.
/// Branches begin at cleared discs. The passes along the walls come last.
///
/// With a stock, discs that touch no stock count as cleared. Crescents begin, without an entry, at
/// the last of these discs before the stock, and only parts of the walls have passes.
///
/// Guarantee: the tool's centre keeps its radius from the boundary (1e-6 mm), and no stock is left
/// that the tool reaches. The engagement of each crescent against the previous disc alone is within
/// the limit in closed form; elements with this guarantee have Use::kLight. Exceptions are entries,
/// and stretches narrower than 1.2 diameters, which `narrow` lists. Among these are the tips of
/// cusps that are too sharp for crescents. All crescents turn left, which is climb milling. Links
/// between crescents lie in cleared discs and join them with one tangent. All other elements at one
/// depth also join with one tangent, except the passes along the walls, at the corners of their
/// locus.
///
/// Throws std::invalid_argument for options out of range, or if the tool fits nowhere. Throws
/// NoPocketPath where the tool could enter only straight down but must not, or where a part of a
/// wall is too short for a ramp. Throws std::runtime_error for contours that cross, and NoOffset.
[[nodiscard]] AdaptivePath adaptive_path(const cnc::contour::ContourView<double>& area,
                                         const AdaptiveOptions& options);

}  // namespace sim::pocket
