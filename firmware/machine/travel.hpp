#pragma once

#include <cstdint>

#include "firmware/machine/settings.hpp"
#include "planner/gcode/interpreter.hpp"
#include "planner/geometry/path_element.hpp"
#include "planner/kinematics/tool_centre.hpp"
#include "planner/motion/block/limits.hpp"
#include "planner/pipeline/action_elements.hpp"

namespace cnc {

/// The travel of the axes, in machine coordinates. Soft limits ($20) refuse a motion that would
/// leave it.
///
/// Only homed axes are checked, because the machine coordinates of other axes are unknown. Endless
/// axes (travel 0) are never checked.
class Travel {
 public:
  /// The five-axis machine that moves the tip under G43.4.
  struct FiveAxes {
    const kinematics::ToolCentre& centre;
    const motion::Limits& limits;
  };

  void configure(const Settings& settings);
  /// Sets the homed axes: bit i for axis i.
  void set_homed(std::uint8_t axes, const Settings& settings) {
    homed_ = axes;
    configure(settings);
  }
  /// Returns the axes whose machine coordinates are known, bit i for axis i.
  [[nodiscard]] std::uint8_t homed() const { return homed_; }

  /// Returns whether a motion of the actions, which begin at `from`, would leave the travel. For an
  /// arc or a spline, its exact extreme positions are checked.
  [[nodiscard]] bool left_by(gcode::Actions actions, const Position& from) const;
  /// Returns whether motions of the tip under G43.4 would move an axis out of the travel, or the
  /// tilting axis out of its limits. These limits are also checked if the axis is not homed. On
  /// arcs and on lines of 100 mm, a motion that stays inside by less than 0.2 mm may be reported,
  /// too.
  /// @param elements working storage in which the actions are divided; cleared at the end
  /// @pre centre.active(); the actions are lines and arcs; elements are not active
  [[nodiscard]] bool left_by(gcode::Actions actions,
                             const Position& from,
                             const FiveAxes& machine,
                             ActionElements& elements) const;
  /// Returns whether a position is inside the travel of all checked axes.
  [[nodiscard]] bool holds(const Position& place) const { return contains(place); }
  /// Returns the position, with each checked axis clamped to its travel.
  [[nodiscard]] Position clamped(const Position& place) const;

 private:
  [[nodiscard]] bool contains(const Position& place) const;
  [[nodiscard]] bool contains_axes(const PathElement& element, const FiveAxes& machine) const;
  [[nodiscard]] bool contains_spline(const Position& start, const gcode::Action& spline) const;
  [[nodiscard]] bool contains_arc(const Position& start, const gcode::Action& arc) const;

  std::uint8_t homed_ = 0;
  std::uint8_t judged_ = 0;  ///< Axes that are checked against their travel, bit i for axis i.
  Position min_{};
  Position max_{};
};

/// Travel of an axis in machine coordinates. As in Grbl, it extends from zero to negative
/// coordinates. If homing sets the origin ($22 bit 3) at the lower end ($23), it extends to
/// positive coordinates.
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
