#include <array>

#include "firmware/machine/settings.hpp"

namespace cnc {
namespace {

// Groups in the order of SettingGroup, each with the number of its parent.
constexpr std::array<SettingGroupInfo, kSettingGroupCount> kGroups{{
    {0, "General"}, {0, "Control signals"}, {0, "Limits"},  {0, "Homing"},
    {0, "Probing"}, {0, "Jogging"},         {0, "Spindle"}, {0, "Coolant"},
    {0, "Parking"}, {0, "Tool change"},     {0, "Stepper"}, {0, "Arcs"},
    {0, "Axes"},    {13, "X axis"},         {13, "Y axis"}, {13, "Z axis"},
    {13, "A axis"}, {13, "B axis"},         {13, "C axis"},
}};

}  // namespace

std::span<const SettingGroupInfo> setting_groups() { return kGroups; }

}  // namespace cnc
