#pragma once

#include "firmware/machine/settings.hpp"
#include "planner/motion/shaper_impulses.hpp"

/// Settings that are the same for each axis, for the table to name and number.
namespace cnc::axis_setting {

using motion::ShaperSetting;

/// Of one axis.
[[nodiscard]] constexpr SettingInfo of(std::uint16_t number,
                                       const char* name,
                                       SettingGroup group,
                                       SettingInfo all) {
  all.number = number;
  all.name = name;
  all.group = group;
  return all;
}

inline constexpr const char* kDecimals = "#####0.000";

// clang-format off
inline constexpr SettingInfo kBacklash{
    0, SettingGroup::kX, SettingType::kDecimal, "", "mm",
    0.0F, 2.0F, 0.0F, kDecimals,
    "How far the motor turns after a reversal until the axis follows; in whole steps."};
inline constexpr SettingInfo kTurningBacklash{
    0, SettingGroup::kA, SettingType::kDecimal, "", "deg",
    0.0F, 2.0F, 0.0F, kDecimals,
    kBacklash.help};
inline constexpr SettingInfo kShaper{
    0, SettingGroup::kX, SettingType::kChoice, "", "kind",
    0.0F, 4.0F, 0.0F, "None,ZV,ZVD,MZV,EI",
    "Keeps the axis from swinging; beam and all axes stay in step."};
inline constexpr SettingInfo kShaperFrequency{
    0, SettingGroup::kX, SettingType::kDecimal, "", "Hz",
    ShaperSetting::kLeastFrequency, ShaperSetting::kMostFrequency, 40.0F, kDecimals,
    "At which the axis swings, undamped."};
inline constexpr SettingInfo kShaperDamping{
    0, SettingGroup::kX, SettingType::kDecimal, "", "ratio",
    0.0F, ShaperSetting::kMostDamping, 0.1F, kDecimals,
    "Damping ratio of the swing."};
// clang-format on

}  // namespace cnc::axis_setting
