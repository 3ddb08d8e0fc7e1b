#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/machine/program_link.hpp"
#include "host-sim/machine/virtual_controller.hpp"

namespace sim {

struct RunOptions {
  AfterRefusal after_refusal = AfterRefusal::kStop;
  MachineModel machine{};
  /// Whether to omit polls of the firmware that have no effect. The trace and the answers stay the
  /// same, but the run takes less time.
  bool skips_quiet_polls = true;
  /// Whether the firmware checks its memory; see VirtualController::watch_memory().
  bool watches_memory = true;
  /// Called regularly with the share of the program that was sent, 0…1.
  std::function<void(double)> on_progress{};
  /// Called for every line that the controller accepts.
  std::function<void(std::size_t line, std::string_view text)> on_taken{};
  /// Called for every line that the controller sends, without the line end.
  std::function<void(std::string_view text)> on_answer{};
};

/// Result of a run, without the edges, which the sinks receive.
struct RunResult {
  double job_time_s = 0.0;
  std::size_t lines = 0;
  std::size_t blocks = 0;
  std::vector<Refusal> refusals;  ///< The first refusals, at most ProgramLink::kMaxRefusals.
  std::size_t refused = 0;        ///< Number of refused lines.
  /// Events of the run, each with the number of the program's line.
  std::vector<std::pair<std::size_t, std::string>> notes;
  int alarm = 0;  ///< Grbl's number of the alarm; 0 without an alarm.
  /// Position of the motors at the end of the run, steps.
  cnc::AxisArray<std::int32_t> final_position{};
};

/// Runs a program on a virtual controller as fast as the computer can. Its sender and its operator
/// never make the controller wait.
class Simulator {
 public:
  Simulator(std::string program, RunOptions options);

  /// Changes a setting. Returns the reason if the setting is refused, otherwise an empty text.
  /// @pre run() was not called yet
  [[nodiscard]] std::string change_setting(std::uint16_t number, float value);
  [[nodiscard]] const cnc::Settings& settings() const { return controller_.machine().settings(); }

  /// Adds a sink, which receives every later edge and must outlive the run.
  void add_sink(TraceSink& sink) { controller_.add_sink(sink); }

  [[nodiscard]] std::string_view program() const { return link_.program(); }

  /// Runs until the program is answered and the machine is at rest, or until an alarm.
  [[nodiscard]] RunResult run();

  // Returns the machine, for tests that act in the middle of a run.
  [[nodiscard]] cnc::Machine& machine() { return controller_.machine(); }
  [[nodiscard]] std::uint64_t now_ticks() const { return controller_.now_ticks(); }
  /// Runs one cycle of the main loop, then the interrupts of the following millisecond.
  void turn();
  [[nodiscard]] bool done() const;
  /// Returns whether the step interrupt is playing segments.
  [[nodiscard]] bool moves() const { return controller_.step_timer_runs(); }
  [[nodiscard]] RunResult result() const;
  [[nodiscard]] const hal::host::RecordingPort& port() const { return controller_.port(); }
  /// Returns the positions of the axes in steps: the positions of the motors without the play.
  [[nodiscard]] PlayModel::Steps axes() const { return controller_.axes(); }

 private:
  void attend_pause();
  void note(std::string text);
  void count_turns();
  [[nodiscard]] bool in_alarm() const;

  RunOptions options_;
  ProgramLink link_;
  VirtualController controller_;
  unsigned turns_to_status_ = 0;
  unsigned waiting_turns_ = 0;
  /// Whether a tool was changed and the spindle is accelerating to its speed.
  bool tool_changed_ = false;
  std::vector<std::pair<std::size_t, std::string>> notes_;
};

}  // namespace sim
