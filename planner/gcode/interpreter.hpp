#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "planner/base/result.hpp"
#include "planner/gcode/context.hpp"
#include "planner/gcode/execution.hpp"
#include "planner/gcode/fault.hpp"
#include "planner/gcode/options.hpp"
#include "planner/gcode/spline_store.hpp"

namespace cnc::gcode {

/// Actions in the order of execution. The list belongs to the interpreter and is valid until the
/// next line.
using Actions = std::span<const Action>;

/// Converts lines of G-code to actions, one line at a time.
///
/// The dialect is RS274/NGC as in Grbl 1.1, with six axes. From LinuxCNC it has G90.1, G59.x,
/// G92.2, G92.3, full turns by P, splines and outputs. A word that the interpreter does not know is
/// refused and never ignored.
///
/// The interpreter runs ahead of the machine: position() is the position at the end of all actions
/// so far. After a probe, an abort or homing, the machine is at another position. Then the caller
/// must call set_position() before the next line.
class Interpreter {
 public:
  explicit Interpreter(const Options& options = {}) : options_{options} {}

  /// Returns the actions of a line, or no actions for a line without words.
  ///
  /// A refused line changes nothing. The line may end with CR and LF. Lines that begin with `$` are
  /// not G-code and are refused.
  [[nodiscard]] Result<Actions, Fault> interpret(std::string_view line);

  /// Returns the action of a jog, which is a kLine. Only position() changes.
  /// @param words axis words and F. G20 G21 G90 G91 G53 and N are permitted and hold for this jog
  /// only.
  [[nodiscard]] Result<Actions, Fault> interpret_jog(std::string_view words);
  /// Returns N of the last jog. N of the last line that is no jog is in state().
  [[nodiscard]] std::uint32_t jog_line_number() const { return jog_line_number_; }

  [[nodiscard]] const ModalState& state() const { return context_.modal; }
  [[nodiscard]] const Shift& shift() const { return context_.shift; }
  [[nodiscard]] const StoredPlaces& places() const { return places_; }
  /// Returns a count that changes with each change of the stored positions.
  [[nodiscard]] std::uint32_t places_revision() const { return places_revision_; }
  /// Returns the position at the end of the last action, in machine coordinates.
  [[nodiscard]] const Position& position() const { return context_.position; }
  /// Returns the offset of an axis: work coordinate = machine coordinate − offset.
  [[nodiscard]] Coordinate work_offset(Axis axis) const {
    return gcode::work_offset(context_, places_, index_of(axis));
  }

  /// Sets the position of the machine. @pre all axes are in range, which holds for every position
  /// that the machine can reach
  void set_position(const Position& machine);
  /// Sets the stored positions, which were read from flash at start-up. @pre all positions are in
  /// range
  void set_places(const StoredPlaces& places);
  /// Sets the coolant of the modal state after the operator has switched the coolant by hand.
  void set_coolant(Coolant coolant) { context_.modal.coolant = coolant; }
  /// Ends G43.4 because the axes are to be moved individually. The tool length stays.
  void end_tool_centre() { context_.modal.tool_centre = false; }
  /// Resets modes, G92 and tool length to their state at start-up, as a soft reset does. The
  /// position and the stored positions do not change.
  void reset();
  /// Begins a tool change. Until it ends, only lines that belong to a tool change are accepted, see
  /// Options::changes_tool.
  /// @param machine present position, machine coordinates
  void begin_tool_change(const Position& machine);
  /// Ends a tool change: restores the state of `before`, but keeps the present offsets and stored
  /// positions.
  /// @param before copy of the interpreter from before begin_tool_change(). It receives the present
  /// offsets and stored positions, too.
  void end_tool_change(Interpreter& before);
  [[nodiscard]] const Options& options() const { return options_; }
  /// Sets the options, which hold from the next line on.
  void set_options(const Options& options) { options_ = options; }

 private:
  Options options_;
  Context context_{};
  StoredPlaces places_{};
  Block block_{};         ///< Words of the line that is being read.
  ActionList actions_{};  ///< Actions of the last line.
  SplineStore spline_store_{};
  std::uint32_t jog_line_number_ = 0;
  std::uint32_t places_revision_ = 0;
};

}  // namespace cnc::gcode
