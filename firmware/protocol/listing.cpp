#include "firmware/protocol/listing.hpp"

#include <array>
#include <string_view>

#include "firmware/link/receiver.hpp"
#include "firmware/protocol/identity.hpp"
#include "firmware/protocol/kerf_text.hpp"
#include "firmware/protocol/power_table_text.hpp"
#include "firmware/protocol/table_lines.hpp"

namespace cnc {
namespace {

constexpr std::string_view kHelp =
    "[HLP:$$ $# $G $I $N $x=val $Nx=line $J=line $SLP $C $X $H ~ ! ? ctrl-x]";

void put_place_line(Reply& reply,
                    std::string_view name,
                    const Position& place,
                    const ReportForm& form) {
  reply.letter('[').text(name).letter(':');
  put_places(reply, place, form);
  reply.letter(']').end();
}

}  // namespace

void Listing::begin(ListingKind kind, std::uint16_t argument) {
  kind_ = kind;
  row_ = 0;
  argument_ = argument;
}

bool Listing::next(Reply& reply, const ReportForm& form) {
  if (!active()) return false;
  if (row(reply, form)) {
    ++row_;
    return true;
  }
  stop();
  return false;
}

bool Listing::row(Reply& reply, const ReportForm& form) {
  switch (kind_) {
    case ListingKind::kNone:
      return false;
    case ListingKind::kHelp:
      if (row_ == 0) reply.text(kHelp).end();
      return row_ == 0;
    case ListingKind::kSettings:
    case ListingKind::kOneSetting:
      return settings_row(reply);
    case ListingKind::kParameters:
      return parameters_row(reply, form);
    case ListingKind::kParserState:
      if (row_ == 0) put_parser_state(reply, machine_);
      return row_ == 0;
    case ListingKind::kBuildInfo:
    case ListingKind::kExtendedInfo:
      return info_row(reply, form);
    case ListingKind::kStartupLines:
      return startup_row(reply);
    case ListingKind::kSettingDetails:
      return put_setting_details(reply, row_);
    case ListingKind::kSettingGroups:
      return put_setting_group(reply, row_);
    case ListingKind::kSettingHelp:
      return put_setting_help(reply, row_);
    case ListingKind::kAlarms:
      return put_alarm_text(reply, row_);
    case ListingKind::kErrors:
      return put_error_text(reply, row_);
    case ListingKind::kPowerTable:
      if (row_ > 0) return false;
      reply.text("$PC=");
      put_power_table(reply, machine_.power_table());
      reply.end();
      return true;
    case ListingKind::kKerfTables:
      return kerf_row(reply);
    case ListingKind::kKerfImage:
      return kerf_image_row(reply);
  }
  return false;
}

/// Writes the next row. There is a row for each kerf table, and then a row with the number of
/// stored tables and its maximum.
bool Listing::kerf_row(Reply& reply) {
  const std::size_t count = kerf_.count();
  if (row_ > count) return false;
  if (row_ == count) {
    reply.text("[KERFROOM:").number(static_cast<std::uint32_t>(kerf_.stored())).text(" of ");
    reply.number(KerfTables::kMaxStored).text(" stored]").end();
    return true;
  }
  const auto table = kerf_.table(row_);
  if (table.ok()) {
    put_kerf_table(reply, table.value(), row_ < KerfTables::built_in());
  } else {
    reply.text("[KERF:?|damaged]");
  }
  reply.end();
  return true;
}

/// Writes the next row of a kerf table's image. The rows are statements; if they are sent to a
/// controller, it stores the table.
bool Listing::kerf_image_row(Reply& reply) {
  if (row_ > KerfTables::kMaxParts) return false;
  std::array<std::byte, KerfTables::kPartBytes> bytes{};
  const std::size_t size = kerf_.read_part(argument_, row_, bytes);
  if (size > 0) {
    put_kerf_part(reply, row_, std::span{bytes}.first(size));
  } else {
    reply.text("$KS");
    row_ = KerfTables::kMaxParts;  // Ends the listing after this row.
  }
  reply.end();
  return true;
}

bool Listing::settings_row(Reply& reply) {
  const auto table = setting_table();
  if (kind_ == ListingKind::kOneSetting) {
    const auto info = find_setting(argument_);
    if (row_ > 0 || !info) return false;
    put_setting(reply, *info, machine_.settings().get(info->number));
    return true;
  }
  if (row_ == table.size()) return false;
  const SettingInfo info = table[row_];
  put_setting(reply, info, machine_.settings().get(info.number));
  return true;
}

/// Writes the next tool with its radius; leaves out tools whose radius is zero.
bool Listing::tool_row(Reply& reply, const ReportForm& form) {
  constexpr std::size_t kBefore = gcode::kCoordinateSystemCount + 5;
  for (; row_ < kBefore + gcode::kToolCount; ++row_) {
    const std::size_t tool = row_ - kBefore;
    const auto& rows = machine_.interpreter().places().tool_radii;
    const Coordinate radius = rows[tool / kAxisCount][tool % kAxisCount];
    if (radius == Coordinate{}) continue;
    reply.text("[TOOL:").number(static_cast<std::uint32_t>(tool + 1)).letter('|');
    reply.place(radius, form.inches).letter(']').end();
    return true;
  }
  return false;
}

bool Listing::parameters_row(Reply& reply, const ReportForm& form) {
  constexpr std::size_t kSystems = gcode::kCoordinateSystemCount;
  const gcode::Interpreter& interpreter = machine_.interpreter();
  const gcode::StoredPlaces& places = interpreter.places();
  if (row_ < kSystems) {
    put_place_line(reply, name_of_system(row_), places.systems[row_], form);
    return true;
  }
  switch (row_ - kSystems) {
    case 0:
      put_place_line(reply, "G28", places.g28, form);
      return true;
    case 1:
      put_place_line(reply, "G30", places.g30, form);
      return true;
    case 2: {
      const gcode::Shift& shift = interpreter.shift();
      put_place_line(reply, "G92", shift.g92_in_use ? shift.g92 : Position{}, form);
      return true;
    }
    case 3:
      reply.text("[TLO:").place(interpreter.shift().tool_length, form.inches).letter(']').end();
      return true;
    case 4:
      put_probe(reply, machine_.last_probe(), form);
      return true;
    default:
      return tool_row(reply, form);
  }
}

void Listing::put_version(Reply& reply) {
  const StoredText text = stored_.load_user_text();
  reply.text("[VER:").text(identity::kVersion).letter(':').text(text.view()).letter(']').end();
}

bool Listing::info_row(Reply& reply, const ReportForm& form) {
  switch (row_) {
    case 0:
      put_version(reply);
      return true;
    case 1:
      reply.text("[OPT:").text(identity::kOptions).letter(',');
      reply.number(motion::kLookAheadBlocks).letter(',');
      reply.number(Receiver::kAdvertisedBytes).letter(']').end();
      return true;
    case 2:
      reply.text("[KERFLINE:").text(identity::version()).letter(']').end();
      return true;
    default:
      return kind_ == ListingKind::kExtendedInfo && extended_info_row(reply, form, row_ - 3);
  }
}

bool Listing::extended_info_row(Reply& reply, const ReportForm& form, std::size_t row) {
  switch (row) {
    case 0:
      reply.text("[AXS:").number(static_cast<std::uint32_t>(form.axes)).letter(':');
      reply.text({kAxisLetters.data(), form.axes}).letter(']').end();
      return true;
    case 1:
      reply.text("[NEWOPT:").text(identity::kNewOptions).letter(']').end();
      return true;
    case 2:
      reply.text("[FIRMWARE:").text(identity::kFirmware).letter(']').end();
      return true;
    case 3: {
      const hal::StoreWear wear = stored_.wear();
      reply.text("[STORE WEAR:").number(wear.erases).letter(',');
      reply.number(wear.bytes_to_next_erase).letter(']').end();
      return true;
    }
    case 4:
      reply.text("[LATE TURNS:").number(machine_.late_turns()).letter(']').end();
      return true;
    default:
      return board_row(reply, row - 5);
  }
}

bool Listing::board_row(Reply& reply, std::size_t row) {
  if (board_ == nullptr) return false;
  reply.letter('[');
  const std::size_t size = board_->describe(row, reply.room());
  if (size == 0) {
    reply.clear();
    return false;
  }
  reply.wrote(size);
  reply.letter(']').end();
  return true;
}

bool Listing::startup_row(Reply& reply) {
  if (row_ == StoredState::kStartupLines) return false;
  const StoredText line = stored_.load_startup_line(row_);
  reply.text("$N").number(static_cast<std::uint32_t>(row_)).letter('=').text(line.view()).end();
  return true;
}

}  // namespace cnc
