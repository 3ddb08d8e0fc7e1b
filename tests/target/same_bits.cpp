#include "tests/target/same_bits.hpp"

#include <array>
#include <string_view>

#include "firmware/application.hpp"
#include "hal/interface/auxiliary_outputs.hpp"
#include "hal/interface/machine_inputs.hpp"
#include "hal/interface/record_store.hpp"

namespace {

/// Every edge goes into the digest with its tick.
class DigestPort final : public hal::AuxiliaryOutputs, public hal::MachineInputs {
 public:
  void set_direction(hal::AxisMask negative) noexcept { note(0x100U | negative.bits); }
  void raise_steps(hal::AxisMask axes, hal::AxisMask) noexcept {
    ++digest.edges;
    note(0x200U | axes.bits);
  }
  void lower_steps() noexcept {}
  void set_power(std::uint16_t duty) noexcept { note(0x10000U | duty); }
  void change_outputs(std::uint8_t, std::uint8_t) noexcept {}
  void set_analog(std::uint8_t, std::uint16_t) noexcept {}
  void start_timer() noexcept { started = true; }
  [[nodiscard]] bool probe_contact() const noexcept { return false; }
  [[nodiscard]] hal::SwitchMask switches() const noexcept { return {}; }

  void set_spindle(bool, bool) override {}
  void set_coolant(bool, bool) override {}
  void set_digital(std::uint8_t, bool) override {}
  void set_analog_output(std::uint8_t, std::uint16_t) override {}
  void set_motors_enabled(bool) override {}
  [[nodiscard]] hal::InputState read_inputs() override { return {}; }

  Digest digest;
  std::uint32_t now = 0;
  bool started = false;

 private:
  void note(std::uint32_t what) {
    digest.add(now);
    digest.add(what);
  }
};

/// Writes a program line by line from a linear congruential generator: whole
/// numbers only, so that every machine makes the same text.
class ProgramLink final : public hal::ByteStream {
 public:
  static constexpr unsigned kLines = 120;

  [[nodiscard]] std::size_t read(std::span<std::byte> into) override {
    if (awaits_ || (sent_ == size_ && !make_line())) return 0;
    into[0] = static_cast<std::byte>(line_[sent_++]);
    awaits_ = sent_ == size_;
    return 1;
  }

  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override {
    for (const std::byte byte : from) {
      const bool whole = static_cast<char>(byte) == '\n';
      if (whole && !message_) awaits_ = false;
      if (whole) ++answers;
      message_ = whole ? false : (message_ || static_cast<char>(byte) == '[');
    }
    return from.size();
  }

  [[nodiscard]] bool finished() const { return lines_ == kLines && sent_ == size_ && !awaits_; }

  std::uint32_t answers = 0;

 private:
  std::uint32_t random(std::uint32_t below) {
    state_ = state_ * 1664525U + 1013904223U;
    return (state_ >> 8) % below;
  }

  void put(std::string_view text) {
    for (const char c : text) line_[size_++] = c;
  }

  void put_number(char letter, std::int32_t thousandths) {
    line_[size_++] = letter;
    if (thousandths < 0) line_[size_++] = '-';
    auto rest = static_cast<std::uint32_t>(thousandths < 0 ? -thousandths : thousandths);
    std::array<char, 10> digits{};
    std::size_t count = 0;
    for (; count < 4 || rest > 0; rest /= 10) {
      digits[count++] = static_cast<char>('0' + rest % 10);
      if (count == 3) digits[count++] = '.';
    }
    while (count > 0) line_[size_++] = digits[--count];
  }

  std::int32_t place() { return static_cast<std::int32_t>(random(20'000)) - 10'000; }

  bool make_line() {
    constexpr std::array<std::string_view, 10> kOpening{"$32=1\n",
                                                        "$120=900\n",
                                                        "$PC=8:0,30:7.5,100:41.25\n",
                                                        "$854=9\n",
                                                        "$855=130\n",
                                                        "$856=70\n",
                                                        "$857=240\n",
                                                        "G91 G21\n",
                                                        "M4 S700\n",
                                                        "F2400\n"};
    if (lines_ == kLines) return false;
    sent_ = size_ = 0;
    if (lines_ < kOpening.size()) {
      put(kOpening[lines_]);
    } else {
      make_motion();
    }
    ++lines_;
    return true;
  }

  void make_motion() {
    constexpr std::array<std::string_view, 3> kPlanes{"G17", "G18", "G19"};
    constexpr std::array<std::string_view, 3> kCentres{"IJ", "KI", "JK"};
    constexpr std::array<std::string_view, 3> kAxes{"XY", "ZX", "YZ"};
    const std::uint32_t plane = random(3);
    switch (random(6)) {
      case 0:  // Half a circle about the middle of its chord, perhaps a helix.
      case 1: {
        const std::int32_t first = place();
        const std::int32_t second = place();
        put(kPlanes[plane]);
        put(random(2) != 0 ? "G2" : "G3");
        put_number(kAxes[plane][0], 2 * first);
        put_number(kAxes[plane][1], 2 * second);
        put_number(kCentres[plane][0], first);
        put_number(kCentres[plane][1], second);
        if (random(3) == 0) put_number('A', place());
        break;
      }
      case 2:  // A full circle.
        put(kPlanes[plane]);
        put("G3");
        put_number(kAxes[plane][0], 0);
        put_number(kCentres[plane][0], place() + 20'000);
        break;
      case 3:
        put("G4P0.01");
        break;
      case 4:
        put("G0");
        put_number('X', place());
        put_number('Z', place());
        break;
      default:
        put("G1");
        put_number('X', place() / 50);
        put_number('Y', place() / 50);
        put_number('S', static_cast<std::int32_t>(random(1'000'000)));
    }
    put("\n");
  }

  std::array<char, 96> line_{};
  std::size_t size_ = 0;
  std::size_t sent_ = 0;
  unsigned lines_ = 0;
  std::uint32_t state_ = 20261121;
  bool awaits_ = false;
  bool message_ = false;
};

/// Forgets everything: each run is that of a new controller.
class NoStore final : public hal::RecordStore {
 public:
  [[nodiscard]] std::size_t load(std::uint16_t, std::span<std::byte>) override { return 0; }
  [[nodiscard]] bool save(std::uint16_t, std::span<const std::byte>) override { return true; }
};

DigestPort port;
NoStore store;
ProgramLink link_to_program;
cnc::Application<DigestPort> application{port, port, port, store, link_to_program};

}  // namespace

Digest digest_of_a_job() {
  constexpr std::uint32_t kTurn = cnc::motion::kTicksPerSecond / 1000;
  std::uint32_t next = 0;
  std::uint32_t turns = 0;
  bool runs = false;
  while (!link_to_program.finished() || !application.machine().idle() || runs) {
    application.poll(hal::TickCount{1000U * turns++});
    const std::uint32_t end = turns * kTurn;
    if (port.started) next = port.now;
    runs = runs || port.started;
    port.started = false;
    while (runs && static_cast<std::int32_t>(next - end) < 0) {
      port.now = next;
      const std::uint32_t wait = application.on_step_interrupt();
      runs = wait != 0;
      next += wait;
    }
    port.now = end;
  }
  Digest digest = port.digest;
  digest.answers = link_to_program.answers;
  for (const std::int32_t steps : application.steps().position()) {
    digest.add(static_cast<std::uint32_t>(steps));
  }
  return digest;
}
