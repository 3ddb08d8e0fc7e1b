#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/machine/memory_watch.hpp"

namespace cnc {

/// Keeps the checksums of settings and of stored positions, and remembers whether a bit of either
/// has flipped since they were trusted. Main loop only.
class MemoryGuard {
 public:
  /// Adds settings, or memory that is computed from them, to the watched memory. It must not move.
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

  /// Trusts the settings as they are, after a change.
  /// @param are_sound the settings agree with their own checksum, which the change did not compute
  void trust_settings(bool are_sound);
  /// Trusts the positions as they are.
  /// @param revision number that changes with each change of the positions
  void trust_places(std::uint32_t revision);
  /// Returns the last trusted revision.
  [[nodiscard]] std::uint32_t trusted_places() const { return places_revision_; }

  /// Checks all settings. To be called before motion is planned by them, or a change of them is
  /// trusted. Otherwise a flipped bit of an acceleration or jerk might leave the beam on at one
  /// point until the running check has found it.
  void check_settings();
  /// Checks at most `bytes` further bytes of settings, and of positions. Returns false from the
  /// first flipped bit on.
  [[nodiscard]] bool check(std::size_t bytes);
  /// Checks all positions, before they are stored. Returns the same as check().
  [[nodiscard]] bool check_places();

 private:
  MemoryWatch settings_{};
  MemoryWatch places_{};
  std::uint32_t places_revision_ = 0;
  bool is_sound_ = true;
};

}  // namespace cnc
