#pragma once

#include <cstdint>

#include "planner/base/coordinate.hpp"
#include "planner/gcode/interpreter.hpp"
#include "planner/motion/block.hpp"

namespace cnc {

/// A tool that is changed by hand (M6) while its sender takes part (0xA3): what the program leaves
/// behind meanwhile, and how far the way back to it has come.
///
/// Lines and jogs of the change move the machine and set offsets. At its end the tool goes back to
/// where the program stood: up first, then across, and down when the spindle turns. Of the modes
/// nothing stays, of the offsets all.
class ToolChange {
 public:
  enum class Stage : std::uint8_t {
    kClosed,
    kOpen,      ///< Lines and jogs are taken.
    kStopping,  ///< What moves is stopped and dropped; kOpen follows.
    kEnding,    ///< The operator goes on; what was taken before is done first.
    kAcross,
    kSpindle,
    kDown,
  };

  /// What waits of the program.
  struct Job {
    gcode::Interpreter interpreter{};
    gcode::Actions waiting{};  ///< Views the machine's interpreter, as it will be again.
    motion::OutputChanges with_next_motion{};
    Position place{};  ///< Of the tool, machine coordinates.
    bool step_pause = false;
  };

  [[nodiscard]] Stage stage() const { return stage_; }
  void go_to(Stage stage) { stage_ = stage; }
  /// Since 0xA3, until the program goes on.
  [[nodiscard]] bool open() const { return stage_ != Stage::kClosed; }
  /// No line is taken.
  [[nodiscard]] bool busy() const { return stage_ > Stage::kOpen; }
  /// The tool is on its way back.
  [[nodiscard]] bool returns() const { return stage_ > Stage::kEnding; }

  [[nodiscard]] Job& job() { return job_; }

  /// Returns `point`, or the point above it that is as high as `other`.
  [[nodiscard]] static Position no_lower(Position point, const Position& other) {
    constexpr std::size_t kZ = index_of(Axis::kZ);
    if (point[kZ] < other[kZ]) point[kZ] = other[kZ];
    return point;
  }

 private:
  Stage stage_ = Stage::kClosed;
  Job job_{};
};

}  // namespace cnc
