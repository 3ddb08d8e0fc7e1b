#pragma once

#include <array>
#include <cstdint>

#include "firmware/machine/settings.hpp"
#include "hal/interface/step_port.hpp"
#include "host-sim/machine/machine_model.hpp"
#include "host-sim/machine/play_model.hpp"

namespace sim {

/// The limit switches of the model machine, one for each motor. A switch is closed from a position
/// of its axis onwards, and its contact bounces. The model is deterministic: the same steps at the
/// same ticks give the same readings.
class SwitchModel {
 public:
  explicit SwitchModel(const MachineModel& model) : model_{model} {}

  /// Places the switches at the positions that result from these settings.
  void place(const cnc::Settings& settings);
  /// Returns the readings of the switches at a tick.
  /// @param first, second positions of the axes in steps, as moved by their first and by their
  /// second motors
  /// @pre the tick is not before the tick of the previous call
  [[nodiscard]] hal::SwitchMask read(const PlayModel::Steps& first,
                                     const PlayModel::Steps& second,
                                     std::uint64_t tick);
  /// Returns the number of steps that each motor may make from these positions before a reading can
  /// change; 0 while a contact bounces.
  [[nodiscard]] std::uint64_t steps_undisturbed(const PlayModel::Steps& first,
                                                const PlayModel::Steps& second) const;

 private:
  struct Switch {
    bool present = false;
    bool low = false;       ///< Whether the switch is at the lower end of the axis.
    bool second = false;    ///< Whether the axis has two motors, each with its own switch.
    std::int64_t step = 0;  ///< Position, in steps, from which the switch is closed.
    /// Number of steps by which the second motor is nearer to its switch.
    std::int64_t second_ahead = 0;
  };
  struct Contact {
    bool closed = false;
    bool bounces = false;
    std::uint64_t changed = 0;  ///< Tick of the last change.
  };

  [[nodiscard]] bool reads_closed(Contact& contact, bool pressed, std::uint64_t tick) const;

  const MachineModel& model_;
  std::array<Switch, 6> switches_{};
  std::array<std::array<Contact, 2>, 6> contacts_{};
};

}  // namespace sim
