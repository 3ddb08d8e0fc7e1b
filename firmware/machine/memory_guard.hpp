#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/machine/memory_watch.hpp"

namespace cnc {

/// Keeps the checksums of settings and of stored places, and remembers whether a bit of either has
/// turned over since it was trusted. Main loop only.
class MemoryGuard {
 public:
  /// Watches settings, or memory that follows from them. The memory stays where it is.
  void watch_settings(MemoryWatch::Part part) { settings_.add(part); }
  template <typename Object>
  void watch_settings_in(const Object& object) {
    settings_.add_object(object);
  }
  /// Watches stored places. The object stays where it is.
  template <typename Object>
  void watch_places_in(const Object& object) {
    places_.add_object(object);
  }

  /// Trusts settings as they are, after a change of them.
  /// @param are_sound whether the settings agree with their own sum, which the change did not make
  void trust_settings(bool are_sound);
  /// Trusts places as they are.
  /// @param revision of the places, which changes with each change of them
  void trust_places(std::uint32_t revision);
  /// Returns the revision that was trusted last.
  [[nodiscard]] std::uint32_t trusted_places() const { return places_revision_; }

  /// Reads all settings, before motion is planned by them or a change of them is trusted: an
  /// acceleration or jerk that turned over might leave the beam lit on one place until a round has
  /// found it.
  void check_settings();
  /// Reads at most this many bytes more of settings, and of places. Returns false from then on when
  /// one of them has turned over.
  [[nodiscard]] bool check(std::size_t bytes);
  /// Reads all places, before they are stored. Returns as check() does.
  [[nodiscard]] bool check_places();

 private:
  MemoryWatch settings_{};
  MemoryWatch places_{};
  std::uint32_t places_revision_ = 0;
  bool is_sound_ = true;
};

}  // namespace cnc
