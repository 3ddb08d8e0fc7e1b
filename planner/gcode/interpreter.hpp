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

/// Actions in the order of execution. The list belongs to the interpreter, and the next line
/// overwrites it.
using Actions = std::span<const Action>;

/// Turns lines of G-code into actions, one line at a time.
///
/// The dialect is RS274/NGC as Grbl 1.1 understands it, with LinuxCNC's G90.1, G59.x, G92.2, G92.3,
/// P turns, splines and outputs; six axes. Words that the interpreter does not know are refused and
/// never skipped.
///
/// The interpreter runs ahead of the machine: position() is the position at which the actions so
/// far will end. After a probe, an abort or homing the machine is elsewhere; then the caller must
/// call set_position() before the next line.
class Interpreter {
 public:
  explicit Interpreter(const Options& options = {}) : options_{options} {}

  /// Returns the actions of a line; none for a line without words.
  ///
  /// A refused line leaves everything as it was. The CR and LF at its end are
  /// optional; lines of `$` belong to the protocol and are refused here.
  [[nodiscard]] Result<Actions, Fault> interpret(std::string_view line);

  /// Returns the action of a jog, given its body: axis words, F, and perhaps G20 G21 G90 G91 G53
  /// and N, which hold for this line only. The action is a kLine. Of all the state that a line may
  /// change, only position() changes.
  [[nodiscard]] Result<Actions, Fault> interpret_jog(std::string_view words);
  /// Returns N of the last jog, which is separate; N of other lines is in state().
  [[nodiscard]] std::uint32_t jog_line_number() const { return jog_line_number_; }

  [[nodiscard]] const ModalState& state() const { return context_.modal; }
  [[nodiscard]] const Shift& shift() const { return context_.shift; }
  [[nodiscard]] const StoredPlaces& places() const { return places_; }
  /// Returns a number that changes with each line that changes the stored positions.
  [[nodiscard]] std::uint32_t places_revision() const { return places_revision_; }
  /// Returns the position after the last action, in machine coordinates.
  [[nodiscard]] const Position& position() const { return context_.position; }
  /// Returns the offset that is subtracted from a machine coordinate to show the work coordinate.
  [[nodiscard]] Coordinate work_offset(Axis axis) const {
    return gcode::work_offset(context_, places_, index_of(axis));
  }

  /// Sets the position of the machine. @pre every axis is in range, as is every position that the
  /// machine can reach
  void set_position(const Position& machine);
  /// Sets the positions that were read from flash at start-up. @pre every position is in range
  void set_places(const StoredPlaces& places);
  /// Sets the coolant in the modal state, because the operator has switched it by hand.
  void set_coolant(Coolant coolant) { context_.modal.coolant = coolant; }
  /// Ends G43.4, because the axes are to be moved by themselves; its tool length stays.
  void end_tool_centre() { context_.modal.tool_centre = false; }
  /// Resets modes, G92 and tool length to those at start-up, as a soft reset does. Stored positions
  /// and the position stay.
  void reset();
  /// Begins a tool change: from now on only lines that belong to one are accepted
  /// (Options::changes_tool).
  void begin_tool_change(const Position& machine);
  /// Ends a tool change. Restores the state of `before`, which was saved when the change began,
  /// except offsets and stored positions. These stay, and `before` gets them, too.
  void end_tool_change(Interpreter& before);
  [[nodiscard]] const Options& options() const { return options_; }
  /// Sets the options that hold from the next line on.
  void set_options(const Options& options) { options_ = options; }

 private:
  Options options_;
  Context context_{};
  StoredPlaces places_{};
  Block block_{};         ///< Words of the line being read.
  ActionList actions_{};  ///< Actions of the last line.
  SplineStore spline_store_{};
  std::uint32_t jog_line_number_ = 0;
  std::uint32_t places_revision_ = 0;
};

}  // namespace cnc::gcode
