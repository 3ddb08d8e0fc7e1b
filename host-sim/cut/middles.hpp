#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/cut/paths_beside.hpp"

namespace sim::cut {

/// Lines in the middle of waste that is narrower than the kerf, with the warning about them.
struct Middles {
  std::vector<std::vector<Stroke>> rows{};
  std::optional<drawing::Fault> warning{};
};

/// Returns the lines in the middle of narrow waste at outlines and between them. The cuts go no
/// farther into any outline than the settings of its contour allow. There are no lines if one of
/// these settings is 0, or if outlines cross.
/// @param contours numbers of the outlines that are cut at an offset with the same kerf, at least
/// one
[[nodiscard]] Middles middles_beside(const DrawnEdges& edges,
                                     const std::vector<std::size_t>& contours);

}  // namespace sim::cut
