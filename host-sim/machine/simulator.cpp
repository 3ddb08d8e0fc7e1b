#include "host-sim/machine/simulator.hpp"

namespace sim {
namespace {

constexpr float kFullPower = 65535.0F;
constexpr std::uint64_t kTicksPerMicrosecond = cnc::motion::kTicksPerSecond / 1'000'000;
constexpr unsigned kTurnsPerProgress = 256;

}  // namespace

Simulator::Simulator(std::string program, RunOptions options)
    : options_{std::move(options)},
      link_{std::move(program), options_.after_refusal},
      firmware_{port_, port_, link_} {}

std::string Simulator::change_setting(std::uint16_t number, float value) {
  const auto stored = firmware_.machine().change_setting(number, value);
  return stored.ok() ? std::string{} : std::string{cnc::describe(stored.error())};
}

RunResult Simulator::run() {
  unsigned turns = 0;
  while (!done()) {
    turn();
    attend_pause();
    if (options_.on_progress && ++turns % kTurnsPerProgress == 0) {
      options_.on_progress(link_.progress());
    }
  }
  if (row_waits_) hand_out_row();
  for (TraceSink* sink : sinks_) sink->on_end(now_ * kNanosecondsPerTick);
  return result();
}

void Simulator::turn() {
  firmware_.poll(hal::TickCount{static_cast<std::uint32_t>(now_ / kTicksPerMicrosecond)});
  advance_to(now_ + kTicksPerTurn);
}

bool Simulator::done() {
  const cnc::Machine& machine = firmware_.machine();
  if (machine.alarm() != cnc::Alarm::kNone) return !timer_runs_;
  return link_.finished() && machine.idle();
}

/// An operator who presses cycle start at once.
void Simulator::attend_pause() {
  cnc::Machine& machine = firmware_.machine();
  if (machine.state() != cnc::MachineState::kHold) return;
  notes_.emplace_back(link_.line(), "the program pauses here (M0); resumed at once");
  machine.resume();
}

void Simulator::advance_to(std::uint64_t tick) {
  if (port_.changed) report_change();
  if (port_.timer_started) {
    port_.timer_started = false;
    timer_runs_ = true;
    next_interrupt_ = now_;
  }
  while (timer_runs_ && next_interrupt_ < tick) {
    now_ = next_interrupt_;
    const std::uint32_t wait = firmware_.on_step_interrupt();
    if (port_.changed) report_change();
    timer_runs_ = wait != 0;
    next_interrupt_ += wait;
  }
  // The run ends with its motion, not with the turn in which that ended.
  if (timer_runs_ || !done()) now_ = tick;
}

void Simulator::report_change() {
  port_.changed = false;
  const double z_mm = static_cast<double>(port_.position[2]) /
                      static_cast<double>(settings().get(cnc::setting::kStepsPerMm, 2));
  port_.probe = z_mm <= options_.machine.probe_plate_z_mm;
  const TraceRow row{.time_ns = now_ * kNanosecondsPerTick,
                     .position = port_.position,
                     .duty = static_cast<float>(port_.power) / kFullPower};
  // Changes of the same instant are one row.
  if (row_waits_ && row_.time_ns != row.time_ns) hand_out_row();
  row_ = row;
  row_waits_ = true;
}

void Simulator::hand_out_row() {
  for (TraceSink* sink : sinks_) sink->on_row(row_);
  row_waits_ = false;
}

RunResult Simulator::result() {
  return {.job_time_s = static_cast<double>(now_) / cnc::motion::kTicksPerSecond,
          .lines = link_.line(),
          .blocks = firmware_.machine().motion().blocks_taken(),
          .refusals = link_.refusals(),
          .notes = notes_,
          .alarm = static_cast<int>(firmware_.machine().alarm()),
          .final_position = port_.position};
}

}  // namespace sim
