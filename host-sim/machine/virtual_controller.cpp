#include "host-sim/machine/virtual_controller.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "planner/base/contract.hpp"

namespace sim {

VirtualController::VirtualController(hal::ByteStream& link, const MachineModel& model)
    : VirtualController{link, model, own_store_} {}

VirtualController::VirtualController(hal::ByteStream& link,
                                     const MachineModel& model,
                                     hal::RecordStore& store)
    : model_{model},
      play_{model_},
      second_play_{model_},
      switches_{model_},
      probe_{model_},
      store_{store},
      link_{link},
      firmware_{std::in_place, port_, port_, port_, store, link} {}

void VirtualController::turn() {
  begin_turn();
  if (hangs_ms_ == 0) {
    CNC_ASSERT(take_turn());
    run_turn();
  } else if (--hangs_ms_ == 0) {
    restart();
  }
  pass_turn();
}

void VirtualController::begin_turn() {
  last_event_ = now_;
  follow_settings();
  feel_machine();
  firmware_->begin_turn();
}

std::optional<std::uint32_t> VirtualController::take_turn() {
  return firmware_->take_turn() ? std::optional{firmware_->turn()} : std::nullopt;
}

void VirtualController::run_turn() {
  const hal::TickCount now{firmware_->turn() * cnc::kTurnUs};
  if (known_link_ == nullptr) {
    firmware_->run_turn(now);
  } else {
    firmware_->run_turn(now, [this] { return known_link_->has_byte(); });
  }
  if (watches_memory_ && !firmware_->check_memory()) restart();
}

void VirtualController::follow_settings() {
  const cnc::Settings& settings = machine().settings();
  if (settings.revision() == settings_revision_) return;
  settings_revision_ = settings.revision();
  play_.place(settings);
  second_play_.place(settings);
  switches_.place(settings);
  probe_.place(settings);
  undisturbed_ = 0;
}

void VirtualController::advance_to(std::uint64_t tick) {
  if (planted_ && planted_->tick < tick) {
    play_until(planted_->tick);
    happen(*planted_);
    planted_.reset();
  }
  play_until(tick);
}

void VirtualController::happen(const PlantedBreakdown& breakdown) {
  switch (breakdown.kind) {
    case Breakdown::kProgramEnds:
      return restart();
    case Breakdown::kMainLoopHangs:
      hangs_ms_ = kWatchdogMs;
      return;
    case Breakdown::kSettingTurnsOver: {
      const auto settings = std::as_bytes(std::span{&machine().settings(), 1});
      const std::size_t place = breakdown.bit / 8 % settings.size();
      // A memory fault changes bits of const objects, too.
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast)
      const_cast<std::byte&>(settings[place]) ^= std::byte{1} << breakdown.bit % 8;
    }
  }
}

/// Restarts the controller in the same way as the chip: the outputs go low when the program ends,
/// then the program begins again.
void VirtualController::restart() {
  port_.reset();
  report_change();
  firmware_.emplace(port_, port_, port_, store_, link_, nullptr, &kept_progress_);
  timer_runs_ = false;
  hangs_ms_ = 0;
  settings_revision_ = 0;
  ++restarts_;
}

void VirtualController::play_until(std::uint64_t tick) {
  if (port_.changed) report_change();
  if (port_.timer_started) {
    port_.timer_started = false;
    timer_runs_ = true;
    next_interrupt_ = now_;
  }
  while (timer_runs_ && next_interrupt_ < tick) {
    now_ = last_event_ = next_interrupt_;
    const std::uint32_t wait = firmware_->on_step_interrupt();
    if (port_.changed) {
      feel_machine();
      report_change();
    }
    timer_runs_ = wait != 0;
    next_interrupt_ += wait;
  }
  now_ = tick;
  // Passes the row on now: nothing else happens at its tick, and sinks may read the state of the
  // machine at this time.
  if (row_waits_ && row_.time_ns < now_ * kNanosecondsPerTick) hand_out_row();
}

/// Updates plays and contacts. An interrupt moves a motor by at most one step. Therefore most
/// interrupts cannot change a contact.
inline void VirtualController::feel_machine() {
  if (undisturbed_ == 0) return touch_machine();
  --undisturbed_;
  if (play_.any()) play_.follow(port_.position);
  if (second_play_.any()) second_play_.follow(port_.second_position);
}

/// Updates the readings of the probe and the switches for the present positions of the axes.
void VirtualController::touch_machine() {
  const PlayModel::Steps& axes = play_.follow(port_.position);
  const PlayModel::Steps& second = second_play_.follow(port_.second_position);
  port_.probe = probe_.is_closed(axes);
  port_.limits = switches_.read(axes, second, now_);
  undisturbed_ = steps_undisturbed(axes, second);
}

std::uint64_t VirtualController::steps_undisturbed(const PlayModel::Steps& axes,
                                                   const PlayModel::Steps& second) const {
  return std::min(switches_.steps_undisturbed(axes, second), probe_.steps_undisturbed(axes));
}

inline void VirtualController::report_change() {
  port_.changed = false;
  if (!sinks_.empty()) keep_row();
}

void VirtualController::keep_row() {
  const TraceRow row{.time_ns = now_ * kNanosecondsPerTick,
                     .position = port_.position,
                     .duty = static_cast<float>(port_.power) / cnc::motion::kFullOutput};
  // All changes at one tick form one row.
  if (row_waits_ && row_.time_ns != row.time_ns) hand_out_row();
  row_ = row;
  row_waits_ = true;
}

void VirtualController::hand_out_row() {
  for (TraceSink* sink : sinks_) sink->on_row(row_);
  row_waits_ = false;
}

void VirtualController::end() {
  if (row_waits_) hand_out_row();
  for (TraceSink* sink : sinks_) sink->on_end(now_ * kNanosecondsPerTick);
}

}  // namespace sim
