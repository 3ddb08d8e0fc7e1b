/// The controller on an STM32F405: start-up, main loop and vectors. Code that runs before the
/// program is in stm32f405_start.cpp, code that ends the program is in stm32f405_ends.cpp, and the
/// step interrupt is in stm32f405_steps.cpp.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/link/link_choice.hpp"
#include "firmware/machine/memory_watch.hpp"
#include "firmware/steps/turn_gate.hpp"
#include "firmware/store/flash_log.hpp"
#include "firmware/target/stm32f405_controller.hpp"
#include "firmware/target/stm32f405_ends.hpp"
#include "firmware/target/stm32f405_start.hpp"
#include "hal/stm32f405/beam_watch.hpp"
#include "hal/stm32f405/control_board.hpp"
#include "hal/stm32f405/flash.hpp"
#include "hal/stm32f405/flash_size.hpp"
#include "hal/stm32f405/image.hpp"
#include "hal/stm32f405/patient_store.hpp"
#include "hal/stm32f405/start_up.hpp"
#include "hal/stm32f405/time_base.hpp"
#include "hal/stm32f405/watchdog.hpp"

namespace chip = hal::stm32f405;

namespace target {
namespace {

using Bus = chip::MemoryBus;
using Power = chip::PowerPin<kBoard, Bus>;
static_assert(hal::StepPort<Port>);
static_assert(chip::StepTimer<Bus>::kTicksPerSecond == cnc::motion::kTicksPerSecond);
static_assert(chip::StepTimer<Bus>::kTurnTicks == cnc::kTurnTicks);

}  // namespace

namespace {
[[gnu::section(".ccm")]] constinit chip::ByteRings line_rings{};
[[gnu::section(".ccm")]] constinit chip::UsbRings usb_rings{};
}  // namespace

// Start-up sets up these objects before it constructs the application.
constinit Port port{};
constinit SerialLine line{line_rings};
constinit UsbLine usb_line{usb_rings};

namespace {

cnc::LinkChoice cables{usb_line, line};
[[gnu::section(".ccm")]] Can can{cables};
constinit chip::TimeBase<> clock_of_the_loop{};
constinit chip::Flash<> flash{};
cnc::FlashLog log{flash};
constinit chip::PatientStore<cnc::FlashLog> store{log};
constinit chip::ChipBoard<kBoard> board{};
constinit cnc::MemoryWatch image_watch{};
/// Progress of the program, in memory that keeps its content over a restart.
[[gnu::section(".noinit")]] cnc::KeptProgress kept_progress;

}  // namespace

[[gnu::section(".ccm")]] Steps steps{port};

namespace {

[[gnu::section(".ccm")]] constinit cnc::motion::Pixels pixels{};

}  // namespace

Application application{steps, pixels, port, port, store, can.link(), &board, &kept_progress};

namespace {

/// Sets up the peripherals of the chip that the program uses, except USB. Interrupts are still off.
void begin_chip(const chip::Clocks& clocks, const chip::StoreSectors& sectors) {
  const bool faulted = kept.fault.mark == chip::FaultRecord::kValid;
  kept.fault.mark = 0;
  flash.use(sectors);
  port.set_up(clocks);
  line.set_up(clocks);
  Can::set_up(clocks);
  clock_of_the_loop.set_up(clocks);
  chip::watch_supply<Bus>();
  if (faulted && kept.fault.fault == chip::Fault::kImage) port.refuse_motion();
  for (const std::span<const std::byte> part : checked_parts()) image_watch.add(part);
  image_watch.expect(image_header.checksum);
  board.set_report({.clocks = clocks,
                    .cause = chip::take_reset_cause<Bus>(faulted),
                    .fault = kept.fault,
                    .image_bytes = image_header.bytes,
                    .image_checksum = image_watch.expected(),
                    .stack = {stack_bottom, stack_top}});
}

chip::Polarity polarity_of(const cnc::Settings& settings) {
  const auto mask = [&](std::uint16_t number) {
    return static_cast<std::uint8_t>(settings.get(number));
  };
  return {.steps = mask(cnc::setting::kStepInvert),
          .directions = mask(cnc::setting::kDirectionInvert),
          .enables = mask(cnc::setting::kEnableInvert),
          .limits = mask(cnc::setting::kLimitInvert),
          .probe = mask(cnc::setting::kProbeInvert) != 0,
          .controls = mask(cnc::setting::kControlInvert),
          .coolant = mask(cnc::setting::kCoolantInvert),
          .spindle = mask(cnc::setting::kSpindleInvert)};
}

/// Applies changed settings of the pins' polarity. These settings can change only at rest.
void follow_settings(chip::Polarity& followed) {
  const chip::Polarity wanted = polarity_of(application.machine().settings());
  if (wanted == followed) return;
  followed = wanted;
  port.configure(wanted);
}

/// Stops the program if a bit has flipped in the settings or the image. Each cycle checks a piece
/// of both. A change is found within two passes over the memory: 0.2 s for the settings, 2.1 s for
/// the image.
void look_for_damage() {
  constexpr std::size_t kCyclesOfRound = 800;
  const std::size_t piece = image_header.bytes / kCyclesOfRound + 1;
  if (!application.check_memory()) stop(chip::Fault::kConfiguration, 0, 0);
  if (!image_watch.check(piece)) stop(chip::Fault::kImage, 0, 0);
}

[[noreturn]] void leave_for_boot_loader() {
  constexpr std::uint32_t kLastBytesUs = 5000;
  Power::darken();
  const hal::TickCount end = clock_of_the_loop.now().plus(kLastBytesUs);
  while (!clock_of_the_loop.now().reached(end)) {
  }
  kept.wanted = Kept::kBootLoader;
  restart();
}

void follow_senders() {
  switch (can.follow(cables.attend())) {
    case cnc::LinkChoice::Change::kCame:
      return application.begin_sender();
    case cnc::LinkChoice::Change::kWent:
      return application.lose_sender();
    case cnc::LinkChoice::Change::kNone:
      return;
  }
}

/// Runs one cycle. `now` is the time of the boundary of the cycle, so that the result does not
/// depend on the time at which the cycle runs.
void run_turn() {
  const std::uint32_t turn = application.turn();
  line.begin_turn(turn);
  usb_line.begin_turn(turn);
  const hal::TickCount now{turn * cnc::kTurnUs};
  can.attend(application, turn, now);
  follow_senders();
  application.run_turn(now);
}

[[noreturn]] void run() {
  chip::Polarity polarity{};
  port.timer().begin_turns();
  chip::Watchdog<>::begin();
  for (;;) {
    if (!application.take_turn()) {
      // An interrupt that comes just before wfi does not end the wait; the next clock interrupt
      // does.
      asm volatile("wfi");
      continue;
    }
    follow_settings(polarity);
    run_turn();
    look_for_damage();
    // The loop feeds the watchdog only if the step interrupt has run since the last feeding.
    if (port.timer().take_alive()) chip::Watchdog<>::feed();
    if (board.wants_boot_loader() && line.sent() && usb_line.sent()) leave_for_boot_loader();
  }
}

}  // namespace

}  // namespace target

std::uint32_t late_turns = 0;
std::uint32_t turns_behind = 0;

using namespace target;

extern "C" {

/// For a debugger: address of the tick to which the present outputs of the step interrupt belong.
extern const hal::TickCount* const step_tick;
[[gnu::section(".places"), gnu::used]] constinit const hal::TickCount* const step_tick =
    &port.timer().due();

[[noreturn]] void start_up() {
  Power::darken();
  if (kept.wanted == Kept::kBootLoader) enter_boot_loader();
  // In a damaged image, the code that checks the image may be damaged, too. If this code caused a
  // fault at the last start, another attempt would restart the chip forever.
  if (kept.wanted == Kept::kUnfit && kept.fault.mark == chip::FaultRecord::kValid) stand_still();
  kept.wanted = Kept::kUnfit;
  chip::forget_boot_loader<Bus>();
  chip::start_core<Bus>(address_of(image_begin), address_of(stack_guard));
  const chip::Clocks clocks = chip::ClockStart<Bus>::run(kBoard.crystal_hz);
  const chip::Fitness fitness =
      chip::fitness_of(image_is_whole(), address_of(image_end), chip::flash_kib<Bus>());
  begin_memory();
  if (fitness.fault) refuse(clocks, fitness);
  kept.wanted = 0;
  begin_chip(clocks, fitness.store);
  for (const Routine* routine = init_begin; routine != init_end; ++routine) (*routine)();
  // The constructors have repaired the store, which may take seconds of erasing. USB starts only
  // after the repair, because the controller could not answer a host before.
  usb_line.set_up(clocks);
  asm volatile("cpsie i" ::: "memory");
  run();
}

/// Entry after reset. Boot loaders may also jump here, with any stack and any interrupt masks:
/// BASEPRI would block interrupts, and CONTROL.SPSEL would select another stack.
[[gnu::naked, noreturn]] void reset_entry() {
  asm volatile(
      "cpsid i              \n"
      "movs  r0, #0         \n"
      "msr   basepri, r0    \n"
      "msr   faultmask, r0  \n"
      "msr   control, r0    \n"
      "isb                  \n"
      "ldr   r0, =stack_top \n"
      "msr   msp, r0        \n"
      "b     start_up     \n");
}

void step_interrupt();
void line_interrupt() { line.on_interrupt(); }
void usb_interrupt() { usb_line.on_interrupt(); }
void can_interrupt() { Can::on_interrupt(); }
/// Runs at a higher priority than the step interrupt, which it supervises.
void clock_interrupt() {
  clock_of_the_loop.on_interrupt();
  port.timer().make_up();
  if (!application.machine().tool().is_dark_at_rest()) return;
  const std::uint32_t longest_wait = application.steps().longest_wait();
  using Watch = chip::BeamWatch<kBoard, Bus>;
  if (Watch::lit_at_rest(longest_wait) &&
      Watch::brighter_than(application.machine().rest_light().allowed())) {
    stop(chip::Fault::kBeam, 0, chip::StepTimer<Bus>::ticks_left());
  }
}

}  // extern "C"

namespace {

constexpr chip::VectorTable vector_table() {
  chip::VectorTable table{.stack = stack_top, .entries = {}};
  for (Routine& entry : table.entries) entry = fault_entry;
  constexpr std::size_t kReset = 0;
  constexpr std::size_t kTick = 14;
  table.entries[kReset] = reset_entry;
  table.entries[kTick] = clock_interrupt;
  table.interrupt_entry(chip::interrupt::kSupply) = supply_interrupt;
  table.interrupt_entry(chip::interrupt::kTim2) = step_interrupt;
  table.interrupt_entry(SerialLine::kInterrupt) = line_interrupt;
  table.interrupt_entry(UsbLine::kInterrupt) = usb_interrupt;
  if (kBoard.can_transmit.exists()) {
    for (const unsigned number : chip::bxcan::kInterruptNumbers) {
      table.interrupt_entry(number) = can_interrupt;
    }
  }
  return table;
}

[[gnu::section(".vectors"), gnu::used]] constexpr chip::VectorTable kVectors = vector_table();

}  // namespace
