#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// The line around a job that a frame program traces.
enum class FrameShape : std::uint8_t {
  kHull,  ///< The convex hull of all strokes.
  kBox,   ///< The upright rectangle around them.
};

/// How a frame is traced.
struct FrameSettings {
  FrameShape shape = FrameShape::kHull;
  double power_share = 0.0;     ///< Of full power, 0…1; 0: beam off.
  double feed_mm_min = 3000.0;  ///< Above 0.
};

/// Greatest distance of a frame from the exact line around the strokes, mm: arcs are taken as
/// chords that leave them by this at most.
inline constexpr double kFrameToleranceMm = 0.01;

/// Returns the corners of the line around all strokes of a plan, leads included, anticlockwise. The
/// path given to a controller that finds the way beside parts itself counts as well. Empty without
/// strokes.
[[nodiscard]] std::vector<Place> frame_of(const CutPlan& plan, FrameShape shape);

/// Returns the program that traces a frame once and returns to zero. Without power the beam is
/// never switched on. Throws std::invalid_argument for places that no program can have.
/// @param frame as frame_of() returns it, with a corner at least
/// @param heading lines of comment at the top
[[nodiscard]] std::string frame_program(const std::vector<Place>& frame,
                                        const FrameSettings& settings,
                                        const Beam& beam,
                                        cnc::gcode::PrintGrid grid,
                                        const std::vector<std::string>& heading);

}  // namespace sim::cut
