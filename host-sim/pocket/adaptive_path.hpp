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
  /// The greatest angle of the tool's circumference that cuts.
  double engagement_deg = 60.0;
  double depth_mm = 1.0;  ///< Depth of the floor below the top.
  cnc::pocket::EntryKind entry = cnc::pocket::EntryKind::kHelix;
  double slope = 0.05;  ///< Steepest descent over length of helices and ramps, 0…1 without 0.
  /// How far the tool may return over cleared stock instead of being lifted, mm.
  double return_limit_mm = 100.0;
  /// The stock, where the area is what is around it: see with_surroundings().
  std::optional<StockBox> stock{};
};

/// By how much the feed may be raised so that chips are as thick as with half of the tool engaged
/// or more: 1 / sin(engagement), at least 1.
[[nodiscard]] double thin_chip_factor(double engagement_deg);

inline constexpr double kLeastEngagementDeg = 10.0;
inline constexpr double kGreatestEngagementDeg = 150.0;

/// A stretch that is too narrow for crescents, where the tool cuts with more of its circumference.
struct NarrowStretch {
  std::vector<cnc::WideVec2> places;  ///< Along its middle, both ends among them.
  double width_mm = 0.0;              ///< The least.
  double length_mm = 0.0;             ///< Along its middle.
};

/// A pocket that is cleared with bounded engagement.
struct AdaptivePath : PathRows {
  std::vector<NarrowStretch> narrow;
};

/// Pockets narrower than this many diameters of the tool are cut as slots.
inline constexpr double kNarrowDiameters = 1.2;

/// Clears an area down to one depth. In each part that the tool reaches it enters at the widest
/// place, by a helix or, where none fits, by a ramp along the medial axis (see enter_stock()),
/// opens a disc by a spiral, and follows the medial axis by crescents: arcs of the largest circles
/// that fit, each as far from the one before it as the engagement allows. Branches begin at discs
/// that are cleared. Last come passes along the walls.
///
/// With a stock, discs that meet none of it are cleared already: crescents begin at the last of
/// them on the way into the stock, without an entry, and only parts of the walls have passes.
///
/// Guarantee: the tool's centre keeps its radius from the boundary (1e-6 mm); stock is left
/// nowhere that the tool reaches. The engagement is within the limit in closed form for each
/// crescent against the disc before it alone, except in entries and in stretches narrower than 1.2
/// diameters, which are listed, the tips of cusps among them that are too sharp for crescents: what
/// has it is Use::kLight. All crescents turn left, which is climb
/// milling. Links between them lie in discs that are cleared, and meet them with one tangent. So do
/// all other elements at one depth but the passes along the walls, at the corners of their locus.
///
/// Throws std::invalid_argument for options out of range, or if the tool fits nowhere, NoPocketPath
/// where it fits in only straight down and must not, or a part of a wall is too short for a ramp,
/// std::runtime_error for contours that cross, and NoOffset.
[[nodiscard]] AdaptivePath adaptive_path(const cnc::contour::ContourView<double>& area,
                                         const AdaptiveOptions& options);

}  // namespace sim::pocket
