#pragma once

#include <string>

#include "host-sim/plot/cut_layers.hpp"
#include "host-sim/plot/key_frames.hpp"

namespace sim {

/// Greatest number of groups in which simplified cuts appear. If there are more cuts, several cuts
/// share a group.
inline constexpr std::size_t kMaxAnimatedCuts = 2'000;

/// Appends each cut as a line that grows while the beam moves along it.
/// @pre the scene has a timeline
void add_growing_cuts(std::string& out,
                      const CutScene& scene,
                      const View& view,
                      const AnimationTime& time);

/// Appends simplified cuts in groups. Each group appears when its last cut is finished.
/// @pre the scene has a timeline
void add_appearing_cuts(std::string& out,
                        const CutScene& scene,
                        const View& view,
                        const AnimationTime& time);

}  // namespace sim
