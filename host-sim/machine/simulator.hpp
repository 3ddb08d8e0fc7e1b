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
  /// Whether to leave out polls of the firmware that change nothing. The trace and the answers are
  /// the same, but the run takes less time.
  bool skips_quiet_polls = true;
  bool watches_memory = true;  ///< See VirtualController::watch_memory().
  /// Called now and then with the share of the program sent, 0…1.
  std::function<void(double)> on_progress{};
  /// Called for every line that the controller takes.
  std::function<void(std::size_t line, std::string_view text)> on_taken{};
  /// Called for every line that the controller sends, without its line end.
  std::function<void(std::string_view text)> on_answer{};
};

/// Result of a run, apart from the edges that the sinks saw.
struct RunResult {
  double job_time_s = 0.0;
  std::size_t lines = 0;
  std::size_t blocks = 0;
  std::vector<Refusal> refusals;  ///< At most the first ProgramLink::kMaxRefusals.
  std::size_t refused = 0;        ///< Number of refused lines.
  std::vector<std::pair<std::size_t, std::string>> notes;  ///< Number of the line, and the event.
  int alarm = 0;  ///< Grbl's number of the alarm; 0 without an alarm.
  cnc::AxisArray<std::int32_t> final_position{};  ///< Position in motor steps.
};

/// Runs a program on a virtual controller as fast as the computer can, with a sender and an
/// operator that never make the controller wait.
class Simulator {
 public:
  Simulator(std::string program, RunOptions options);

  /// Changes a setting. Returns the reason if the setting is refused, else an empty text.
  /// @pre run() was not called yet
  [[nodiscard]] std::string change_setting(std::uint16_t number, float value);
  [[nodiscard]] const cnc::Settings& settings() const { return controller_.machine().settings(); }

  /// Adds a sink, which sees every edge from now on and must outlive the run.
  void add_sink(TraceSink& sink) { controller_.add_sink(sink); }

  [[nodiscard]] std::string_view program() const { return link_.program(); }

  /// Runs until the program is answered and the machine is at rest, or until an alarm.
  [[nodiscard]] RunResult run();

  // Returns the machine, for tests that act in the middle of a run.
  [[nodiscard]] cnc::Machine& machine() { return controller_.machine(); }
  [[nodiscard]] std::uint64_t now_ticks() const { return controller_.now_ticks(); }
  /// Runs one cycle of the main loop and the millisecond of interrupts after it.
  void turn();
  [[nodiscard]] bool done() const;
  /// Returns whether segments are being played.
  [[nodiscard]] bool moves() const { return controller_.step_timer_runs(); }
  [[nodiscard]] RunResult result() const;
  [[nodiscard]] const hal::host::RecordingPort& port() const { return controller_.port(); }
  /// Returns the positions of the axes in steps: those of the motors minus their play.
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
  /// Whether a tool was changed and the spindle is coming up to speed.
  bool tool_changed_ = false;
  std::vector<std::pair<std::size_t, std::string>> notes_;
};

}  // namespace sim
