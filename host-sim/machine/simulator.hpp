#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "firmware/application.hpp"
#include "hal/host/recording_port.hpp"
#include "host-sim/machine/program_link.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// The machine around the controller.
struct MachineModel {
  /// Height of a conducting plate that closes the probe circuit, mm in machine
  /// coordinates; the tool's tip touches it when Z comes down to it.
  double probe_plate_z_mm = -10.0;
};

struct RunOptions {
  AfterRefusal after_refusal = AfterRefusal::kStop;
  MachineModel machine{};
  /// Called now and then with the share of the program sent, 0…1.
  std::function<void(double)> on_progress{};
};

/// How a run went, apart from what the sinks saw.
struct RunResult {
  double job_time_s = 0.0;
  std::size_t lines = 0;
  std::size_t blocks = 0;
  std::vector<Refusal> refusals;
  std::vector<std::pair<std::size_t, std::string>> notes;  ///< Line and what happened.
  int alarm = 0;                                           ///< Grbl's number; 0 is none.
  cnc::AxisArray<std::int32_t> final_position{};           ///< Motor steps.
};

/// Runs the unchanged firmware in virtual time: one thread, no clock, the same
/// result for the same bytes. The main loop turns once a millisecond, the step
/// interrupt exactly when it asks to.
class Simulator {
 public:
  using Firmware = cnc::Application<hal::host::RecordingPort>;
  static constexpr std::uint64_t kTicksPerTurn = cnc::motion::kTicksPerSecond / 1000;
  static constexpr std::uint64_t kNanosecondsPerTick = 1'000'000'000 / cnc::motion::kTicksPerSecond;

  Simulator(std::string program, RunOptions options);

  /// Before run(). A refused setting is returned as a reason, else empty.
  [[nodiscard]] std::string change_setting(std::uint16_t number, float value);
  [[nodiscard]] const cnc::Settings& settings() { return firmware_.machine().settings(); }

  /// Sinks see every edge from now on; they must outlive the run.
  void add_sink(TraceSink& sink) { sinks_.push_back(&sink); }

  /// Until the program is answered and the machine stands still, or an alarm.
  [[nodiscard]] RunResult run();

  // For tests that act in the middle of a run.
  [[nodiscard]] cnc::Machine& machine() { return firmware_.machine(); }
  [[nodiscard]] std::uint64_t now_ticks() const { return now_; }
  /// One turn of the main loop and the millisecond of interrupts after it.
  void turn();
  [[nodiscard]] bool done();
  [[nodiscard]] RunResult result();
  [[nodiscard]] const hal::host::RecordingPort& port() const { return port_; }

 private:
  void advance_to(std::uint64_t tick);
  void report_change();
  void hand_out_row();
  void attend_pause();

  RunOptions options_;
  ProgramLink link_;
  hal::host::RecordingPort port_{};
  Firmware firmware_;
  std::vector<TraceSink*> sinks_;
  std::uint64_t now_ = 0;             ///< Ticks of the step clock.
  std::uint64_t next_interrupt_ = 0;  ///< Valid while the timer runs.
  bool timer_runs_ = false;
  TraceRow row_{};  ///< Not handed out while its instant lasts.
  bool row_waits_ = false;
  std::vector<std::pair<std::size_t, std::string>> notes_;
};

}  // namespace sim
