#pragma once

#include <string>

#include "host-sim/plot/cut_layers.hpp"

namespace sim {

struct AnimationOptions {
  /// A job that takes longer is shown faster, in this time, s > 0; a shorter one as fast as it is.
  double max_seconds = 30.0;
};

/// Cuts of up to this many strokes grow along the beam; of more, each cut appears when it is
/// finished, and the beam's path is simplified.
inline constexpr std::size_t kMaxGrowingStrokes = 5'000;
/// Places that the beam passes in the animation.
inline constexpr std::size_t kMaxBeamPlaces = 20'000;

/// SVG document that plays a job over and over: the beam runs along rapids and cuts by the times of
/// the timeline, lines appear as they are cut, and a clock shows the time of the job. Nothing but
/// SVG's own animation (SMIL) is in it, no script; a viewer without animation shows the finished
/// job. @pre the scene has a timeline
[[nodiscard]] std::string animate_cuts(const CutScene& scene,
                                       const std::string& title,
                                       const AnimationOptions& options);

}  // namespace sim
