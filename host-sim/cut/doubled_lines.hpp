#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/outlines.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Shorter stretches of lines that run along others are driven twice, mm.
inline constexpr double kShortestDoubledMm = 0.2;

/// Lines without the stretches along which another line is cut.
struct LeftLines {
  /// By contour of which a stretch is left out: what is left of its line, open rows in its order;
  /// empty where nothing is.
  std::map<std::size_t, std::vector<std::vector<Stroke>>> rests{};
  std::optional<drawing::Fault> warning{};  ///< How much is left out, and where first.
};

/// Leaves out stretches of lines that are cut or engraved on the line where they run along another
/// line, in either direction and within kTouchesMm: an edge that is cut beside goes before a line
/// that is cut, that before one that is engraved, and of the rest the one drawn first. A line that
/// runs back along itself is driven once.
/// @param outlines by contour
/// @param sides by contour; filled ones are not compared
[[nodiscard]] LeftLines without_doubled(const drawing::Drawing& drawn,
                                        const std::vector<Outline>& outlines,
                                        const std::vector<Side>& sides);

}  // namespace sim::cut
