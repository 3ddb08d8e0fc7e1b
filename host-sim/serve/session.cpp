#include "host-sim/serve/session.hpp"

namespace sim {
namespace {

constexpr std::byte kSafetyDoor{0x84};
constexpr std::byte kSoftReset{0x18};

// Number of cycles without a step after which the machine is at rest. These cycles last longer than
// the queued segments, and no pause of the step timer within a motion is that long.
constexpr unsigned kTurnsStill = 100;
// Number of cycles after which a machine that still moves is reset. No machine takes that long to
// brake.
constexpr unsigned kMaxTurnsToStop = 10'000;

}  // namespace

Session::Session(const MachineModel& machine,
                 const std::vector<SettingChange>& settings,
                 hal::RecordStore& store)
    : controller_{link_, machine, store} {
  apply_settings(settings, controller_.machine());
}

void Session::turn() {
  controller_.turn();
  turns_still_ = controller_.step_timer_runs() ? 0 : turns_still_ + 1;
  ++turns_since_welcome_;
  if (parting_ != Parting::kOver) part();
}

void Session::welcome_sender() {
  link_.connect();
  link_.interject(kSoftReset);
  turns_since_welcome_ = 0;
}

void Session::act_at_once(std::byte byte) {
  link_.pass_by(byte);
  controller_.firmware().act_at_once(byte);
}

void Session::emergency_stop() {
  link_.stop_passes_by();
  controller_.machine().emergency_stop();
}

void Session::lose_sender() {
  link_.disconnect();
  act_at_once(kSafetyDoor);  // This byte acts in the middle of a line or comment, too.
  parting_ = Parting::kStopping;
  turns_of_parting_ = turns_still_ = 0;
}

void Session::part() {
  ++turns_of_parting_;
  if (parting_ == Parting::kResetting) {
    if (turns_of_parting_ >= kTurnsOfReset) parting_ = Parting::kOver;
    return;
  }
  if (turns_still_ < kTurnsStill && turns_of_parting_ < kMaxTurnsToStop) return;
  link_.interject(kSoftReset);
  parting_ = Parting::kResetting;
  turns_of_parting_ = 0;
}

bool Session::resting() const {
  return calm() && hears() && turns_still_ >= kTurnsStill && link_.heard_all() &&
         !controller_.machine().busy();
}

}  // namespace sim
