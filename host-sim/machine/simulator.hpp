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
  /// Leaves out polls of the firmware that change nothing; the same trace and answers come sooner.
  bool skips_quiet_polls = true;
  bool watches_memory = true;  ///< As VirtualController::watch_memory() has it.
  /// Called now and then with the share of the program sent, 0…1.
  std::function<void(double)> on_progress{};
  /// Told of every line that the controller takes.
  std::function<void(std::size_t line, std::string_view text)> on_taken{};
  /// Told of every line that the controller says, without its end.
  std::function<void(std::string_view text)> on_answer{};
};

/// How a run went, apart from what the sinks saw.
struct RunResult {
  double job_time_s = 0.0;
  std::size_t lines = 0;
  std::size_t blocks = 0;
  std::vector<Refusal> refusals;  ///< The first ProgramLink::kMostRefusals.
  std::size_t refused = 0;        ///< Lines.
  std::vector<std::pair<std::size_t, std::string>> notes;  ///< Line and what happened.
  int alarm = 0;                                           ///< Grbl's number; 0 is none.
  cnc::AxisArray<std::int32_t> final_position{};           ///< Motor steps.
};

/// Runs a program on a virtual controller, as fast as it goes, with a sender
/// and an operator who never make it wait.
class Simulator {
 public:
  Simulator(std::string program, RunOptions options);

  /// Before run(). A refused setting is returned as a reason, else empty.
  [[nodiscard]] std::string change_setting(std::uint16_t number, float value);
  [[nodiscard]] const cnc::Settings& settings() const { return controller_.machine().settings(); }

  /// Sinks see every edge from now on; they must outlive the run.
  void add_sink(TraceSink& sink) { controller_.add_sink(sink); }

  [[nodiscard]] std::string_view program() const { return link_.program(); }

  /// Until the program is answered and the machine stands still, or an alarm.
  [[nodiscard]] RunResult run();

  // For tests that act in the middle of a run.
  [[nodiscard]] cnc::Machine& machine() { return controller_.machine(); }
  [[nodiscard]] std::uint64_t now_ticks() const { return controller_.now_ticks(); }
  /// One turn of the main loop and the millisecond of interrupts after it.
  void turn();
  [[nodiscard]] bool done() const;
  /// Segments are being played.
  [[nodiscard]] bool moves() const { return controller_.step_timer_runs(); }
  [[nodiscard]] RunResult result() const;
  [[nodiscard]] const hal::host::RecordingPort& port() const { return controller_.port(); }
  /// Where the axes are, in steps: the motors less their play.
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
  bool tool_changed_ = false;  ///< And the spindle is coming up to speed.
  std::vector<std::pair<std::size_t, std::string>> notes_;
};

}  // namespace sim
