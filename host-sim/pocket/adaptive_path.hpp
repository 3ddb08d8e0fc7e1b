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
  /// Greatest engagement, degrees: the angle of the tool's circumference that touches stock.
  double engagement_deg = 60.0;
  double depth_mm = 1.0;  ///< Depth of the floor below the top of the stock, mm.
  cnc::pocket::EntryKind entry = cnc::pocket::EntryKind::kHelix;
  /// Steepest slope of helices and ramps: descent divided by length, above 0, at most 1.
  double slope = 0.05;
  /// Greatest length of a return over cleared stock, mm. For a longer return, the tool is lifted.
  double return_limit_mm = 100.0;
  /// Outline of the stock; set only if the area comes from with_surroundings().
  std::optional<StockBox> stock{};
};

/// Returns the factor by which the feed may be raised so that chips become as thick as with an
/// engagement of 90 degrees or more. The factor is 1 / sin(engagement), at least 1.
[[nodiscard]] double thin_chip_factor(double engagement_deg);

inline constexpr double kMinEngagementDeg = 10.0;
inline constexpr double kGreatestEngagementDeg = 150.0;

/// A stretch that is too narrow for crescents. In it, the engagement exceeds the limit.
struct NarrowStretch {
  /// Points along the middle of the stretch, including both ends.
  std::vector<cnc::WideVec2> places;
  double width_mm = 0.0;   ///< Least width of the stretch, mm.
  double length_mm = 0.0;  ///< Length along the middle of the stretch, mm.
};

/// The path of a pocket that is cleared with bounded engagement.
struct AdaptivePath : PathRows {
  std::vector<NarrowStretch> narrow;
};

/// A pocket or stretch that is narrower than this number of tool diameters is cut as a slot.
inline constexpr double kNarrowDiameters = 1.2;

/// Clears an area down to one depth. In each part that the tool reaches, the tool enters at the
/// widest point: by a helix or, where no helix fits, by a ramp along the medial axis (see
/// enter_stock()). Then the tool opens a disc by a spiral, and follows the medial axis by
/// crescents. Crescents are arcs of the largest circles that fit; the engagement limits the
/// distance from one crescent to the next. Branches of the axis begin at cleared discs. The passes
/// along the walls come last.
///
/// If a stock is given, discs that touch no stock count as cleared. Crescents begin, without an
/// entry, at the last of these discs before the stock. Only those parts of the walls that touch
/// stock have passes.
///
/// Guarantee: the tool's centre keeps a distance of the tool's radius from the boundary (within
/// 1e-6 mm), and the tool leaves no stock that it reaches. The engagement of each crescent,
/// computed against the previous disc alone in closed form, is within the limit. Elements with this
/// guarantee have Use::kLight. Exceptions are entries, and stretches narrower than 1.2 diameters,
/// which `narrow` lists. These stretches include the tips of cusps that are too sharp for
/// crescents. All crescents turn left, which is climb milling. Links between crescents lie in
/// cleared discs and join the crescents with one tangent. All other elements at one depth also join
/// with one tangent. The exceptions are the passes along the walls, at the corners of the locus of
/// the tool's centre.
///
/// Throws std::invalid_argument for options out of range, or if the tool fits nowhere. Throws
/// NoPocketPath if the tool could enter only straight down but must not plunge, or if a part of a
/// wall is too short for a ramp. Throws std::runtime_error for contours that cross, and NoOffset.
[[nodiscard]] AdaptivePath adaptive_path(const cnc::contour::ContourView<double>& area,
                                         const AdaptiveOptions& options);

}  // namespace sim::pocket
