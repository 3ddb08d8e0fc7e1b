#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Shortest length of a stretch that is left out because it runs along another line, mm. Shorter
/// stretches are driven twice.
inline constexpr double kShortestDoubledMm = 0.2;

/// The lines that remain after stretches along other lines are left out.
struct LeftLines {
  /// For each contour of which a stretch is left out, its remaining lines: open rows in the
  /// contour's order; empty if nothing remains.
  std::map<std::size_t, std::vector<std::vector<Stroke>>> rests{};
  /// Warning with the length that is left out and the first point; nothing if all lines remain.
  std::optional<drawing::Fault> warning{};
};

/// Leaves out stretches of lines that are cut or engraved on the line and that run along another
/// line, at a distance of at most kTouchesMm and in either direction. An edge that is cut next to
/// its line has precedence over a line that is cut, and this over a line that is engraved. Among
/// lines of equal precedence, the first one drawn stays. A line that runs back along itself is
/// driven once.
/// @param outlines outline of each contour
/// @param sides side of each contour; filled contours are not compared
[[nodiscard]] LeftLines without_doubled(const drawing::Drawing& drawn,
                                        const std::vector<Outline>& outlines,
                                        const std::vector<Side>& sides);

}  // namespace sim::cut
