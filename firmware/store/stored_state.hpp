#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "firmware/machine/progress.hpp"
#include "firmware/machine/settings.hpp"
#include "firmware/store/stored_text.hpp"
#include "hal/interface/record_store.hpp"
#include "planner/gcode/modal_state.hpp"
#include "planner/motion/block/power_table.hpp"

namespace cnc {

/// The state that outlives power, as typed records in a RecordStore: settings, positions, start-up
/// lines, the user's text, the power table of the beam, and the progress of an interrupted program.
/// Only values that differ from the defaults have a record, so an empty store is the store of a new
/// controller.
///
/// Saving may take up to some seconds, so it is allowed only while nothing moves.
class StoredState {
 public:
  static constexpr std::size_t kStartupLines = 2;

  explicit StoredState(hal::RecordStore& store) : store_{store} {}

  /// Returns the stored value; nothing if the default applies. A damaged record is ignored, but
  /// sets damaged().
  [[nodiscard]] std::optional<float> load_setting(const SettingInfo& info);
  [[nodiscard]] bool save_setting(const SettingInfo& info, float value);

  /// Loads origins, tool radii and the G28/G30 positions. A position that is not stored is zero.
  [[nodiscard]] const gcode::StoredPlaces& load_places();
  /// Saves the positions that differ from the positions that were last loaded or saved.
  [[nodiscard]] bool save_places(const gcode::StoredPlaces& places);
  [[nodiscard]] bool forget_places();
  /// Returns the positions that were last loaded or saved.
  [[nodiscard]] const gcode::StoredPlaces& places() const { return saved_; }
  [[nodiscard]] bool has_saved(const gcode::StoredPlaces& places) const { return places == saved_; }

  [[nodiscard]] StoredText load_startup_line(std::size_t index);
  [[nodiscard]] bool save_startup_line(std::size_t index, std::string_view line);
  [[nodiscard]] StoredText load_user_text();
  [[nodiscard]] bool save_user_text(std::string_view text);

  /// Returns the stored power table; a table without points if none is stored.
  [[nodiscard]] motion::PowerTable load_power_table();
  [[nodiscard]] bool save_power_table(const motion::PowerTable& table);

  /// Returns the stored progress of an interrupted program; empty if no program was interrupted.
  [[nodiscard]] const Progress& load_progress();
  [[nodiscard]] bool save_progress(const Progress& progress);
  [[nodiscard]] bool has_saved(const Progress& progress) const { return progress == progress_; }
  [[nodiscard]] bool has_progress() const { return progress_.any(); }

  [[nodiscard]] hal::StoreWear wear() const { return store_.wear(); }
  /// Returns whether, since power-up, a saved record could not be read, or did not contain a valid
  /// value.
  [[nodiscard]] bool damaged() const { return found_damage_ || store_.damaged(); }

 private:
  [[nodiscard]] Position load_place(std::uint16_t number);
  [[nodiscard]] bool save_place(std::uint16_t number, const Position& place, Position& saved);
  [[nodiscard]] StoredText load_text(std::uint16_t number);
  [[nodiscard]] bool save_text(std::uint16_t number, std::string_view text);

  hal::RecordStore& store_;
  gcode::StoredPlaces saved_{};
  Progress progress_{};
  bool found_damage_ = false;
};

}  // namespace cnc
