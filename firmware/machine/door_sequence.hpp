#pragma once

#include <cstdint>

#include "planner/base/step_position.hpp"

namespace cnc {

/// Stages after the door was opened, in order. The stages after kStopped return the tool to the
/// work.
enum class DoorStage : std::uint8_t {
  kStopping,  ///< The motors brake along their path.
  kPullOut,   ///< The parking axis retracts from the work while the spindle still turns.
  kPark,
  kStopped,  ///< The machine waits until the door is closed and the operator sends `~`.
  kUnpark,
  kSpindle,
  kCoolant,
  kPlunge,
};

/// Positions of the parking axis on its trip away from the work, in steps.
struct ParkingPlaces {
  StepPosition from{};        ///< Position in the work.
  StepPosition pulled_out{};  ///< Position just outside of the work.
  StepPosition parked{};
};

/// State of the machine after the door was opened: the present stage, and the positions of the
/// parking axis on its trip.
class DoorSequence {
 public:
  [[nodiscard]] DoorStage stage() const { return stage_; }
  void go_to(DoorStage stage) { stage_ = stage; }

  /// Begins with the first stage, in which the motors brake.
  /// @param ends_jog whether the door stopped a jog
  void open(bool ends_jog) {
    stage_ = DoorStage::kStopping;
    ends_jog_ = ends_jog;
  }
  /// Returns whether the return to the work has begun. If the door opens during the return, the
  /// stages restart.
  [[nodiscard]] bool is_on_way_back() const { return stage_ > DoorStage::kStopped; }
  [[nodiscard]] bool ends_jog() const { return ends_jog_; }

  /// Returns whether the parking axis is on its trip: away from the work, or moving away or back.
  [[nodiscard]] bool is_away() const { return is_away_; }
  /// Returns the positions of the trip.
  /// @pre is_away()
  [[nodiscard]] const ParkingPlaces& places() const { return places_; }
  void leave(const ParkingPlaces& places) {
    places_ = places;
    is_away_ = true;
  }
  void come_back() { is_away_ = false; }

  /// Returns the digit after `Door:` in a status report.
  [[nodiscard]] std::uint8_t substate(bool is_door_open) const {
    if (stage_ < DoorStage::kStopped) return 2;
    if (stage_ > DoorStage::kStopped) return 3;
    return is_door_open ? 1 : 0;
  }

 private:
  DoorStage stage_ = DoorStage::kStopped;
  bool ends_jog_ = false;
  bool is_away_ = false;
  ParkingPlaces places_{};
};

}  // namespace cnc
