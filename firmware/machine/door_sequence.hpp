#pragma once

#include <cstdint>

#include "planner/base/step_position.hpp"

namespace cnc {

/// Stages of an opened door, in their order. After kStopped the way back begins.
enum class DoorStage : std::uint8_t {
  kStopping,  ///< The motors brake on their path.
  kPullOut,   ///< The parking axis leaves the work, with the spindle turning.
  kPark,
  kStopped,  ///< All waits for the door to close, and for `~`.
  kUnpark,
  kSpindle,
  kCoolant,
  kPlunge,
};

/// Steps of the parking axis along its trip.
struct ParkingPlaces {
  StepPosition from{};        ///< In the work.
  StepPosition pulled_out{};  ///< Just outside of it.
  StepPosition parked{};
};

/// The stage of an opened door, and the places of the parking axis while it is away.
class DoorSequence {
 public:
  [[nodiscard]] DoorStage stage() const { return stage_; }
  void go_to(DoorStage stage) { stage_ = stage; }

  /// Begins with the motors braking.
  /// @param ends_jog whether it was a jog that the door stopped
  void open(bool ends_jog) {
    stage_ = DoorStage::kStopping;
    ends_jog_ = ends_jog;
  }
  /// Returns whether the way back has begun: a door that opens then begins the stages anew.
  [[nodiscard]] bool is_on_way_back() const { return stage_ > DoorStage::kStopped; }
  [[nodiscard]] bool ends_jog() const { return ends_jog_; }

  /// Returns whether the parking axis is away from the work, or on its way.
  [[nodiscard]] bool is_away() const { return is_away_; }
  /// Returns the places of the trip. @pre is_away()
  [[nodiscard]] const ParkingPlaces& places() const { return places_; }
  void leave(const ParkingPlaces& places) {
    places_ = places;
    is_away_ = true;
  }
  void come_back() { is_away_ = false; }

  /// Returns the digit behind `Door:` in a status report.
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
