#pragma once

#include <array>

#include "tests/target/machine/timer.hpp"

namespace machine {

/// The timers by RM0090: table 1 (addresses), 7.3.13 and 7.3.14 (gates), table 61 (interrupts).
constexpr std::array<TimerKind, 14> kTimers = {{
    {{"TIM1", 0x4001'0000, {Bus::kApb2, 0}}, Bus::kApb2, 25, 27, 4, false, true},
    {{"TIM2", 0x4000'0000, {Bus::kApb1, 0}}, Bus::kApb1, 28, 28, 4, true},
    {{"TIM3", 0x4000'0400, {Bus::kApb1, 1}}, Bus::kApb1, 29, 29, 4},
    {{"TIM4", 0x4000'0800, {Bus::kApb1, 2}}, Bus::kApb1, 30, 30, 4},
    {{"TIM5", 0x4000'0C00, {Bus::kApb1, 3}}, Bus::kApb1, 50, 50, 4, true},
    {{"TIM6", 0x4000'1000, {Bus::kApb1, 4}}, Bus::kApb1, 54, 54, 0},
    {{"TIM7", 0x4000'1400, {Bus::kApb1, 5}}, Bus::kApb1, 55, 55, 0},
    {{"TIM8", 0x4001'0400, {Bus::kApb2, 1}}, Bus::kApb2, 44, 46, 4, false, true},
    {{"TIM9", 0x4001'4000, {Bus::kApb2, 16}}, Bus::kApb2, 24, 24, 2},
    {{"TIM10", 0x4001'4400, {Bus::kApb2, 17}}, Bus::kApb2, 25, 25, 1},
    {{"TIM11", 0x4001'4800, {Bus::kApb2, 18}}, Bus::kApb2, 26, 26, 1},
    {{"TIM12", 0x4000'1800, {Bus::kApb1, 6}}, Bus::kApb1, 43, 43, 2},
    {{"TIM13", 0x4000'1C00, {Bus::kApb1, 7}}, Bus::kApb1, 44, 44, 1},
    {{"TIM14", 0x4000'2000, {Bus::kApb1, 8}}, Bus::kApb1, 45, 45, 1},
}};

}  // namespace machine
