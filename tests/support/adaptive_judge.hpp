#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/adaptive_path.hpp"
#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/stock_box.hpp"
#include "tests/support/contour_oracle.hpp"

namespace proof {

/// Figures of an adaptive path, measured against everything that the tool has swept before. The
/// judge uses only lines and arcs, not the discs and crescents from which the planner built the
/// path.
struct AdaptiveVerdict {
  double engagement_deg = 0.0;  ///< Greatest engagement in a pass outside of narrow stretches.
  cnc::WideVec2 engaged_at{0.0, 0.0};
  double link_deg = 0.0;   ///< Greatest engagement in a link.
  double gouge_mm = -1e9;  ///< Greatest distance by which the tool reaches beyond a wall.
  /// Greatest distance from the swept area to a point that the tool could reach.
  double left_mm = -1e9;
  std::size_t excepted = 0;  ///< Number of sampled points in narrow stretches.
  std::size_t judged = 0;    ///< Number of all other sampled points of passes.
};

/// Judges a path.
/// @param stock the whole stock, if `area` includes its surroundings; without it, stock is
/// everywhere
[[nodiscard]] AdaptiveVerdict judge_adaptive(
    const cnc::contour::ContourView<double>& area,
    const sim::pocket::AdaptivePath& path,
    const sim::pocket::AdaptiveOptions& options,
    const std::optional<sim::pocket::StockBox>& stock = std::nullopt);

}  // namespace proof
