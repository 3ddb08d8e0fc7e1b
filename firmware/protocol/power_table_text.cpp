#include "firmware/protocol/power_table_text.hpp"

#include <optional>

#include "planner/gcode/decimal.hpp"

namespace cnc {
namespace {

using motion::PowerPoint;
using motion::PowerTable;
using motion::PowerTableError;

constexpr std::uint32_t kBillion = 1'000'000'000;
constexpr std::uint32_t kDutyParts = 100;
constexpr std::uint32_t kMilliwatts = 1000;

std::string_view describe(PowerTableError error) {
  switch (error) {
    case PowerTableError::kTooManyPoints:
      return "a power table has at most 16 points";
    case PowerTableError::kBeyondRange:
      return "a duty is at most 100 percent, a power at most 10000 W";
    case PowerTableError::kLightWithoutDuty:
      return "a duty of 0 gives no light";
    case PowerTableError::kDutyNotRising:
      return "the duty must rise from point to point";
    case PowerTableError::kWattsNotRising:
      return "the watts must rise from point to point";
  }
  return {};
}

/// Removes a number from the front of `text`. Returns the number as a multiple of 1 / `parts`;
/// nothing if `text` does not begin with such a number.
std::optional<std::uint32_t> take_number(std::string_view& text, std::uint32_t parts) {
  const auto reading = gcode::read_decimal(text);
  if (!reading.ok()) return std::nullopt;
  const gcode::Decimal& value = reading.value().value;
  constexpr std::uint32_t kMaxWhole = 1'000'000;
  if (value.is_negative() || value.whole > kMaxWhole) return std::nullopt;
  const std::uint32_t part = kBillion / parts;
  if (value.billionths % part != 0) return std::nullopt;
  text.remove_prefix(reading.value().length);
  return value.whole * parts + value.billionths / part;
}

bool take_letter(std::string_view& text, char letter) {
  if (text.empty() || text.front() != letter) return false;
  text.remove_prefix(1);
  while (!text.empty() && gcode::is_blank(text.front())) text.remove_prefix(1);
  return true;
}

std::optional<PowerPoint> take_point(std::string_view& text) {
  const auto duty = take_number(text, kDutyParts);
  if (!duty || !take_letter(text, ':')) return std::nullopt;
  const auto watts = take_number(text, kMilliwatts);
  if (!watts) return std::nullopt;
  constexpr std::uint32_t kBeyond = PowerPoint::kFullDuty + 1;
  return PowerPoint{static_cast<std::uint16_t>(*duty < kBeyond ? *duty : kBeyond), *watts};
}

}  // namespace

Result<PowerTable, PowerTableRefusal> read_power_table(std::string_view text) {
  std::array<PowerPoint, PowerTable::kMaxPoints> points{};
  std::size_t count = 0;
  std::string_view rest = text;
  const auto here = [&] { return static_cast<std::uint32_t>(text.size() - rest.size()); };
  while (!rest.empty()) {
    const std::uint32_t column = here();
    if (count == points.size()) {
      return PowerTableRefusal{column, describe(PowerTableError::kTooManyPoints)};
    }
    const auto point = take_point(rest);
    if (!point)
      return PowerTableRefusal{here(), "not a list of the form percent:watts,percent:watts"};
    points[count++] = *point;
    // The table is checked after each point, so that the refusal can name the first wrong point.
    const auto so_far = PowerTable::make(std::span{points}.first(count));
    const bool threshold = count == 1 && point->milliwatts == 0 && !rest.empty();
    if (!so_far.ok() && !threshold) return PowerTableRefusal{column, describe(so_far.error())};
    if (!rest.empty() && !take_letter(rest, ',')) {
      return PowerTableRefusal{here(), "a comma is missing between two points"};
    }
  }
  const auto table = PowerTable::make(std::span{points}.first(count));
  if (!table.ok()) return PowerTableRefusal{here(), describe(table.error())};
  return table.value();
}

void put_power_table(Reply& reply, const PowerTable& table) {
  bool first = true;
  for (const PowerPoint& point : table.points()) {
    if (!first) reply.letter(',');
    first = false;
    reply.value(static_cast<float>(point.duty) / static_cast<float>(kDutyParts), 0);
    reply.letter(':').value(static_cast<float>(point.milliwatts) / static_cast<float>(kMilliwatts),
                            0);
  }
}

}  // namespace cnc
