#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "firmware/machine/actions_in_progress.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/gcode/interpreter.hpp"

namespace cnc {

/// A tool change by hand (M6): the tool for which the program waits. If the sender takes part
/// (0xA3), also the program's state that waits meanwhile, and the stage of the return to it.
///
/// Lines and jogs of such a change move the machine and set offsets. At its end the tool returns to
/// the program's position: up first, then across and down. The spindle starts there, as after a
/// change without lines. The modes are restored; the offsets stay as the change has set them.
class ToolChange {
 public:
  enum class Stage : std::uint8_t {
    kClosed,
    kOpen,      ///< Lines and jogs are accepted.
    kStopping,  ///< Motion is stopped and dropped; kOpen follows.
    kEnding,    ///< The operator resumes; lines accepted before are done first.
    kReturning,
  };

  /// The waiting state of the program.
  struct Job {
    std::optional<gcode::Interpreter> interpreter{};  ///< The program continues with it.
    RestOfLine line{};  ///< Its views are valid after the return of the interpreter.
    Position place{};   ///< Position of the tool in machine coordinates.
  };

  /// Notes the tool for which the program waits.
  void want(std::uint32_t tool) { wanted_ = tool; }
  /// Forgets that tool, because the program goes on or is dropped.
  void forget_wanted() { wanted_.reset(); }
  /// Returns the tool for which M6 waits, if any.
  [[nodiscard]] std::optional<std::uint32_t> wanted() const { return wanted_; }

  [[nodiscard]] Stage stage() const { return stage_; }
  void go_to(Stage stage) { stage_ = stage; }
  /// Ends the change because the operator resumes. Has an effect only while lines are accepted.
  void end() {
    if (stage_ == Stage::kOpen) stage_ = Stage::kEnding;
  }
  /// Returns whether a change is open, from 0xA3 until the program continues.
  [[nodiscard]] bool open() const { return stage_ != Stage::kClosed; }
  /// Returns whether no line is accepted.
  [[nodiscard]] bool busy() const { return stage_ > Stage::kOpen; }

  [[nodiscard]] Job& job() { return job_; }

 private:
  static_assert(std::is_trivially_copyable_v<gcode::Interpreter>);

  std::optional<std::uint32_t> wanted_{};
  Stage stage_ = Stage::kClosed;
  Job job_;
};

}  // namespace cnc
