#pragma once

#include <string>

#include "host-sim/plot/cut_layers.hpp"

namespace sim {

struct AnimationOptions {
  /// A job that takes longer than this is shown faster, in exactly this time, s > 0. A shorter job
  /// is shown in real time.
  double max_seconds = 30.0;
};

/// Greatest number of strokes with which each cut grows along the beam. With more strokes, each cut
/// appears when it is finished, and the beam's path is simplified.
inline constexpr std::size_t kMaxGrowingStrokes = 5'000;
/// Greatest number of points that the beam passes in the animation.
inline constexpr std::size_t kMaxBeamPlaces = 20'000;

/// Returns an SVG document that plays a job again and again. The beam runs along rapids and cuts by
/// the times of the timeline, lines appear as they are cut, and a clock shows the time of the job.
/// The document uses only SVG's own animation (SMIL), and no script. A viewer without animation
/// shows the finished job.
/// @pre the scene has a timeline
[[nodiscard]] std::string animate_cuts(const CutScene& scene,
                                       const std::string& title,
                                       const AnimationOptions& options);

}  // namespace sim
