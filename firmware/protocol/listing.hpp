#pragma once

#include <cstdint>

#include "firmware/machine/machine.hpp"
#include "firmware/protocol/reply.hpp"
#include "firmware/protocol/report_lines.hpp"
#include "firmware/store/kerf_tables.hpp"
#include "firmware/store/stored_state.hpp"
#include "hal/interface/control_board.hpp"

namespace cnc {

/// Kinds of listings, each with its statement. A listing is an answer of one or many lines.
enum class ListingKind : std::uint8_t {
  kNone,
  kHelp,            ///< `$`
  kSettings,        ///< `$$`
  kOneSetting,      ///< `$110`; the argument is the setting's number.
  kParameters,      ///< `$#`
  kParserState,     ///< `$G`
  kBuildInfo,       ///< `$I`
  kExtendedInfo,    ///< `$I+`
  kStartupLines,    ///< `$N`
  kSettingDetails,  ///< `$ES`
  kSettingGroups,   ///< `$EG`
  kSettingHelp,     ///< `$ESH`
  kAlarms,          ///< `$EA`
  kErrors,          ///< `$EE`
  kPowerTable,      ///< `$PC`
  kKerfTables,      ///< `$K`
  kKerfImage,       ///< `$KR=`; the argument is the table's index.
};

/// Makes a listing line by line, as fast as the link takes the lines: `$ES` has more bytes than the
/// memory can hold, and a status report must not wait for the end of the listing.
class Listing {
 public:
  /// @param board board for `$I+`; may be null
  Listing(const Machine& machine, StoredState& stored, KerfTables& kerf, hal::ControlBoard* board)
      : machine_{machine}, stored_{stored}, kerf_{kerf}, board_{board} {}

  void begin(ListingKind kind, std::uint16_t argument = 0);
  void stop() { kind_ = ListingKind::kNone; }
  [[nodiscard]] bool active() const { return kind_ != ListingKind::kNone; }

  /// Writes the next line. Returns false and writes nothing after the last line.
  [[nodiscard]] bool next(Reply& reply, const ReportForm& form);

 private:
  [[nodiscard]] bool row(Reply& reply, const ReportForm& form);
  [[nodiscard]] bool settings_row(Reply& reply);
  [[nodiscard]] bool parameters_row(Reply& reply, const ReportForm& form);
  [[nodiscard]] bool tool_row(Reply& reply, const ReportForm& form);
  [[nodiscard]] bool info_row(Reply& reply, const ReportForm& form);
  [[nodiscard]] bool extended_info_row(Reply& reply, const ReportForm& form, std::size_t row);
  [[nodiscard]] bool board_row(Reply& reply, std::size_t row);
  [[nodiscard]] bool startup_row(Reply& reply);
  [[nodiscard]] bool kerf_row(Reply& reply);
  [[nodiscard]] bool kerf_image_row(Reply& reply);
  void put_version(Reply& reply);

  const Machine& machine_;
  StoredState& stored_;
  KerfTables& kerf_;
  hal::ControlBoard* board_;
  ListingKind kind_ = ListingKind::kNone;
  std::size_t row_ = 0;
  std::uint16_t argument_ = 0;
};

}  // namespace cnc
