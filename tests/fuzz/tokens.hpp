#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include "firmware/machine/settings.hpp"
#include "firmware/protocol/statement.hpp"

/// Lines and realtime bytes that a fuzzer of the controller's link combines.
namespace fuzz {

// clang-format off
inline constexpr std::array kTokens = std::to_array<std::string_view>({
    // Statements that example_of() lacks.
    "$\n", "$$\n", "$#\n", "$G\n", "$I\n", "$I+\n", "$N\n", "$ES\n", "$EG\n", "$ESH\n", "$EA\n",
    "$EE\n", "$PC\n", "$K\n", "$KS\n", "$C\n", "$X\n", "$H\n", "$HX\n", "$HYZ\n", "$HA\n", "$SLP\n",
    "$DFU\n", "$RESUME\n", "$RESUME=0\n", "$RESUME=5\n", "$RESUME=7\n", "$RST=$\n", "$RST=#\n",
    "$RST=*\n", "$I=abc\n", "$N0=G21\n", "$N1=G90\n", "$N1=\n", "$N1=G7\n",
    "$KW=0:4b465401\n", "$KE=*\n", "$KE=CSP 1N\n", "$KR=CSP 1N\n", "$KQ=CSP 1N,10,1500,300\n",
    "$PC=0:0,10:5,100:1500\n", "$PC=\n", "$J=G91X1F6000\n", "$J=X-3Y2F9000\n", "$J=G53Z-1F500\n",
    // Settings that switch features on and off.
    "$0=1\n", "$1=255\n", "$3=7\n", "$10=511\n", "$11=0\n", "$11=0.2\n", "$12=0\n", "$13=1\n",
    "$20=1\n", "$20=0\n", "$21=1\n", "$22=0\n", "$22=1\n", "$22=3\n", "$22=7\n", "$22=15\n",
    "$23=7\n", "$27=0\n", "$27=50\n", "$30=1\n", "$31=900\n", "$32=1\n", "$32=0\n", "$40=1\n",
    "$41=1\n", "$42=0\n", "$43=3\n", "$44=63\n", "$58=0\n", "$100=0.01\n", "$100=100000\n",
    "$101=37.3\n", "$103=9999\n", "$110=1\n", "$110=1000000\n", "$120=0.1\n", "$120=1000000\n",
    "$130=1000000\n", "$133=1\n", "$160=0.5\n", "$161=2\n", "$341=1\n", "$392=0\n", "$392=0.1\n",
    "$394=0.1\n", "$481=50\n", "$800=2000\n", "$801=1000000000\n", "$802=1\n", "$810=1\n",
    "$811=4\n", "$820=20\n", "$830=0.9\n", "$850=0.5\n", "$852=7\n", "$853=6\n", "$854=50\n",
    "$855=5000\n", "$856=5000\n", "$857=-5000\n", "$857=3000\n", "$858=0\n", "$858=1\n", "$859=5\n",
    "$860=1\n", "$890=0\n", "$B\n", "$37=4\n", "$884=50\n", "$29=2\n", "$14=24\n", "$870=100\n",
    "$870=5\n", "$871=60000\n", "$871=20\n",
    // G-code.
    "G0X5Y-3\n", "G1X9F3000\n", "G1X0Y0Z0F9000\n", "N5G1X2Y2F900\n", "N7G1X4\n", "N7G2X0Y4R5\n",
    "G2X0Y0I-3J1F5000\n", "G3X3Y3R4P3\n", "G5X4Y4I1J3P-1Q-2\n", "G5.1X3Y0I1J1\n",
    "G5.2P1X1Y1L3\n", "X2Y0\n", "X3Y2\n", "X4Y4\n", "G5.3\n", "G38.2Z-4F600\n", "G38.3X9F6000\n",
    "G38.4Z1F99\n", "G4P0.03\n", "G4P0\n", "M3S500\n", "M4S900\n", "M3S0\n", "M5\n", "S1:5:9X7\n",
    "G1X5S0:120:300\n", "M6T3\n", "T2M6M3S9G1X3F600\n", "M0\n", "M1\n", "M2\n", "M30\n", "M7\n",
    "M9\n", "M62P1\n", "M67E2Q0.5\n", "G10L1P2R0.4\n", "G10L2P1X1\n", "G10L20P0X0Y0\n", "G28.1\n",
    "G28X1\n", "G30\n", "G92X7\n", "G92.1\n", "G43.1Z2\n", "G49\n", "G41.1D0.4\n", "G42.1D1\n",
    "T2\n", "G41D2\n", "G41\n", "G40\n", "M190P0Q10\n", "F300S1000\n", "G61.1\n", "G64P0.1Q0.05\n",
    "G91\n", "G90\n", "G93\n", "G94\n", "G20\n", "G21\n", "G18\n", "G17\n", "G55\n", "G80\n",
    "/G0X9\n",
    // Circles and lines as large as the machine accepts, and elements of a nanometre.
    "G91G3X.04Y.03I-402653.2024J536870.9782\n", "G91G2X.05R600000\n", "G3Y20000R1000000\n",
    "G91G1X9000\n", "G91G1Y-9000\n", "G91G1X.000001\n", "G91G2X.000003R2\n",
    "N1G1X5*86\n", "N0M110*125\n", "M110\n", "M110N0\n", "M62P2\n", "M63P2\n",
    // Realtime bytes.
    "?", "!", "~", "\x18", "\x83", "\x84", "\x85", "\x87", "\x88", "\x89", "\x8C", "\x91", "\x96",
    "\x9A", "\x9D", "\x9E", "\xA0", "\xA1", "\xA3", "\r", "\r\n",
});
// clang-format on

/// Returns a line for each kind of statement, and an empty text after the last kind. A missing kind
/// is a compiler warning, which is an error.
constexpr std::string_view example_of(cnc::StatementKind kind) {
  using enum cnc::StatementKind;
  switch (kind) {
    case kListing:
      return "$110\n";
    case kChangeSetting:
      return "$110=9000\n";
    case kSetUserText:
      return "$I=x\n";
    case kSetStartupLine:
      return "$N0=G41.1D20G1X1F600\n";
    case kCheck:
      return "$C\n";
    case kUnlock:
      return "$X\n";
    case kHome:
      return "$HXY\n";
    case kJog:
      return "$J=G91Y1F3000\n";
    case kSleep:
      return "$SLP\n";
    case kRestore:
      return "$RST=$\n";
    case kSetPowerTable:
      return "$PC=0:0,50:3,100:10\n";
    case kBlockDelete:
      return "$B\n";
    case kBootLoader:
      return "$DFU\n";
    case kListKerfTables:
      return "$K\n";
    case kWriteKerfPart:
      return "$KW=0:00\n";
    case kKeepKerfTable:
      return "$KS\n";
    case kEraseKerfTable:
      return "$KE=*\n";
    case kReadKerfTable:
      return "$KR=CSP 1N\n";
    case kAskKerf:
      return "$KQ=CSP 1N,5,1000,900\n";
    case kAskProgress:
      return "$RESUME\n";
    case kReenter:
      return "$RESUME=7\n";
  }
  return {};
}

/// Returns a line for one of all kinds of statements.
inline std::string_view statement_token(std::uint8_t which) {
  static const std::size_t kinds = [] {
    std::size_t count = 0;
    while (!example_of(static_cast<cnc::StatementKind>(count)).empty()) ++count;
    return count;
  }();
  return example_of(static_cast<cnc::StatementKind>(which % kinds));
}

/// Returns a line that changes one of all settings to a value in its range: the least, the default,
/// the greatest or another one.
inline std::string setting_token(std::uint8_t which, std::uint8_t value) {
  const auto table = cnc::setting_table();
  const cnc::SettingInfo info = table[which % table.size()];
  const float share = static_cast<float>(value) / 255.0F;
  float wanted = info.least + share * share * (info.most - info.least);
  if (value == 0) wanted = info.standard;
  if (info.is_whole()) wanted = static_cast<float>(static_cast<std::int64_t>(wanted));
  std::array<char, 48> text{};
  std::snprintf(text.data(),
                text.size(),
                "$%u=%.3f\n",
                static_cast<unsigned>(info.number),
                static_cast<double>(wanted));
  return text.data();
}

/// Returns `length` bytes of short lines; the last line may be cut off.
inline std::string_view long_token(std::uint8_t length) {
  static const std::string lines = [] {
    std::string text;
    while (text.size() < 256 * 24) text += text.size() % 2 == 0 ? "G1X2\n" : "N7X1F900\r\n";
    return text;
  }();
  return std::string_view{lines}.substr(0, std::size_t{24} * length);
}

}  // namespace fuzz
