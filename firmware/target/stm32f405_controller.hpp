#pragma once

/// Declarations that the sources of an image share: the board, whose header and name the build
/// sets, and the objects that stm32f405_main.cpp sets up.

#include KERFLINE_BOARD_HEADER
#include "firmware/application.hpp"
#include "firmware/target/stm32f405_can.hpp"
#include "hal/stm32f405/port.hpp"
#include "hal/stm32f405/serial_line.hpp"
#include "hal/stm32f405/usb/usb_line.hpp"

namespace target {

inline constexpr const hal::stm32f405::Board& kBoard = hal::stm32f405::KERFLINE_BOARD;
using Port = hal::stm32f405::Port<kBoard>;
using SerialLine = hal::stm32f405::SerialLine<kBoard>;
using UsbLine = hal::stm32f405::UsbLine<kBoard>;
using Can = CanSide<kBoard>;
using Application = cnc::Controller<Port>;
using Steps = Application::Steps;

extern Port port;
extern SerialLine line;
extern UsbLine usb_line;
extern Steps steps;
extern Application application;

}  // namespace target

/// For a debugger: number of boundaries at which the handover of the cycle that was due was
/// missing.
extern "C" std::uint32_t late_turns;
/// For a debugger: number of cycles that were due but not complete at the last boundary. Written
/// before `late_turns`.
extern "C" std::uint32_t turns_behind;

/// Instantiated in stm32f405_steps.cpp, which is compiled for speed on every board.
extern template class cnc::StepPlayer<target::Port, target::Application::kSegmentQueue>;
extern template class cnc::StepGenerator<target::Port, target::Application::kSegmentQueue>;
