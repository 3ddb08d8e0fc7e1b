#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/job/setting_line.hpp"
#include "host-sim/machine/virtual_controller.hpp"
#include "host-sim/serve/live_link.hpp"

namespace sim {

/// The controller on its link, with the reactions to senders that connect and disconnect.
///
/// Each reaction consists of realtime bytes that a careful operator would send. So the firmware
/// requires no code for it, and a recording contains it:
/// - For a new sender a soft reset is sent, whose greeting the sender waits for. The machine is at
///   rest then, because no motion continues without a sender.
/// - When a sender is lost, the byte of the safety door turns the beam off immediately and stops
///   the machine on its path. When the machine is at rest, a soft reset empties the planner and
///   switches off spindle and coolant. The position stays known.
class Session {
 public:
  /// Applies the settings, which override the stored ones. Throws as apply_settings() does. The
  /// store must outlive the session.
  Session(const MachineModel& machine,
          const std::vector<SettingChange>& settings,
          hal::RecordStore& store);

  /// Runs one cycle of the controller's main loop, which is a millisecond of the controller's time.
  void turn();

  /// @pre calm()
  void welcome_sender();
  void lose_sender();
  /// Makes a realtime byte act immediately, outside the stream.
  void act_at_once(std::byte byte);
  /// Stops the machine on behalf of a node of a bus, whichever sender is connected.
  void emergency_stop();

  /// Returns whether the machine is at rest after the last sender disconnected.
  [[nodiscard]] bool calm() const { return parting_ == Parting::kOver; }
  /// Returns whether the reset that greets a sender is over. The reset drops all bytes that arrived
  /// earlier, so the bytes of the sender must arrive after it.
  [[nodiscard]] bool hears() const { return turns_since_welcome_ >= kTurnsOfReset; }
  /// Returns whether the machine is at rest and no work is pending. The server loop may then sleep
  /// longer.
  [[nodiscard]] bool resting() const;

  [[nodiscard]] LiveLink& link() { return link_; }
  [[nodiscard]] VirtualController& controller() { return controller_; }
  [[nodiscard]] const VirtualController& controller() const { return controller_; }

 private:
  enum class Parting : std::uint8_t { kOver, kStopping, kResetting };
  static constexpr unsigned kTurnsOfReset = 5;

  void part();

  LiveLink link_{};
  VirtualController controller_;
  Parting parting_ = Parting::kOver;
  unsigned turns_of_parting_ = 0;
  unsigned turns_still_ = 0;
  unsigned turns_since_welcome_ = 0;
};

}  // namespace sim
