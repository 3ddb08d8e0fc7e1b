#include "firmware/machine/machine.hpp"

namespace cnc {

/// Where places are changed, they are trusted anew as they are; so is what follows
/// from settings, after a look at what they were before.
void Machine::watch_memory() {
  settings_watch_.add_object(settings_);
  settings_watch_.add_object(power_table_);
  settings_watch_.add_object(limits_);
  settings_watch_.add_object(interpreter_.options());
  settings_watch_.add_object(tool_.settings());
  settings_watch_.add_object(rest_light_.allowance());
  settings_watch_.add(drive_.set_up_memory());
  places_watch_.add_object(interpreter_.places());
  trust_places();
}

void Machine::trust_places() {
  places_revision_ = interpreter_.places_revision();
  places_watch_.accept();
}

void Machine::set_places(const gcode::StoredPlaces& places) {
  interpreter_.set_places(places);
  trust_places();
}

bool Machine::check_memory(std::size_t bytes) {
  const bool settings_are_sound = settings_watch_.check(bytes);
  const bool places_are = places_watch_.check(bytes);
  memory_is_sound_ = memory_is_sound_ && settings_are_sound && places_are;
  return memory_is_sound_;
}

/// All of what motion is planned by, before any of it is driven: an acceleration or jerk that
/// turned over might leave the beam lit on one place until a round has found it.
void Machine::check_settings() { memory_is_sound_ = memory_is_sound_ && settings_watch_.sound(); }

bool Machine::places_are_sound() {
  memory_is_sound_ = memory_is_sound_ && places_watch_.sound();
  return memory_is_sound_;
}

}  // namespace cnc
