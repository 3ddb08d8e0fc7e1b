#pragma once

#include <string>

#include "host-sim/plot/cut_layers.hpp"

namespace sim {

struct AnimationOptions {
  /// Greatest duration of the animation, s, above 0. A longer job is shown faster, in exactly this
  /// time. A shorter job is shown in real time.
  double max_seconds = 30.0;
};

/// Greatest number of strokes of a job for which each cut grows along with the beam. If there are
/// more strokes, cuts appear when they are finished, and the path of the beam is simplified.
inline constexpr std::size_t kMaxGrowingStrokes = 5'000;
/// Greatest number of points of the path of the beam in the animation.
inline constexpr std::size_t kMaxBeamPlaces = 20'000;

/// Returns an SVG document that plays a job repeatedly. The beam moves along rapids and cuts by the
/// times of the timeline. Lines appear while they are cut, and a clock shows the time of the job.
/// The document is animated by SMIL, which is a part of SVG, without any script. A viewer without
/// animation shows the finished job.
/// @pre the scene has a timeline
[[nodiscard]] std::string animate_cuts(const CutScene& scene,
                                       const std::string& title,
                                       const AnimationOptions& options);

}  // namespace sim
