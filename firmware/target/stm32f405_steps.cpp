/// The step interrupt of an STM32F405 and all code that it calls. This file is compiled for speed,
/// even on boards whose image is compiled for size.

#include "firmware/target/stm32f405_controller.hpp"

template class cnc::StepPlayer<target::Port, target::Application::kSegmentQueue>;
template class cnc::StepGenerator<target::Port, target::Application::kSegmentQueue>;

namespace {

/// Begins a cycle. The cycle reads only bytes that arrived before this call.
void begin_turn() {
  const std::uint32_t turn = target::steps.player().begin_turn();
  turns_behind = target::steps.turns_behind();
  late_turns = target::steps.late_turns();
  target::line.note_turn(turn);
  target::usb_line.note_turn(turn);
  target::Can::note_turn(turn);
}

}  // namespace

extern "C" void step_interrupt();
void step_interrupt() {
  target::port.timer().on_interrupt([] { return target::steps.player().on_interrupt(); },
                                    begin_turn);
}
