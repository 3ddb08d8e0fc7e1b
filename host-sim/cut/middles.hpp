#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/cut/paths_beside.hpp"

namespace sim::cut {

/// Lines in the middle of waste that is narrower than the kerf, and a warning that tells of them.
struct Middles {
  std::vector<std::vector<Stroke>> rows{};
  std::optional<drawing::Fault> warning{};
};

/// Returns the lines in the middle of narrow waste beside outlines, and between them, which go no
/// farther into any of them than its settings allow; none where one of them allows nothing, or
/// where outlines cross.
/// @param contours numbers of outlines that are cut beside their lines with one kerf, one at least
[[nodiscard]] Middles middles_beside(const DrawnEdges& edges,
                                     const std::vector<std::size_t>& contours);

}  // namespace sim::cut
