#include "firmware/protocol/line_protocol.hpp"

#include "planner/gcode/decimal.hpp"

namespace cnc {
namespace {

// Grbl 1.1 numbers that are not about G-code.
constexpr std::uint32_t kInvalidStatement = 3;
constexpr std::uint32_t kNotIdle = 8;
constexpr std::uint32_t kLocked = 9;
constexpr std::uint32_t kLineOverflow = 11;
constexpr std::uint32_t kBadNumber = 2;
constexpr std::uint32_t kNegativeValue = 4;

struct SettingLine {
  std::uint16_t number;
  float value;
};

/// Reads `$N=value`; false when the line is not of that form.
bool read_setting(std::string_view line, SettingLine& setting) {
  const std::size_t equals = line.find('=');
  if (line.empty() || line.front() != '$' || equals == std::string_view::npos) return false;
  const std::string_view number_text{line.data() + 1, equals - 1};
  std::string_view value_text = line;
  value_text.remove_prefix(equals + 1);
  const auto number = gcode::read_decimal(number_text);
  const auto value = gcode::read_decimal(value_text);
  if (!number.ok() || number.value().length != number_text.size()) return false;
  if (!value.ok() || value.value().length != value_text.size()) return false;
  const gcode::Decimal& n = number.value().value;
  if (!n.is_integer() || n.minus || n.whole > 0xFFFFU) return false;
  setting = {static_cast<std::uint16_t>(n.whole), value.value().value.to_float()};
  return true;
}

}  // namespace

void LineProtocol::poll() {
  for (;;) {
    outbox_.send(link_);
    if (!outbox_.empty() || machine_.busy()) return;
    if (owes_answer_) {
      owes_answer_ = false;
      answer(Reply{}.text("ok\r\n"));
      continue;
    }
    if (!read_line()) return;
    if (assembler_.too_long()) {
      refuse(kLineOverflow, kLongestLine + 1, "line is longer than 256 characters");
    } else {
      handle(assembler_.line());
    }
  }
}

bool LineProtocol::read_line() {
  std::byte byte{};
  while (link_.read({&byte, 1}) == 1) {
    if (assembler_.add(static_cast<char>(byte))) return true;
  }
  return false;
}

void LineProtocol::handle(std::string_view line) {
  if (!line.empty() && line[0] == '$') return set_from(line);
  if (machine_.locked()) {
    return refuse(kLocked, 0, "locked after an alarm");
  }
  const gcode::Refusal refusal = machine_.accept(line);
  if (!refusal) {
    owes_answer_ = true;
    return;
  }
  Reply words;
  words.wrote(gcode::describe(*refusal, words.room()));
  refuse(static_cast<std::uint32_t>(refusal->code()), refusal->column, words.view());
}

void LineProtocol::set_from(std::string_view line) {
  SettingLine setting{};
  if (!read_setting(line, setting)) {
    return refuse(kInvalidStatement, 1, "not a setting of the form $N=value");
  }
  if (!machine_.idle()) return refuse(kNotIdle, 0, "settings change only while idle");
  const auto stored = machine_.change_setting(setting.number, setting.value);
  if (stored.ok()) return answer(Reply{}.text("ok\r\n"));
  const SettingError error = stored.error();
  const bool negative = error == SettingError::kBelowRange && setting.value < 0.0F;
  const std::uint32_t number = error == SettingError::kUnknown ? kInvalidStatement
                               : negative                      ? kNegativeValue
                                                               : kBadNumber;
  refuse(number, static_cast<std::uint32_t>(line.find('=')) + 2, describe(error));
}

void LineProtocol::refuse(std::uint32_t number, std::uint32_t column, std::string_view reason) {
  answer(Reply{}.text("[MSG:").number(column).text(": ").text(reason).text("]\r\n"));
  answer(Reply{}.text("error:").number(number).text("\r\n"));
}

void LineProtocol::answer(const Reply& reply) { outbox_.add(reply.view()); }

}  // namespace cnc
