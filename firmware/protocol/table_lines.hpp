#pragma once

#include <cstddef>

#include "firmware/machine/settings.hpp"
#include "firmware/protocol/reply.hpp"

namespace cnc {

/// Writes a setting as `$110=12000.000`.
void put_setting(Reply& reply, const SettingInfo& info, float value);
/// Writes the range of a setting as `: 1.000 to 1000.000 mm`.
void put_range(Reply& reply, const SettingInfo& info);

// Each of the following functions writes row `row`, counted from 0, of a listing that grblHAL
// defines. It returns false and writes nothing if the listing has no such row.

/// Writes `[SETTING:number|group|name|unit|type|format|least|most|reboot|null]`.
[[nodiscard]] bool put_setting_details(Reply& reply, std::size_t row);
/// Writes `[SETTINGGROUP:number|parent|name]`.
[[nodiscard]] bool put_setting_group(Reply& reply, std::size_t row);
/// Writes `[SETTINGDESCR:number|help]`.
[[nodiscard]] bool put_setting_help(Reply& reply, std::size_t row);
/// Writes `[ALARMCODE:number||text]`.
[[nodiscard]] bool put_alarm_text(Reply& reply, std::size_t row);
/// Writes `[ERRORCODE:number||text]`.
[[nodiscard]] bool put_error_text(Reply& reply, std::size_t row);

}  // namespace cnc
