#include "firmware/machine/machine.hpp"

namespace cnc {

/// Selects the memory whose checksum is watched. A change of the positions updates the checksum of
/// the positions. A change of the settings updates the checksum of the settings only after the old
/// content was checked.
void Machine::watch_memory() {
  memory_.watch_settings_in(set_up_);
  memory_.watch_settings_in(interpreter_.options());
  memory_.watch_settings_in(tool_.settings());
  memory_.watch_settings_in(rest_light_.allowance());
  memory_.watch_settings(drive_.set_up_memory());
  memory_.watch_places_in(interpreter_.places());
  trust_places();
}

void Machine::trust_places() { memory_.trust_places(interpreter_.places_revision()); }

void Machine::set_places(const gcode::StoredPlaces& places) {
  interpreter_.set_places(places);
  trust_places();
}

}  // namespace cnc
