#include "tests/target/same_bits.hpp"

#include <array>
#include <string_view>

#include "firmware/application.hpp"
#include "hal/interface/record_store.hpp"
#include "tests/target/line_text.hpp"
#include "tests/target/quiet_machine.hpp"

namespace {

/// A step port that adds every edge with its tick to the digest.
class DigestPort final : public QuietMachine {
 public:
  void set_direction(hal::AxisMask negative) noexcept { note(0x100U | negative.bits); }
  void raise_steps(hal::AxisMask axes, hal::AxisMask) noexcept {
    ++digest.edges;
    note(0x200U | axes.bits);
  }
  void lower_steps() noexcept {}
  void set_power(std::uint16_t duty) noexcept { note(0x10000U | duty); }

  Digest digest;
  std::uint32_t now = 0;

 private:
  void note(std::uint32_t what) {
    digest.add(now);
    digest.add(what);
  }
};

/// Writes a program line by line from a linear congruential generator, with whole numbers only, so
/// that the text is the same on every machine.
class ProgramLink final : public hal::ByteStream {
 public:
  static constexpr unsigned kLines = 200;

  [[nodiscard]] std::size_t read(std::span<std::byte> into) override {
    if (awaits_ || (sent_ == line_.text().size() && !make_line())) return 0;
    into[0] = static_cast<std::byte>(line_.text()[sent_++]);
    awaits_ = sent_ == line_.text().size();
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

  [[nodiscard]] bool finished() const {
    return lines_ == kLines && sent_ == line_.text().size() && !awaits_;
  }

  std::uint32_t answers = 0;

 private:
  std::uint32_t random(std::uint32_t below) {
    state_ = state_ * 1664525U + 1013904223U;
    return (state_ >> 8) % below;
  }

  std::int32_t place() { return static_cast<std::int32_t>(random(20'000)) - 10'000; }

  bool make_line() {
    constexpr std::array<std::string_view, 11> kOpening{"$32=1\n",
                                                        "$858=0\n",
                                                        "$120=900\n",
                                                        "$PC=8:0,30:7.5,100:41.25\n",
                                                        "$854=9\n",
                                                        "$855=130\n",
                                                        "$856=70\n",
                                                        "$857=240\n",
                                                        "G91 G21\n",
                                                        "M4 S700\n",
                                                        "F2400\n"};
    // Index from which on shapers and backlash are set; the pause before brings the machine to
    // rest.
    constexpr unsigned kShaped = 120;
    constexpr std::array<std::string_view, 9> kMotors{"G4P0.01\n",
                                                      "$810=3\n",
                                                      "$820=47\n",
                                                      "$811=4\n",
                                                      "$821=61.5\n",
                                                      "$831=0.07\n",
                                                      "$160=0.03\n",
                                                      "$162=0.02\n",
                                                      "$813=1\n"};
    if (lines_ == kLines) return false;
    line_.clear();
    sent_ = 0;
    if (lines_ < kOpening.size()) {
      line_.put(kOpening[lines_]);
    } else if (lines_ >= kShaped && lines_ < kShaped + kMotors.size()) {
      line_.put(kMotors[lines_ - kShaped]);
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
      case 0:  // Half a circle about the middle of its chord, in some cases a helix.
      case 1: {
        const std::int32_t first = place();
        const std::int32_t second = place();
        line_.put(kPlanes[plane]);
        line_.put(random(2) != 0 ? "G2" : "G3");
        line_.put_number(kAxes[plane][0], 2 * first);
        line_.put_number(kAxes[plane][1], 2 * second);
        line_.put_number(kCentres[plane][0], first);
        line_.put_number(kCentres[plane][1], second);
        if (random(3) == 0) line_.put_number('A', place());
        break;
      }
      case 2:  // A full circle.
        line_.put(kPlanes[plane]);
        line_.put("G3");
        line_.put_number(kAxes[plane][0], 0);
        line_.put_number(kCentres[plane][0], place() + 20'000);
        break;
      case 3:
        line_.put("G4P0.01");
        break;
      case 4:
        line_.put("G0");
        line_.put_number('X', place());
        line_.put_number('Z', place());
        break;
      default:
        line_.put("G1");
        line_.put_number('X', place() / 50);
        line_.put_number('Y', place() / 50);
        line_.put_number('S', static_cast<std::int32_t>(random(1'000'000)));
    }
    line_.put("\n");
  }

  LineText line_{};
  std::size_t sent_ = 0;
  unsigned lines_ = 0;
  std::uint32_t state_ = 20261121;
  bool awaits_ = false;
  bool message_ = false;
};

/// A store that forgets everything, so that each run is that of a new controller.
class NoStore final : public hal::RecordStore {
 public:
  [[nodiscard]] std::size_t load(std::uint16_t, std::span<std::byte>) override { return 0; }
  [[nodiscard]] bool save(std::uint16_t, std::span<const std::byte>) override { return true; }
  hal::StoreWear wear() const override { return {}; }
};

DigestPort port;
NoStore store;
ProgramLink link_to_program;
// The step generator has a separate memory, as on the boards.
[[gnu::section(".ccm")]] cnc::Controller<DigestPort>::Steps steps{port};
[[gnu::section(".ccm")]] constinit cnc::motion::Pixels pixels{};
cnc::Controller<DigestPort> application{steps, pixels, port, port, store, link_to_program};

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
