// The whole controller on a port of plain stores. It never runs. It is built only for the
// controller, so that cortex_gates.py sees the code of the templates and the size of everything
// that Application owns.
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/application.hpp"

namespace {

volatile std::uint32_t pins;

struct BarePort {
  void set_direction(hal::AxisMask axes) noexcept { pins = axes.bits; }
  void raise_steps(hal::AxisMask axes, hal::AxisMask second) noexcept {
    pins = axes.bits | second.bits;
  }
  void lower_steps() noexcept { pins = 0; }
  void set_power(std::uint16_t power) noexcept { pins = power; }
  void change_outputs(std::uint8_t high, std::uint8_t low) noexcept { pins = high & ~low; }
  void set_analog(std::uint8_t output, std::uint16_t value) noexcept { pins = output + value; }
  void start_timer() noexcept { pins = 1; }
  bool probe_contact() noexcept { return pins != 0; }
  hal::SwitchMask switches() noexcept { return {.first = static_cast<std::uint8_t>(pins)}; }
};

struct BareOutputs final : hal::AuxiliaryOutputs {
  void set_spindle(bool enabled, bool) override { pins = enabled; }
  void set_coolant(bool mist, bool) override { pins = mist; }
  void set_digital(std::uint8_t output, bool) override { pins = output; }
  void set_analog_output(std::uint8_t output, std::uint16_t) override { pins = output; }
  void set_motors_enabled(std::uint8_t axes) override { pins = axes; }
};

struct BareInputs final : hal::MachineInputs {
  hal::InputState read_inputs() override { return {.limits = static_cast<std::uint8_t>(pins)}; }
};

struct BareStore final : hal::RecordStore {
  std::size_t load(std::uint16_t number, std::span<std::byte>) override { return pins & number; }
  bool save(std::uint16_t number, std::span<const std::byte>) override { return pins == number; }
  hal::StoreWear wear() const override { return {}; }
};

struct SilentLine final : hal::ByteStream {
  std::size_t read(std::span<std::byte>) override { return pins; }
  std::size_t write(std::span<const std::byte> from) override { return from.size(); }
};

BarePort port;
BareOutputs outputs;
BareInputs inputs;
BareStore store;
SilentLine line;
cnc::Application<BarePort> application{port, outputs, inputs, store, line};

}  // namespace

std::uint32_t step_interrupt();
std::uint32_t step_interrupt() { return application.on_step_interrupt(); }

void main_loop_turn();
void main_loop_turn() { application.poll(hal::TickCount{pins}); }
