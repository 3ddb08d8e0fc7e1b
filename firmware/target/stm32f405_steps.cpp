/// The step interrupt of an STM32F405 and all that it calls. The file is compiled for speed, on
/// boards whose image is compiled for size, too.

#include "firmware/target/stm32f405_controller.hpp"

template class cnc::StepGenerator<target::Port, target::Application::kSegmentQueue>;

namespace {

/// A turn begins, with what has come by now.
void begin_turn() {
  const std::uint32_t turn = target::steps.begin_turn();
  turns_behind = target::steps.turns_behind();
  late_turns = target::steps.late_turns();
  target::line.note_turn(turn);
  target::usb_line.note_turn(turn);
  target::Can::note_turn(turn);
}

}  // namespace

extern "C" void step_interrupt();
void step_interrupt() {
  target::port.timer().on_interrupt([] { return target::steps.on_interrupt(); }, begin_turn);
}
