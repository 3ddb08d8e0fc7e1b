#pragma once

#include <cstddef>

#include "firmware/machine/settings.hpp"
#include "firmware/protocol/reply.hpp"

namespace cnc {

/// Writes `$110=12000.000`.
void put_setting(Reply& reply, const SettingInfo& info, float value);
/// Writes `: 1.000 to 1000.000 mm`.
void put_range(Reply& reply, const SettingInfo& info);

// Each function writes a row of a listing of grblHAL's, from 0 on. It returns false, with nothing
// written, after the last row.

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
