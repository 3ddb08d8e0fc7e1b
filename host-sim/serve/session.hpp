#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/job/setting_line.hpp"
#include "host-sim/machine/virtual_controller.hpp"
#include "host-sim/serve/live_link.hpp"

namespace sim {

/// The controller on its link, and what becomes of it when senders come and go.
///
/// Both work by the bytes that a careful operator would send, so that the
/// firmware needs to know nothing of it and a recording holds all of it:
/// * A sender who came gets a soft reset, and so the greeting that it waits for.
///   The machine stands still then: nothing goes on without a sender.
/// * When a sender is lost, the safety door darkens the beam at once and stops the
///   machine on its path; once it stands, a soft reset empties the planner and
///   switches off spindle and coolant. The position stays known.
class Session {
 public:
  /// The settings are on top of what is stored. Throws as apply_settings(). The
  /// store must outlive the session.
  Session(const MachineModel& machine,
          const std::vector<SettingChange>& settings,
          hal::RecordStore& store);

  /// One turn of the controller's main loop, a millisecond of its time.
  void turn();

  /// @pre calm()
  void welcome_sender();
  void lose_sender();
  /// A realtime byte beside the stream.
  void act_at_once(std::byte byte);
  /// From a bus, whoever is the sender.
  void emergency_stop();

  /// The last sender's work has been brought to rest.
  [[nodiscard]] bool calm() const { return parting_ == Parting::kOver; }
  /// The reset that welcomed the sender is over. It forgets what came before,
  /// so bytes of the sender must not arrive earlier.
  [[nodiscard]] bool hears() const { return turns_since_welcome_ >= kTurnsOfReset; }
  /// Nothing moves, nobody waits for anything: time may pass in larger strides.
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
