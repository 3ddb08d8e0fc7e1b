#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/machine/memory_watch.hpp"

namespace cnc {

/// Finds flipped bits in the settings and the stored positions, by their checksums. Each change of
/// them is followed by trust_settings() or trust_places(), which store the new checksum. Main loop
/// only.
class MemoryGuard {
 public:
  /// Adds a part of the settings, or of memory that is computed from them, to the watched memory.
  /// The part must not move.
  void watch_settings(MemoryWatch::Part part) { settings_.add(part); }
  template <typename Object>
  void watch_settings_in(const Object& object) {
    settings_.add_object(object);
  }
  /// Adds stored positions to the watched memory. The object must not move.
  template <typename Object>
  void watch_places_in(const Object& object) {
    places_.add_object(object);
  }

  /// Accepts the present content of the settings as correct, after a change.
  /// @param are_sound whether the settings agree with their own checksum, Settings::sound()
  void trust_settings(bool are_sound);
  /// Accepts the present positions as correct.
  /// @param revision number that changes with each change of the positions
  void trust_places(std::uint32_t revision);
  /// Returns the revision of the last trust_places().
  [[nodiscard]] std::uint32_t trusted_places() const { return places_revision_; }

  /// Checks all settings. To be called when motion begins, and before a change of the settings is
  /// trusted. Without this check, a flipped bit of an acceleration or jerk might make the beam stay
  /// on at one point until check() finds the bit.
  void check_settings();
  /// Checks at most `bytes` further bytes of the settings, and as many of the positions. Returns
  /// false once any check has found a flipped bit.
  [[nodiscard]] bool check(std::size_t bytes);
  /// Checks all positions; to be called before the positions are stored. Returns false once any
  /// check has found a flipped bit.
  [[nodiscard]] bool check_places();

 private:
  MemoryWatch settings_{};
  MemoryWatch places_{};
  std::uint32_t places_revision_ = 0;
  bool is_sound_ = true;
};

}  // namespace cnc
