#include "firmware/protocol/kerf_text.hpp"

#include <algorithm>

#include "planner/gcode/decimal.hpp"

namespace cnc {
namespace {

constexpr std::uint32_t kPartsOfUnit = 1000;
constexpr std::uint32_t kBillionthsOfPart = 1'000'000'000 / kPartsOfUnit;

/// Returns the value of a hexadecimal digit; 16 if `c` is not a hexadecimal digit.
std::uint32_t value_of_digit(char c) {
  if (c >= '0' && c <= '9') return static_cast<std::uint32_t>(c - '0');
  if (c >= 'A' && c <= 'F') return static_cast<std::uint32_t>(c - 'A' + 10);
  if (c >= 'a' && c <= 'f') return static_cast<std::uint32_t>(c - 'a' + 10);
  return 16;
}

/// Removes `,number` from the front of `text` and converts the number to whole thousandths. Returns
/// false if `text` does not begin with a comma and such a number.
bool take_thousandths(std::string_view& text, std::uint32_t& thousandths) {
  if (text.empty() || text.front() != ',') return false;
  text.remove_prefix(1);
  const auto reading = gcode::read_decimal(text);
  if (!reading.ok()) return false;
  const gcode::Decimal& value = reading.value().value;
  constexpr std::uint32_t kMaxWhole = 1'000'000;
  if (value.is_negative() || value.whole > kMaxWhole) return false;
  if (value.billionths % kBillionthsOfPart != 0) return false;
  thousandths = value.whole * kPartsOfUnit + value.billionths / kBillionthsOfPart;
  text.remove_prefix(reading.value().length);
  return true;
}

void put_thousandths(Reply& reply, std::uint32_t value) {
  reply.number(value / kPartsOfUnit);
  std::uint32_t rest = value % kPartsOfUnit;
  if (rest == 0) return;
  reply.letter('.');
  for (std::uint32_t digit = kPartsOfUnit / 10; rest != 0; digit /= 10) {
    reply.number(rest / digit);
    rest %= digit;
  }
}

void put_window(Reply& reply, std::uint32_t least, std::uint32_t most, std::string_view between) {
  put_thousandths(reply, least);
  reply.text(between);
  put_thousandths(reply, most);
}

void put_span(Reply& reply, std::uint32_t least, std::uint32_t most) {
  if (least == most) return put_thousandths(reply, least);
  put_window(reply, least, most, "-");
}

}  // namespace

bool read_kerf_part(std::string_view text, KerfPart& part) {
  const std::size_t colon = text.find(':');
  constexpr std::size_t kMaxDigits = 2;
  if (colon == 0 || colon == std::string_view::npos || colon > kMaxDigits) return false;
  part.number = 0;
  for (const char c : text.substr(0, colon)) {
    if (c < '0' || c > '9') return false;
    part.number = 10 * part.number + static_cast<std::size_t>(c - '0');
  }
  text.remove_prefix(colon + 1);
  part.size = text.size() / 2;
  if (text.size() % 2 != 0 || part.size > part.bytes.size()) return false;
  for (std::size_t i = 0; i < part.size; ++i) {
    const std::uint32_t high = value_of_digit(text[2 * i]);
    const std::uint32_t low = value_of_digit(text[2 * i + 1]);
    if (high > 15 || low > 15) return false;
    part.bytes[i] = static_cast<std::byte>(high << 4 | low);
  }
  return true;
}

void put_kerf_part(Reply& reply, std::size_t number, std::span<const std::byte> bytes) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  reply.text("$KW=").number(static_cast<std::uint32_t>(number)).letter(':');
  for (const std::byte byte : bytes) {
    const auto value = std::to_integer<std::size_t>(byte);
    reply.letter(kDigits[value >> 4]).letter(kDigits[value & 15U]);
  }
}

std::optional<KerfQuestion> read_kerf_question(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  KerfQuestion question{.name = {text.data(), comma}};
  text.remove_prefix(comma);
  const bool read = take_thousandths(text, question.condition.thickness_um) &&
                    take_thousandths(text, question.condition.power_mw) &&
                    take_thousandths(text, question.condition.speed_um_min) && text.empty();
  if (!read) return std::nullopt;
  return question;
}

void put_kerf_table(Reply& reply, const kerf::TableView<float>& table, bool built_in) {
  std::uint32_t least = kerf::kMaxPowerMw;
  std::uint32_t most = 0;
  for (const kerf::Band& band : table.bands) {
    least = std::min(least, band.power_mw);
    most = std::max(most, band.power_mw);
  }
  reply.text("[KERF:").text(table.name).letter('|');
  reply.text(table.unit == kerf::HeatUnit::kJoulesPerMillimetre ? "J/mm" : "W/(mm/min)");
  reply.text("|T ");
  put_span(reply, table.rows.front().thickness_um, table.rows.back().thickness_um);
  reply.text("|P ");
  put_span(reply, least, most);
  reply.text(built_in ? "|built in]" : "|stored]");
}

void put_kerf_refusal(Reply& reply, const kerf::Refusal& refusal) {
  switch (refusal.reason) {
    case kerf::RefusalReason::kThickness:
      reply.text("thicknesses from ");
      put_window(reply, refusal.least, refusal.most, " to ");
      reply.text(" mm are permissible");
      return;
    case kerf::RefusalReason::kPower:
      reply.text("powers from ");
      put_window(reply, refusal.least, refusal.most, " to ");
      reply.text(" W are permissible");
      return;
    case kerf::RefusalReason::kSpeed:
      reply.text("speeds from ");
      put_window(reply, refusal.least, refusal.most, " to ");
      reply.text(" mm/min are permissible");
      return;
    case kerf::RefusalReason::kNoSpeed:
      reply.text("no speed is permissible by all neighbouring test cuts");
      return;
  }
}

void put_kerf_fault(Reply& reply, const kerf::TableFault& fault) {
  const auto say = [&](std::string_view what) {
    reply.text("kerf table has ").number(fault.count).text(what).number(fault.capacity);
  };
  switch (fault.error) {
    case kerf::TableError::kTooManyRows:
      return say(" thicknesses, capacity ");
    case kerf::TableError::kTooManyBands:
      return say(" powers, capacity ");
    case kerf::TableError::kTooManyPoints:
      return say(" measured speeds, capacity ");
    default:
      reply.text(kerf::describe(fault.error));
  }
}

}  // namespace cnc
