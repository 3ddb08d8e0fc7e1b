#include "firmware/protocol/table_lines.hpp"

#include <span>
#include <string_view>

#include "firmware/protocol/code_texts.hpp"

namespace cnc {
namespace {

constexpr std::uint32_t kDecimals = 3;

void put_value(Reply& reply, const SettingInfo& info, float value) {
  if (info.is_whole()) {
    reply.whole(value);
  } else {
    reply.value(value, kDecimals);
  }
}

constexpr bool is_measured(const SettingInfo& info) {
  return info.type == SettingType::kInteger || info.type == SettingType::kDecimal;
}

bool put_code_text(Reply& reply,
                   std::string_view kind,
                   std::span<const CodeText> texts,
                   std::size_t row) {
  if (row >= texts.size()) return false;
  reply.letter('[').text(kind).letter(':').number(texts[row].number);
  reply.text("||").text(texts[row].text).letter(']').end();
  return true;
}

}  // namespace

void put_setting(Reply& reply, const SettingInfo& info, float value) {
  reply.letter('$').number(info.number).letter('=');
  put_value(reply, info, value);
  reply.end();
}

void put_range(Reply& reply, const SettingInfo& info) {
  reply.text(": ");
  put_value(reply, info, info.least);
  reply.text(" to ");
  put_value(reply, info, info.most);
  reply.letter(' ').text(info.unit);
}

bool put_setting_details(Reply& reply, std::size_t row) {
  if (row >= setting_table().size()) return false;
  const SettingInfo info = setting_table()[row];
  reply.text("[SETTING:").number(info.number).letter('|');
  reply.number(static_cast<std::uint32_t>(info.group)).letter('|');
  if (info.axis_letter() != 0) reply.letter(info.axis_letter()).letter(' ');
  reply.text(info.name).letter('|');
  if (is_measured(info)) reply.text(info.unit);
  reply.letter('|').number(static_cast<std::uint32_t>(info.type)).letter('|');
  reply.text(info.format).letter('|');
  if (is_measured(info)) put_value(reply, info, info.least);
  reply.letter('|');
  if (is_measured(info)) put_value(reply, info, info.most);
  const bool after_reset = info.number == setting::kReportedAxes;
  reply.text(after_reset ? "|1|0]" : "|0|0]").end();
  return true;
}

bool put_setting_group(Reply& reply, std::size_t row) {
  const auto groups = setting_groups();
  if (row > groups.size()) return false;
  reply.text("[SETTINGGROUP:").number(static_cast<std::uint32_t>(row)).letter('|');
  if (row == 0) {
    reply.text("0|Root");
  } else {
    reply.number(groups[row - 1].parent).letter('|').text(groups[row - 1].name);
  }
  reply.letter(']').end();
  return true;
}

bool put_setting_help(Reply& reply, std::size_t row) {
  if (row >= setting_table().size()) return false;
  const SettingInfo info = setting_table()[row];
  reply.text("[SETTINGDESCR:").number(info.number);
  reply.letter('|').text(info.help.text()).letter(']').end();
  return true;
}

bool put_alarm_text(Reply& reply, std::size_t row) {
  return put_code_text(reply, "ALARMCODE", alarm_texts(), row);
}

bool put_error_text(Reply& reply, std::size_t row) {
  return put_code_text(reply, "ERRORCODE", error_texts(), row);
}

}  // namespace cnc
