#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "firmware/protocol/listing.hpp"

namespace cnc {

enum class StatementKind : std::uint8_t {
  kListing,         ///< Request for a listing: its kind is in `listing`, its argument in `number`.
  kChangeSetting,   ///< `$110=`
  kSetUserText,     ///< `$I=`
  kSetStartupLine,  ///< `$N0=`; `number` is 0 or 1.
  kCheck,           ///< `$C`
  kUnlock,          ///< `$X`
  kHome,            ///< `$H`, `$HXY`; axes in `axes`, 0 for all axes.
  kJog,             ///< `$J=`
  kSleep,           ///< `$SLP`
  kRestore,         ///< `$RST=`
  kSetPowerTable,   ///< `$PC=`
  kBlockDelete,     ///< `$B`
  kBootLoader,      ///< `$DFU`
  kListKerfTables,  ///< `$K`
  kWriteKerfPart,   ///< `$KW=`
  kKeepKerfTable,   ///< `$KS`
  kEraseKerfTable,  ///< `$KE=`
  kReadKerfTable,   ///< `$KR=`
  kAskKerf,         ///< `$KQ=`
  kAskProgress,     ///< `$RESUME`
  kReenter,         ///< `$RESUME=`
};

/// The parts of a line that begins with `$`.
struct Statement {
  StatementKind kind = StatementKind::kListing;
  ListingKind listing = ListingKind::kNone;
  std::uint16_t number = 0;
  std::uint8_t axes = 0;
  /// Text after the `=`, without blanks at its ends and without a comment.
  std::string_view text{};
  std::uint16_t column = 0;  ///< Column of the first character of `text` in the line, from 1.
};

/// Reads a line that begins with `$`. Returns nothing if there is no statement of that name. Names
/// may have lower-case letters and blanks.
[[nodiscard]] std::optional<Statement> read_statement(std::string_view line);

}  // namespace cnc
