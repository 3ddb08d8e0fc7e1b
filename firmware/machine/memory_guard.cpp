#include "firmware/machine/memory_guard.hpp"

namespace cnc {

void MemoryGuard::trust_settings(bool are_sound) {
  settings_.accept();
  is_sound_ = is_sound_ && are_sound;
}

void MemoryGuard::trust_places(std::uint32_t revision) {
  places_revision_ = revision;
  places_.accept();
}

void MemoryGuard::check_settings() { is_sound_ = is_sound_ && settings_.sound(); }

bool MemoryGuard::check(std::size_t bytes) {
  const bool settings_are_sound = settings_.check(bytes);
  const bool places_are_sound = places_.check(bytes);
  is_sound_ = is_sound_ && settings_are_sound && places_are_sound;
  return is_sound_;
}

bool MemoryGuard::check_places() {
  is_sound_ = is_sound_ && places_.sound();
  return is_sound_;
}

}  // namespace cnc
