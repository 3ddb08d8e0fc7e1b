#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/adaptive_path.hpp"
#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/stock_box.hpp"
#include "tests/support/contour_oracle.hpp"

namespace proof {

/// What an adaptive path does, measured by everything that the tool has swept before: it knows of
/// lines and arcs, of no discs or crescents.
struct AdaptiveVerdict {
  double engagement_deg = 0.0;  ///< The greatest of passes, outside of narrow stretches.
  cnc::WideVec2 engaged_at{0.0, 0.0};
  double link_deg = 0.0;     ///< The same of links.
  double gouge_mm = -1e9;    ///< How far the tool reaches beyond a wall, at most.
  double left_mm = -1e9;     ///< How far from the tool a place stays that it could reach, at most.
  std::size_t excepted = 0;  ///< Places in narrow stretches.
  std::size_t judged = 0;    ///< Other places of passes.
};

/// @param stock all of it, where the area is what is around it; else stock is everywhere
[[nodiscard]] AdaptiveVerdict judge_adaptive(
    const cnc::contour::ContourView<double>& area,
    const sim::pocket::AdaptivePath& path,
    const sim::pocket::AdaptiveOptions& options,
    const std::optional<sim::pocket::StockBox>& stock = std::nullopt);

}  // namespace proof
