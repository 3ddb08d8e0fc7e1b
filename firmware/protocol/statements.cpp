#include "firmware/protocol/code_texts.hpp"
#include "firmware/protocol/line_protocol.hpp"
#include "firmware/protocol/power_table_text.hpp"
#include "firmware/protocol/sender_words.hpp"
#include "firmware/protocol/table_lines.hpp"

namespace cnc {
namespace {

/// Reads a value. Returns false if `text` is not exactly one number.
bool read_value(std::string_view text, float& value) {
  const auto reading = gcode::read_decimal(text);
  if (!reading.ok() || reading.value().length != text.size()) return false;
  value = reading.value().value.to_float();
  return true;
}

}  // namespace

/// Returns whether the machine is at rest and no action waits. Only then may settings change and
/// texts be stored.
bool LineProtocol::rests() const {
  const MachineState state = machine_.state();
  return machine_.idle() && (state == MachineState::kIdle || state == MachineState::kAlarm ||
                             state == MachineState::kHold);
}

void LineProtocol::load_settings() {
  for (const SettingInfo& info : setting_table()) {
    const auto value = stored_.load_setting(info);
    // If a stored value is within its range but does not fit the other settings, it is ignored and
    // the default stays.
    if (value) static_cast<void>(machine_.change_setting(info.number, *value).ok());
  }
}

void LineProtocol::take_statement(std::string_view line) {
  const auto statement = read_statement(line);
  if (!statement) return refuse(error_number::kNoSuchStatement, 1, "no such $ statement");
  switch (statement->kind) {
    case StatementKind::kListing:
      if (statement->listing == ListingKind::kOneSetting && !find_setting(statement->number)) {
        return refuse(error_number::kNoSuchStatement, 1, describe(SettingError::kUnknown));
      }
      listing_.begin(statement->listing, statement->number);
      return acknowledge();
    case StatementKind::kJog:
      return jog(*statement);
    case StatementKind::kUnlock:
      return unlock();
    case StatementKind::kCheck:
      return toggle_check_mode();
    case StatementKind::kAskProgress:
      return tell_progress();
    default:
      break;
  }
  // The remaining statements store data, or require that the machine does nothing else.
  if (!rests()) return refuse(error_number::kNotIdle);
  const bool stores =
      statement->kind != StatementKind::kHome && statement->kind != StatementKind::kSleep;
  if (stores && machine_.tool_runs()) {
    return refuse(error_number::kNotIdle, 0, "only possible while beam and spindle are off");
  }
  take_command(*statement);
}

void LineProtocol::take_command(const Statement& statement) {
  switch (statement.kind) {
    case StatementKind::kChangeSetting:
      return change_setting(statement);
    case StatementKind::kSetUserText:
      return set_user_text(statement);
    case StatementKind::kSetStartupLine:
      return set_startup_line(statement);
    case StatementKind::kSetPowerTable:
      return set_power_table(statement);
    case StatementKind::kRestore:
      return restore(statement);
    case StatementKind::kHome:
      return home(statement);
    case StatementKind::kBlockDelete:
      message(machine_.toggle_block_delete() ? "Enabled" : "Disabled");
      return acknowledge();
    case StatementKind::kBootLoader:
      return enter_boot_loader();
    case StatementKind::kReenter:
      return reenter(statement);
    case StatementKind::kSleep:
      if (!machine_.sleep()) return refuse(error_number::kNotIdle);
      message("Sleeping");
      return acknowledge();
    default:
      return take_kerf_statement(statement);
  }
}

bool LineProtocol::store_setting(std::uint16_t number, float value) {
  const auto info = find_setting(number);
  return info && rests() && machine_.change_setting(number, value).ok() &&
         stored_.save_setting(*info, value);
}

void LineProtocol::change_setting(const Statement& statement) {
  float value = 0.0F;
  const auto info = find_setting(statement.number);
  if (!read_value(statement.text, value)) {
    return refuse(error_number::kNoSuchStatement, 1, "not a setting of the form $N=value");
  }
  if (!info) return refuse_setting(statement, SettingError::kUnknown);
  const auto stored = machine_.change_setting(info->number, value);
  if (!stored.ok()) return refuse_setting(statement, stored.error());
  if (!stored_.save_setting(*info, value)) return refuse(error_number::kStoreFailed);
  if (info->number == setting::kSoftLimits || info->number == setting::kHoming) {
    tell_waiting_limits();
  }
  acknowledge();
}

/// Reports that soft limits do not act yet, because no axis is homed and homing is disabled. The
/// soft limits of homed axes act. $20 does not require $22, so that the settings of a backup may be
/// restored in any order.
void LineProtocol::tell_waiting_limits() {
  const Settings& settings = machine_.settings();
  const bool waiting = settings.get(setting::kSoftLimits) != 0.0F && machine_.homed() == 0 &&
                       !has_homing_option(settings, homing_option::kEnabled);
  if (waiting) message("Soft limits ($20) wait for homing ($22)");
}

void LineProtocol::refuse_setting(const Statement& statement, SettingError error) {
  const auto info = find_setting(statement.number);
  if (!info) {
    return refuse(error_number::kNoSuchStatement, 1, describe(SettingError::kUnknown));
  }
  const bool low = error == SettingError::kBelowRange;
  const std::uint8_t number = low && statement.text.front() == '-' ? error_number::kNegativeValue
                              : low && info->number == setting::kStepPulse
                                  ? error_number::kPulseTooShort
                                  : error_number::kBadNumber;
  Reply reason = begin_reason(statement.column);
  reason.text(describe(error));
  if (low || error == SettingError::kAboveRange) put_range(reason, *info);
  refuse(number, reason);
}

void LineProtocol::jog(const Statement& statement) {
  if (machine_.state() == MachineState::kAlarm) return refuse(error_number::kLocked);
  if (machine_.tool_change().open() && machine_.inputs().door)
    return refuse(error_number::kDoorOpen);
  const auto refusal = machine_.jog(statement.text);
  if (!refusal) return acknowledge();
  if (refusal->fault) return refuse(*refusal->fault, statement.column, refusal->number);
  refuse(refusal->number);
}

void LineProtocol::home(const Statement& statement) {
  switch (machine_.why_not_home(statement.axes)) {
    case HomingRefusal::kNone:
      break;
    case HomingRefusal::kSwitchedOff:
      return refuse(error_number::kHomingDisabled);
    case HomingRefusal::kAllAxesOnly:
      return refuse(error_number::kHomingDisabled, 1, "$22=3 allows homing of single axes");
    case HomingRefusal::kDoorOpen:
      return refuse(error_number::kDoorOpen);
    case HomingRefusal::kEmergencyStop:
      return refuse(error_number::kEmergencyStop);
    case HomingRefusal::kNotNow:
      return refuse(error_number::kNotIdle);
  }
  machine_.home(statement.axes);
  owed_ = Owed::kHoming;
}

void LineProtocol::enter_boot_loader() {
  if (board_ == nullptr) {
    return refuse(error_number::kNoSuchStatement, 1, "this controller has no boot loader");
  }
  message("Leaving for the boot loader");
  board_->enter_boot_loader();
  acknowledge();
}

void LineProtocol::unlock() {
  if (machine_.state() != MachineState::kAlarm) return acknowledge();
  if (!machine_.unlock()) {
    if (machine_.inputs().door) {
      message("Check Door");
      return refuse(error_number::kDoorOpen);
    }
    if (machine_.inputs().emergency_stop) return refuse(error_number::kEmergencyStop);
    return refuse(error_number::kLocked, 0, "this alarm needs a reset before $X");
  }
  message("Caution: Unlocked");
  acknowledge();
}

void LineProtocol::toggle_check_mode() {
  const bool was_on = machine_.state() == MachineState::kCheck;
  if (!machine_.toggle_check_mode()) return refuse(error_number::kNotIdle);
  message(was_on ? "Disabled" : "Enabled");
  say_ok();
  beginning_ = was_on;  // Leaving check mode has the effect of a reset.
}

void LineProtocol::restore(const Statement& statement) {
  const std::string_view what = statement.text;
  const bool all = what == "*";
  if (!all && what != "$" && what != "#") {
    return refuse(error_number::kNoSuchStatement, statement.column, "$, # or * is missing");
  }
  bool kept = true;
  if (all || what == "$") {
    machine_.end_tool_centre();
    for (const SettingInfo& info : setting_table()) {
      static_cast<void>(machine_.change_setting(info.number, info.standard).ok());
      kept = stored_.save_setting(info, machine_.settings().get(info.number)) && kept;
    }
    machine_.set_power_table({});
    kept = stored_.save_power_table({}) && kept;
  }
  if (all || what == "#") {
    kept = stored_.forget_places() && kept;
    machine_.set_places(stored_.places());
  }
  if (all) {
    startup_trial_.reset();
    kept = stored_.save_user_text({}) && kept;
    kept = kerf_.forget_all() && kept;
    for (std::size_t i = 0; i < StoredState::kStartupLines; ++i) {
      kept = stored_.save_startup_line(i, {}) && kept;
    }
  }
  if (!kept) return refuse(error_number::kStoreFailed);
  message("Restoring defaults");
  say_ok();
  machine_.reset();
  beginning_ = true;
}

void LineProtocol::set_power_table(const Statement& statement) {
  const auto table = read_power_table(statement.text);
  if (!table.ok()) {
    return refuse(
        error_number::kBadNumber, statement.column + table.error().column, table.error().reason);
  }
  machine_.set_power_table(table.value());
  if (!stored_.save_power_table(table.value())) return refuse(error_number::kStoreFailed);
  acknowledge();
}

void LineProtocol::set_user_text(const Statement& statement) {
  if (statement.text.size() > StoredText::kLongest) return refuse(error_number::kTextTooLong);
  if (confuses_senders(statement.text)) {
    return refuse(
        error_number::kNoSuchStatement, statement.column, "senders would misread this text");
  }
  if (!stored_.save_user_text(statement.text)) return refuse(error_number::kStoreFailed);
  acknowledge();
}

}  // namespace cnc
