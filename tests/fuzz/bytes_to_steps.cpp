/// libFuzzer: random bytes from the link and random actions at the panel, through protocol,
/// machine, planner and step generator.
///
/// The first byte chooses the machine: bit 0 a laser, bit 1 homed with soft limits; bits 2 to 7
/// switch features on (Bench::kFeatures). Some bytes, each with the byte after it, stand for
/// something else: 0xFF for switches, 0xFE for a line or realtime byte of kTokens
/// (tests/fuzz/tokens.hpp), 0xFB for a statement of each kind, 0xFC for a text of any length. 0xFD
/// with two bytes stands for any setting of the firmware's table.
///
/// Whatever arrives, nothing may crash. Every plain line is answered once, and only an
/// acknowledgement looks like one. Motors stay below their rates and inside the soft limits. The
/// beam is off within a millisecond of standstill, except for the light that $870 and $871 allow.
/// Nothing is stored in motion. A reset with an unlock always ends in idle; if a startup line
/// failed and raised an alarm at the first reset, the second one does.

#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "firmware/application.hpp"
#include "firmware/link/realtime_byte.hpp"
#include "firmware/machine/travel.hpp"
#include "hal/host/memory_store.hpp"
#include "hal/host/recording_port.hpp"
#include "tests/fuzz/tokens.hpp"

namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

bool contains_word(std::string line, std::string_view word) {
  for (char& letter : line)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return line.find(word) != std::string::npos;
}

/// A link that passes the fuzzer's bytes to the controller and checks its answers.
class BytesLink final : public hal::ByteStream {
 public:
  explicit BytesLink(hal::InputState& panel) : panel_{panel} {}

  void send(std::span<const std::uint8_t> bytes) {
    bytes_ = bytes;
    read_ = 0;
    token_ = {};
  }

  std::size_t read(std::span<std::byte> into) override {
    if (empty() || into.empty()) return 0;
    if (!token_.empty()) return give(static_cast<std::uint8_t>(token_[0]), into);
    const std::uint8_t byte = bytes_[read_++];
    if (byte == kSwitches) {
      if (read_ < bytes_.size()) set_switches(bytes_[read_++]);
      return 0;  // The panel is slower than the link: the next cycle continues.
    }
    if (byte < kStatement || byte > kToken) return give(byte, into);
    if (read_ < bytes_.size()) take_token(byte, bytes_[read_++]);
    return 0;
  }

  void take_token(std::uint8_t kind, std::uint8_t which) {
    if (kind == kToken) token_ = fuzz::kTokens[which % fuzz::kTokens.size()];
    if (kind == kStatement) token_ = fuzz::statement_token(which);
    if (kind == kLong) token_ = fuzz::long_token(which);
    if (kind != kSetting || read_ == bytes_.size()) return;
    setting_ = fuzz::setting_token(which, bytes_[read_++]);
    token_ = setting_;
  }

  std::size_t give(std::uint8_t byte, std::span<std::byte> into) {
    if (!token_.empty()) token_.remove_prefix(1);
    resets |= byte == 0x18 || byte == 0x19;
    single_block |= byte == 0x89;
    count_line_end(static_cast<char>(byte));
    into[0] = static_cast<std::byte>(byte);
    return 1;
  }

  std::size_t write(std::span<const std::byte> from) override {
    for (const std::byte byte : from) {
      const char character = static_cast<char>(byte);
      if (character == '\n') {
        judge();
        line_.clear();
      } else if (character != '\r') {
        line_ += character;
      }
    }
    return from.size();
  }

  [[nodiscard]] bool empty() const { return read_ == bytes_.size() && token_.empty(); }

  std::size_t lines = 0;
  std::size_t answers = 0;
  bool resets = false;
  bool single_block = false;  ///< Whether single block was switched on at any time.
  bool checks = false;        ///< Whether lines have been numbered or requested again.

 private:
  static constexpr std::uint8_t kSwitches = 0xFF;
  static constexpr std::uint8_t kStatement = 0xFB;
  static constexpr std::uint8_t kLong = 0xFC;
  static constexpr std::uint8_t kSetting = 0xFD;
  static constexpr std::uint8_t kToken = 0xFE;
  static_assert(fuzz::kTokens.size() <= 256);

  void set_switches(std::uint8_t bits) {
    panel_.door = (bits & 1U) != 0;
    panel_.hold = (bits & 2U) != 0;
    panel_.start = (bits & 4U) != 0;
    panel_.reset = (bits & 8U) != 0;
    panel_.emergency_stop = (bits & 16U) != 0;
    resets |= (bits & 24U) != 0;
  }

  /// Counts ends of lines. A realtime byte is removed from the stream, so that CR before it and LF
  /// after it end only one line. Realtime bytes above ASCII may come as UTF-8, with 0xC2 as first
  /// byte.
  void count_line_end(char character) {
    const auto byte = static_cast<std::uint8_t>(character);
    const bool lead_before = std::exchange(after_lead_, false);
    if (after_return_) {
      const bool continues = (byte & 0xC0U) == 0x80;
      after_lead_ = byte == 0xC2 && !lead_before;
      if (continues || after_lead_ || (!lead_before && cnc::is_ascii_realtime(byte))) return;
    }
    const bool pair = character == '\n' && after_return_ && !lead_before;
    after_return_ = character == '\r';
    if ((character == '\n' && !pair) || character == '\r') ++lines;
  }

  void judge() {
    const bool refusal = line_.starts_with("error:");
    const bool numbered = line_.starts_with("ok N");
    checks |= numbered || line_.starts_with("Resend: ");
    if (line_ == "ok" || numbered || refusal) {
      ++answers;
      // A row of $EE, which was requested, may contain the word.
    } else if (!line_.starts_with("[ERRORCODE:")) {
      require(!contains_word(line_, "ok") && !contains_word(line_, "error"),
              "only acknowledgements look like one");
    }
  }

  hal::InputState& panel_;
  std::span<const std::uint8_t> bytes_{};
  std::size_t read_ = 0;
  std::string_view token_{};  ///< Remaining bytes of the present token.
  std::string setting_;       ///< Text of the last token that was composed at run time.
  bool after_return_ = false;
  bool after_lead_ = false;
  std::string line_;
};

/// A store whose flash stops the processor while it writes: nothing may move and no beam may be on
/// then.
class GuardedStore final : public hal::host::MemoryStore {
 public:
  explicit GuardedStore(const bool& moves) : moves_{moves} {}
  [[nodiscard]] bool save(std::uint16_t number, std::span<const std::byte> record) override {
    require(!moves_, "nothing is stored in motion");
    return MemoryStore::save(number, record);
  }

 private:
  const bool& moves_;
};

/// The controller in virtual time, with cycles of a millisecond.
class Bench {
 public:
  explicit Bench(unsigned options) {
    set(cnc::setting::kLaserMode, (options & 1U) != 0 ? 1.0F : 0.0F);
    for (const Feature& feature : kFeatures) {
      if ((options & feature.bit) != 0) set(feature.setting, feature.value);
    }
    if ((options & 2U) != 0) home();
  }

  /// Runs cycles until nothing has happened for a while; the controller reads a few lines in each.
  void run(unsigned turns) {
    for (unsigned turn = 0; turn < turns && turns_at_rest_ < kCalmTurns; ++turn) this->turn();
  }

  void send(std::span<const std::uint8_t> bytes) {
    turns_at_rest_ = 0;
    link_.send(bytes);
  }

  [[nodiscard]] bool calm() const { return turns_at_rest_ >= kCalmTurns; }
  [[nodiscard]] bool rests() const {
    return link_.empty() && application_.machine().idle() && !timer_runs_;
  }

  /// Recovers as an operator does: releases every switch, presses reset, unlocks. A startup line
  /// may raise an alarm again; in an alarm, no startup line runs.
  void recover() {
    link_.send({});
    port_.panel = {};
    for (int turns = 0; turns < kDebounce; ++turns) turn();
    const cnc::Machine& machine = application_.machine();
    press_reset();
    if (machine.needs_reset()) press_reset();
    static constexpr std::uint8_t kUnlock[]{'$', 'X', '\n'};
    link_.send(kUnlock);
    for (int turns = 0; turns < kDebounce; ++turns) turn();
    // Startup lines run after the unlock, and may move axes.
    for (int turns = 0; turns < 20'000 && !rests(); ++turns) turn();
    require(machine.state() == cnc::MachineState::kIdle && rests(),
            "a reset and an unlock end in idle");
    require(port_.power == 0 && !port_.spindle_enabled, "all is off after a reset");
  }

  [[nodiscard]] const BytesLink& link() const { return link_; }
  /// Returns whether the machine pauses in single-block mode, in which further lines wait for the
  /// operator.
  [[nodiscard]] bool pauses() const {
    const cnc::MachineState state = application_.machine().state();
    return link_.single_block &&
           (state == cnc::MachineState::kHold || state == cnc::MachineState::kDoor);
  }

 private:
  struct Feature {
    unsigned bit;
    std::uint16_t setting;
    float value;
  };
  static constexpr std::array<Feature, 18> kFeatures{{
      {4U, cnc::setting::kJerk, 5000.0F},
      {4U, cnc::setting::kJerk + 1, 90000.0F},
      {8U, cnc::setting::kShaper, 1.0F},
      {8U, cnc::setting::kShaper + 1, 4.0F},
      {8U, cnc::setting::kBacklash + 1, 0.1F},
      {8U, cnc::setting::kBacklash + 2, 0.02F},
      {16U, cnc::setting::kParking, 1.0F},
      {16U, cnc::setting::kSpindleRestoreDelay, 0.1F},
      {16U, cnc::setting::kCoolantRestoreDelay, 0.05F},
      {16U, cnc::setting::kHardLimits, 1.0F},
      {32U, cnc::setting::kRestLightDuty, 40.0F},
      {32U, cnc::setting::kRestLightTime, 100.0F},
      {64U, cnc::setting::kBeamOnDelay, 800.0F},
      {64U, cnc::setting::kBeamLag, -1500.0F},
      {64U, cnc::setting::kMinBeamPower, 10.0F},
      {128U, cnc::setting::kKerfControl, 1.0F},
      {128U, cnc::setting::kLinkWatchdog, 0.0F},
      {128U, cnc::setting::kReportedAxes, 6.0F},
  }};
  static constexpr float kTravelMm = 10.0F;
  static constexpr unsigned kCalmTurns = 40;
  static constexpr int kDebounce = 60;  ///< Number of cycles, longer than a switch may bounce.
  static constexpr std::uint64_t kTicks = cnc::motion::kTicksPerSecond / 1000;
  /// Greatest number of steps: a pulse takes at least 1 µs up and 1 µs down, and nine of ten slots
  /// are used.
  static constexpr std::int64_t kMaxStepsPerMillisecond = 451;

  void set(std::uint16_t number, float value) {
    require(application_.machine().change_setting(number, value).ok(), "a setting of the bench");
  }

  void home() {
    for (std::uint16_t axis = 0; axis < 3; ++axis) {
      set(static_cast<std::uint16_t>(cnc::setting::kTravel + axis), kTravelMm);
    }
    set(cnc::setting::kHoming, 1.0F);
    set(cnc::setting::kSoftLimits, 1.0F);
    set(cnc::setting::kHomingSeekRate, 6000.0F);
    set(cnc::setting::kHomingLocateRate, 600.0F);
    set(cnc::setting::kHomingDebounce, 5.0F);
    static constexpr std::uint8_t kHome[]{'$', 'H', '\n'};
    link_.send(kHome);
    run(20'000);
    require(application_.machine().homed() == 7, "the bench homes");
  }

  void press_reset() {
    for (const bool pressed : {true, false}) {
      port_.panel.reset = pressed;
      for (int turns = 0; turns < kDebounce; ++turns) turn();
    }
  }

  void turn() {
    application_.poll(hal::TickCount{static_cast<std::uint32_t>(now_ / 4)});
    advance_millisecond();
    // Hundreds of short lines may wait in the controller, which answers a few in each cycle.
    const bool answered = std::exchange(answers_seen_, link_.answers) != link_.answers;
    turns_at_rest_ = rests() && !answered ? turns_at_rest_ + 1 : 0;
    check();
  }

  void advance_millisecond() {
    if (port_.timer_started) {
      port_.timer_started = false;
      timer_runs_ = true;
      next_ = now_;
    }
    const auto before = port_.position;
    while (timer_runs_ && next_ < now_ + kTicks) {
      const std::uint32_t wait = application_.on_step_interrupt();
      timer_runs_ = wait != 0;
      next_ += wait;
      read_limit_switches();
    }
    if (timer_runs_) last_motion_ = now_ + kTicks;
    now_ += kTicks;
    for (std::size_t motor = 0; motor < before.size(); ++motor) {
      const std::int64_t steps = std::int64_t{port_.position[motor]} - before[motor];
      require(std::llabs(steps) <= kMaxStepsPerMillisecond, "step rate");
    }
  }

  /// Sets the limit switches: at the upper ends, about a millimetre from the position at power-up.
  void read_limit_switches() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto bit = static_cast<std::uint8_t>(1U << axis);
      const bool closed = port_.position[axis] > 300;
      auto& limits = port_.limits.first;
      limits = static_cast<std::uint8_t>(closed ? limits | bit : limits & ~bit);
    }
  }

  void check() {
    const cnc::Machine& machine = application_.machine();
    const cnc::Settings& settings = machine.settings();
    const bool laser = settings.get(cnc::setting::kLaserMode) != 0.0F;
    const bool stands = now_ > last_motion_ + kTicks;
    require(!laser || !stands || port_.power <= light_at_rest(), "the beam is off at standstill");
    require(machine.alarm() != cnc::Alarm::kStarved, "segments come in time");
    const bool limited = settings.get(cnc::setting::kSoftLimits) != 0.0F;
    if (!limited || machine.state() == cnc::MachineState::kHome) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((machine.homed() >> axis & 1U) != 0) check_travel(machine, axis);
    }
  }

  /// Returns the power that the settings allow at rest.
  [[nodiscard]] std::uint16_t light_at_rest() const {
    const cnc::Settings& settings = application_.machine().settings();
    if (settings.get(cnc::setting::kRestLightTime) == 0.0F) return 0;
    return cnc::to_full_scale(0.01F * settings.get(cnc::setting::kRestLightDuty));
  }

  static void check_travel(const cnc::Machine& machine, std::size_t axis) {
    // If a setting changes the ends of the travel, the machine may be outside; then there is no
    // check.
    const cnc::Settings& settings = machine.settings();
    const bool as_homed = settings.get(cnc::setting::kTravel, axis) == kTravelMm &&
                          settings.get(cnc::setting::kHomingDirectionInvert) == 0.0F &&
                          settings.get(cnc::setting::kHoming) == 1.0F;
    if (!as_homed) return;
    const cnc::AxisTravel travel = cnc::travel_of(machine.settings(), axis);
    const float steps_per_mm = settings.get(cnc::setting::kStepsPerMm, axis);
    const cnc::Coordinate step{static_cast<std::int64_t>(1.0e6F / steps_per_mm) + 1};
    const cnc::Coordinate place = machine.motion().tool_place()[axis];
    require(place >= travel.least - step && place <= travel.most + step, "soft limits");
  }

  hal::host::RecordingPort port_{};
  GuardedStore store_{timer_runs_};
  BytesLink link_{port_.panel};
  cnc::Application<hal::host::RecordingPort> application_{port_, port_, port_, store_, link_};
  std::uint64_t now_ = 0;
  std::uint64_t next_ = 0;
  std::uint64_t last_motion_ = 0;
  unsigned turns_at_rest_ = 0;
  std::size_t answers_seen_ = 0;
  bool timer_runs_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  Bench bench{data[0]};
  const std::size_t before = bench.link().lines - bench.link().answers;
  require(before == 0, "the bench begins with all lines answered");
  bench.send({data + 1, size - 1});
  bench.run(600);
  const BytesLink& link = bench.link();
  if (bench.calm() && !link.resets && !link.checks && !bench.pauses()) {
    require(link.answers == link.lines, "one answer for every line");
  }
  bench.recover();
  return 0;
}
