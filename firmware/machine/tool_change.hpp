#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "firmware/machine/actions_in_progress.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/gcode/interpreter.hpp"

namespace cnc {

/// State of a manual tool change (M6): the tool for which the program waits. If the sender takes
/// part (0xA3), the state also contains the stored state of the program and the stage of the tool
/// change.
///
/// If the sender takes part, its lines and jogs move the machine and set offsets. At the end, the
/// tool returns to the program's position: up first, then across, then down. The spindle starts
/// there, as after a tool change without lines. The modes of the program are restored. The offsets
/// keep the values that the lines have set.
class ToolChange {
 public:
  enum class Stage : std::uint8_t {
    kClosed,
    kOpen,      ///< Lines and jogs are accepted.
    kStopping,  ///< The motion is being stopped and is then dropped; kOpen follows.
    kEnding,    ///< The operator has resumed. Lines that were accepted earlier are completed first.
    kReturning,
  };

  /// State of the program while it waits for the tool.
  struct Job {
    /// Interpreter with which the program continues.
    std::optional<gcode::Interpreter> interpreter{};
    /// Rest of the line of M6. Its views are valid once the interpreter is restored.
    RestOfLine line{};
    Position place{};  ///< Position of the tool in machine coordinates.
  };

  /// Notes the tool for which the program waits.
  void want(std::uint32_t tool) { wanted_ = tool; }
  /// Forgets the tool, because the program continues or is dropped.
  void forget_wanted() { wanted_.reset(); }
  /// Returns the tool for which M6 waits, if any.
  [[nodiscard]] std::optional<std::uint32_t> wanted() const { return wanted_; }

  [[nodiscard]] Stage stage() const { return stage_; }
  void go_to(Stage stage) { stage_ = stage; }
  /// Begins to end the tool change, because the operator has resumed. Has an effect only in the
  /// stage kOpen.
  void end() {
    if (stage_ == Stage::kOpen) stage_ = Stage::kEnding;
  }
  /// Returns whether the sender takes part in a tool change: from 0xA3 until the program continues.
  [[nodiscard]] bool open() const { return stage_ != Stage::kClosed; }
  /// Returns whether no line is accepted although the tool change is open: it is stopping or
  /// ending.
  [[nodiscard]] bool busy() const { return stage_ > Stage::kOpen; }

  [[nodiscard]] Job& job() { return job_; }

 private:
  static_assert(std::is_trivially_copyable_v<gcode::Interpreter>);

  std::optional<std::uint32_t> wanted_{};
  Stage stage_ = Stage::kClosed;
  Job job_;
};

}  // namespace cnc
