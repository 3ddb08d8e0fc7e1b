#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "planner/base/coordinate.hpp"
#include "planner/gcode/interpreter.hpp"
#include "planner/motion/block/block.hpp"

namespace cnc {

/// A tool that is changed by hand (M6) while its sender takes part (0xA3): what the program leaves
/// behind meanwhile, and how far the way back to it has come.
///
/// Lines and jogs of the change move the machine and set offsets. At its end the tool goes back to
/// where the program stood, up first, then across and down, and the spindle turns there, as it does
/// after a change without lines. Of the modes nothing stays, of the offsets all.
class ToolChange {
 public:
  enum class Stage : std::uint8_t {
    kClosed,
    kOpen,      ///< Lines and jogs are taken.
    kStopping,  ///< What moves is stopped and dropped; kOpen follows.
    kEnding,    ///< The operator goes on; what was taken before is done first.
    kReturning,
  };

  /// What waits of the program.
  struct Job {
    std::optional<gcode::Interpreter> interpreter{};  ///< The program goes on with it.
    gcode::Actions waiting{};  ///< Views the machine's interpreter, as it will be again.
    motion::OutputChanges with_next_motion{};
    Position place{};  ///< Of the tool, machine coordinates.
    bool step_pause = false;
  };

  [[nodiscard]] Stage stage() const { return stage_; }
  void go_to(Stage stage) { stage_ = stage; }
  /// The operator goes on. No effect but while lines are taken.
  void end() {
    if (stage_ == Stage::kOpen) stage_ = Stage::kEnding;
  }
  /// Since 0xA3, until the program goes on.
  [[nodiscard]] bool open() const { return stage_ != Stage::kClosed; }
  /// No line is taken.
  [[nodiscard]] bool busy() const { return stage_ > Stage::kOpen; }

  [[nodiscard]] Job& job() { return job_; }

 private:
  static_assert(std::is_trivially_copyable_v<gcode::Interpreter>);

  Stage stage_ = Stage::kClosed;
  Job job_;
};

}  // namespace cnc
