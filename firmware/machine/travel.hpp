#pragma once

#include <cstdint>

#include "firmware/machine/settings.hpp"
#include "planner/gcode/interpreter.hpp"
#include "planner/geometry/path_element.hpp"
#include "planner/kinematics/tool_centre.hpp"
#include "planner/motion/block/limits.hpp"
#include "planner/pipeline/action_elements.hpp"

namespace cnc {

/// The room that the axes have between their ends, machine coordinates: what
/// the soft limits ($20) keep every motion inside.
///
/// Only axes that have been homed are judged, as of the others nobody knows
/// where the ends are; endless ones (travel 0) never.
class Travel {
 public:
  /// The machine by which a tip under G43.4 moves the axes.
  struct FiveAxes {
    const kinematics::ToolCentre& centre;
    const motion::Limits& limits;
  };

  /// @param homed bit i for axis i.
  void configure(const Settings& settings, std::uint8_t homed);

  /// Whether a motion of these actions, begun at `from`, would leave it; of an
  /// arc or a spline its true extremes count.
  [[nodiscard]] bool left_by(gcode::Actions actions, const Position& from) const;
  /// Returns whether motions of a tip would take the axes out of it, or the tilting axis out of its
  /// limits, which hold without homing, too. Axes may be taken for outside at less than 0.2 mm from
  /// the end of the travel on lines of 100 mm and arcs.
  /// @param elements is used to divide the actions, and cleared
  /// @pre centre.active(); the actions are lines and arcs; elements are not active
  [[nodiscard]] bool left_by(gcode::Actions actions,
                             const Position& from,
                             const FiveAxes& machine,
                             ActionElements& elements) const;
  /// Whether a place is inside.
  [[nodiscard]] bool holds(const Position& place) const { return contains(place); }
  /// The place inside that is nearest, axis by axis.
  [[nodiscard]] Position clamped(const Position& place) const;

 private:
  [[nodiscard]] bool contains(const Position& place) const;
  [[nodiscard]] bool contains_axes(const PathElement& element, const FiveAxes& machine) const;
  [[nodiscard]] bool contains_spline(const Position& start, const gcode::Action& spline) const;
  [[nodiscard]] bool contains_arc(const Position& start, const gcode::Action& arc) const;

  std::uint8_t judged_ = 0;
  Position least_{};
  Position most_{};
};

/// From here to there lies the travel of an axis, machine coordinates: as in
/// Grbl the machine lies on the negative side of zero; where homing sets the
/// origin ($22 bit 3) at the lower end ($23), on the positive side.
struct AxisTravel {
  Coordinate least{};
  Coordinate most{};
};
[[nodiscard]] AxisTravel travel_of(const Settings& settings, std::size_t axis);

/// Bits of $22.
namespace homing_option {
inline constexpr unsigned kEnabled = 1U;
inline constexpr unsigned kSingleAxis = 2U;
inline constexpr unsigned kRequired = 4U;
inline constexpr unsigned kSetOrigin = 8U;
}  // namespace homing_option
[[nodiscard]] bool has_homing_option(const Settings& settings, unsigned option);

}  // namespace cnc
