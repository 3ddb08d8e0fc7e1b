#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// The line around a job along which a frame program moves the head.
enum class FrameShape : std::uint8_t {
  kHull,  ///< The convex hull of all strokes.
  kBox,   ///< The upright rectangle around all strokes.
};

/// Settings of the program that traces a frame.
struct FrameSettings {
  FrameShape shape = FrameShape::kHull;
  double power_share = 0.0;     ///< Share of full power, 0…1. With 0 the beam is off.
  double feed_mm_min = 3000.0;  ///< Feed along the frame, above 0.
};

/// Greatest distance between a frame and the exact line around the strokes, mm. It allows chords to
/// replace arcs.
inline constexpr double kFrameToleranceMm = 0.01;

/// Returns the corners of the line around all strokes of a plan, leads included, counter-clockwise.
/// The paths for a controller that computes compensated paths itself are included, too. Empty if
/// there are no strokes.
[[nodiscard]] std::vector<Place> frame_of(const CutPlan& plan, FrameShape shape);

/// Returns the program that traces a frame once and returns to zero. Without power, the program
/// never switches the beam on. Throws std::invalid_argument if a point is out of the range of a
/// program.
/// @param frame result of frame_of(), with at least one corner
/// @param heading lines of comment at the top
[[nodiscard]] std::string frame_program(const std::vector<Place>& frame,
                                        const FrameSettings& settings,
                                        const Beam& beam,
                                        cnc::gcode::PrintGrid grid,
                                        const std::vector<std::string>& heading);

}  // namespace sim::cut
