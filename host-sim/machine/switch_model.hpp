#pragma once

#include <array>
#include <cstdint>

#include "firmware/machine/settings.hpp"
#include "hal/interface/step_port.hpp"
#include "host-sim/machine/machine_model.hpp"
#include "host-sim/machine/play_model.hpp"

namespace sim {

/// The limit switches of the model machine: one per motor, closed from a place
/// on, with contacts that bounce. Deterministic: the same steps at the same
/// ticks read the same.
class SwitchModel {
 public:
  explicit SwitchModel(const MachineModel& model) : model_{model} {}

  /// Puts them where the machine of these settings has them.
  void place(const cnc::Settings& settings);
  /// What they read at this tick, with the axes where their motors have taken them, in
  /// steps. Call with ticks that never go back.
  [[nodiscard]] hal::SwitchMask read(const PlayModel::Steps& first,
                                     const PlayModel::Steps& second,
                                     std::uint64_t tick);
  /// So many steps may each motor go from there, and they read the same; 0 while one bounces.
  [[nodiscard]] std::uint64_t steps_undisturbed(const PlayModel::Steps& first,
                                                const PlayModel::Steps& second) const;

 private:
  struct Switch {
    bool present = false;
    bool low = false;               ///< At the lower end.
    bool second = false;            ///< The axis has two motors, and a switch for each.
    std::int64_t step = 0;          ///< Closed from here on.
    std::int64_t second_ahead = 0;  ///< Steps that the second motor stands nearer to it.
  };
  struct Contact {
    bool closed = false;
    bool bounces = false;
    std::uint64_t changed = 0;  ///< Tick.
  };

  [[nodiscard]] bool reads_closed(Contact& contact, bool pressed, std::uint64_t tick) const;

  const MachineModel& model_;
  std::array<Switch, 6> switches_{};
  std::array<std::array<Contact, 2>, 6> contacts_{};
};

}  // namespace sim
