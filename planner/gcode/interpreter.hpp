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

/// In the order of execution. Views the interpreter's own list, which the next
/// line overwrites.
using Actions = std::span<const Action>;

/// Turns lines of G-code into actions, one line at a time.
///
/// The dialect is RS274/NGC as Grbl 1.1 understands it, with LinuxCNC's G90.1,
/// G59.x, G92.2, G92.3, P turns, splines and outputs; six axes. What is not understood
/// is refused and never skipped.
///
/// It runs ahead of the machine: position() is where the actions so far will
/// end. After a probe, an abort or homing the machine is elsewhere and must say
/// so with set_position() before the next line.
class Interpreter {
 public:
  explicit Interpreter(const Options& options = {}) : options_{options} {}

  /// What the line asks for; nothing, for a line without words.
  ///
  /// A refused line leaves everything as it was. The CR and LF at its end are
  /// optional; lines of `$` belong to the protocol and are refused here.
  [[nodiscard]] Result<Actions, Fault> interpret(std::string_view line);

  /// The body of a jog: axis words, F, and perhaps G20 G21 G90 G91 G53 and N,
  /// for this line alone. The action is a kLine. Of all that a line may leave
  /// behind only position() changes.
  [[nodiscard]] Result<Actions, Fault> interpret_jog(std::string_view words);
  /// N of a jog is its own; of other lines it is in state().
  [[nodiscard]] std::uint32_t jog_line_number() const { return jog_line_number_; }

  [[nodiscard]] const ModalState& state() const { return context_.modal; }
  [[nodiscard]] const Shift& shift() const { return context_.shift; }
  [[nodiscard]] const StoredPlaces& places() const { return places_; }
  /// Another number after each line that changed them.
  [[nodiscard]] std::uint32_t places_revision() const { return places_revision_; }
  /// Machine coordinates.
  [[nodiscard]] const Position& position() const { return context_.position; }
  /// What is subtracted from a machine coordinate to show the work coordinate.
  [[nodiscard]] Coordinate work_offset(Axis axis) const {
    return gcode::work_offset(context_, places_, index_of(axis));
  }

  /// @pre every axis is in range, as whatever the machine can reach is.
  void set_position(const Position& machine);
  /// What was read from flash at start-up. @pre every place is in range.
  void set_places(const StoredPlaces& places);
  /// The operator switched it by hand: the modal state follows.
  void set_coolant(Coolant coolant) { context_.modal.coolant = coolant; }
  /// The axes are to be moved by themselves: G43.4 ends, its tool length stays.
  void end_tool_centre() { context_.modal.tool_centre = false; }
  /// As after a soft reset: modes, G92 and tool length as at start-up; stored
  /// places and position stay.
  void reset();
  /// From here on only lines that belong to a tool change are taken (Options::changes_tool).
  void begin_tool_change(const Position& machine);
  /// Everything is as in `before`, of that time, but for offsets and stored places, which `before`
  /// is given, too.
  void end_tool_change(Interpreter& before);
  [[nodiscard]] const Options& options() const { return options_; }
  /// From the next line on.
  void set_options(const Options& options) { options_ = options; }

 private:
  Options options_;
  Context context_{};
  StoredPlaces places_{};
  Block block_{};         ///< Of the line being read.
  ActionList actions_{};  ///< Of the last line.
  SplineStore spline_store_{};
  std::uint32_t jog_line_number_ = 0;
  std::uint32_t places_revision_ = 0;
};

}  // namespace cnc::gcode
