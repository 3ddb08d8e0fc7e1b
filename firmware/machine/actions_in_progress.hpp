#pragma once

#include <cstdint>
#include <utility>

#include "firmware/machine/dwell.hpp"
#include "planner/gcode/interpreter.hpp"
#include "planner/motion/block/output_changes.hpp"
#include "planner/pipeline/action_elements.hpp"

namespace cnc {

/// The part of a line that is still to be done.
struct RestOfLine {
  gcode::Actions actions{};         ///< Views into the machine's interpreter.
  motion::OutputChanges outputs{};  ///< Changes of outputs that take effect with the next motion.
  bool pauses = false;              ///< Whether the machine pauses after the line (single block).
};

/// The actions of the present line that are not done yet, in order, and the progress of the first
/// of them: its path elements, its dwell or its pause.
class ActionsInProgress {
 public:
  // Functions for the line.

  /// Begins a line.
  /// @param pauses whether the machine pauses when the line is done
  void begin(gcode::Actions actions, bool pauses) {
    line_.actions = actions;
    line_.pauses = pauses;
  }
  /// Returns whether no action is left.
  [[nodiscard]] bool empty() const { return line_.actions.empty(); }
  /// Returns the action that is to be done next. @pre !empty()
  [[nodiscard]] const gcode::Action& front() const { return line_.actions.front(); }
  void drop_front() { line_.actions = line_.actions.subspan(1); }
  /// Returns whether a pause follows the line and is not over yet.
  [[nodiscard]] bool pauses_after() const { return line_.pauses; }
  void end_pause_after() { line_.pauses = false; }

  /// Removes the present line and returns it. take_back() continues it after other lines were done.
  [[nodiscard]] RestOfLine set_aside() { return std::exchange(line_, {}); }
  void take_back(const RestOfLine& line) { line_ = line; }
  /// Drops the rest of the line. The changes of outputs that it requested still take effect with
  /// the next motion.
  void drop() {
    line_.actions = {};
    elements_.clear();
    is_dwelling_ = false;
    dwell_.cancel();
  }
  /// Drops the rest of the line, its changes of outputs and its pauses.
  void clear() {
    drop();
    line_ = {};
    is_paused_ = false;
  }

  // Functions for the outputs that change with the next motion.

  [[nodiscard]] const motion::OutputChanges& outputs() const { return line_.outputs; }
  /// Forgets the changes, because they were passed to a motion.
  void forget_outputs() { line_.outputs = {}; }
  /// Returns whether a change of an analog output other than `number` is waiting. A motion can take
  /// only one analog change.
  [[nodiscard]] bool changes_other_analog(std::uint8_t number) const {
    const std::uint8_t channel = line_.outputs.analog_channel;
    return channel != motion::OutputChanges::kNoAnalog && channel != number;
  }
  /// Adds a change of an output. The change replaces a waiting change of the same output. An analog
  /// change also replaces a waiting change of another analog output.
  /// @param level 65535 is full scale
  void add_output(const gcode::OutputChange& change, std::uint16_t level) {
    motion::OutputChanges& next = line_.outputs;
    if (change.analog) {
      next.analog_channel = change.number;
      next.analog_value = level;
      return;
    }
    const auto bit = static_cast<std::uint8_t>(1U << change.number);
    next.raise = static_cast<std::uint8_t>(level != 0 ? next.raise | bit : next.raise & ~bit);
    next.lower = static_cast<std::uint8_t>(level != 0 ? next.lower & ~bit : next.lower | bit);
  }

  // Functions for the present action.

  /// Begins a cycle, with a new budget of spline points.
  void begin_cycle() { spline_points_ = kSplinePoints; }
  /// Returns the path elements of the present action.
  [[nodiscard]] ActionElements& elements() { return elements_; }
  /// Computes the next path element within the cycle's budget of spline points; see
  /// ActionElements::work().
  [[nodiscard]] bool work() { return elements_.work(spline_points_); }

  /// Begins a dwell at the first call. Returns whether the dwell is over.
  [[nodiscard]] bool dwell(float seconds) {
    if (!is_dwelling_) dwell_.start(seconds);
    is_dwelling_ = !dwell_.over();
    return !is_dwelling_;
  }
  /// Subtracts `elapsed_us`, the time since the last cycle began, from the rest of the dwell.
  void pass(std::int32_t elapsed_us) { dwell_.pass(elapsed_us); }
  [[nodiscard]] bool is_dwelling() const { return is_dwelling_; }

  /// Begins a pause, in which the present action waits for the operator. end_pause() ends it.
  void pause() { is_paused_ = true; }
  void end_pause() { is_paused_ = false; }
  [[nodiscard]] bool is_paused() const { return is_paused_; }

 private:
  /// Number of spline points that may be evaluated in a cycle. It bounds the time that splines take
  /// in a cycle. The last step of a spline may double this time.
  static constexpr std::uint32_t kSplinePoints = 300;

  RestOfLine line_{};
  bool is_dwelling_ = false;
  bool is_paused_ = false;
  Dwell dwell_{};
  /// Number of points that are left in this cycle's budget.
  std::uint32_t spline_points_ = kSplinePoints;
  ActionElements elements_{};
};

}  // namespace cnc
