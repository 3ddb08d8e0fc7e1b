#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "firmware/protocol/listing.hpp"

namespace cnc {

enum class StatementKind : std::uint8_t {
  kListing,         ///< Kind in `listing`, argument in `number`.
  kChangeSetting,   ///< `$110=`
  kSetUserText,     ///< `$I=`
  kSetStartupLine,  ///< `$N0=`; `number` is 0 or 1.
  kCheck,           ///< `$C`
  kUnlock,          ///< `$X`
  kHome,            ///< `$H`, `$HXY`; `axes`, 0 for all.
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
  std::string_view text{};   ///< Text after the `=`, without blanks and comment at its ends.
  std::uint16_t column = 0;  ///< Start of `text` in the line, from 1.
};

/// Reads a line that begins with `$`. Returns nothing if there is no such statement. Names may be
/// written in lower case and with blanks.
[[nodiscard]] std::optional<Statement> read_statement(std::string_view line);

}  // namespace cnc
