#pragma once

#include <cstdint>
#include <string_view>

#include "firmware/link/line_mark.hpp"
#include "hal/interface/tick_count.hpp"

namespace cnc {

/// Distinguishes lines that carry a number and a check from plain lines, and decides how to treat
/// each. There are two forms: `N12 G1 X5*86` has the sum of Marlin and RepRap (exclusive or of all
/// bytes before the `*`). `N12 G1 X5*3FB66097` has a CRC-32 (`Crc32`) as eight upper-case
/// hexadecimal digits.
///
/// A sender that can repeat lines first sends M110, whose number starts the count. From then on a
/// checked line is taken if it has the wanted number, and never twice. Before M110 a correct check
/// has no effect, a wrong check makes the line an error, and line numbers are the program's own.
///
/// Under the CRC every line must have a number and a CRC; a plain line counts as damaged. After a
/// gap, one line is requested once, however many lines are already on their way after it. Under the
/// sum, lines without a number may come in between, as in Marlin. `M110*` with the CRC and no
/// number ends the checking. So does kLapseUs without a good line, because another sender may be at
/// the link by then; the count continues.
class LineCheck {
 public:
  using Form = LineMark::Form;
  enum class Verdict : std::uint8_t {
    kTake,      ///< Take `text` as a plain line.
    kBegin,     ///< Acknowledge the line; it holds only M110.
    kMissing,   ///< Request the line wanted().
    kRepeated,  ///< Request wanted(); the line had been taken before.
    kDrop,      ///< Ignore it; a line is requested already.
    kWrong,     ///< The check after `text` is wrong, and the sender cannot repeat the line.
  };
  struct Judgement {
    Verdict verdict = Verdict::kTake;
    std::string_view text{};  ///< Part of the line that was judged.
  };

  static constexpr std::int32_t kLapseUs = 5'000'000;
  /// Time after which a request for a line is taken as lost: a line that comes later is no answer
  /// to it.
  static constexpr std::int32_t kAskAgainUs = 250'000;

  /// Judges a line.
  /// @param long_line the check of a line that has lost bytes; null for other lines
  [[nodiscard]] Judgement judge(std::string_view line,
                                const LongLineCheck* long_line,
                                hal::TickCount now);

  /// Returns whether numbered lines must be checked and come in order.
  [[nodiscard]] bool active() const { return form_ != Form::kNone && !lapsed_; }
  /// Returns whether every line must be checked, as under the CRC.
  [[nodiscard]] bool strict() const { return active() && form_ == Form::kCrc; }
  [[nodiscard]] Form form() const { return form_; }
  /// Returns whether the last judged line was taken by its number, in the form of the CRC.
  [[nodiscard]] bool numbered() const { return numbered_; }
  [[nodiscard]] std::uint32_t taken() const { return wanted_ - 1; }
  [[nodiscard]] std::uint32_t wanted() const { return wanted_; }

  /// Restarts the time of silence, because the machine is keeping the next line waiting.
  void keep(hal::TickCount now) { since_ = now; }
  /// Checks whether no good line has come for too long.
  void attend(hal::TickCount now) { lapsed_ = lapsed_ || now.since(since_) >= kLapseUs; }

 private:
  struct Checked;

  [[nodiscard]] Judgement judge_plain(std::string_view line,
                                      std::string_view text,
                                      hal::TickCount now);
  [[nodiscard]] Judgement take(const Checked& checked, hal::TickCount now);
  [[nodiscard]] Verdict ask(std::uint32_t number, hal::TickCount now);

  std::uint32_t wanted_ = 1;
  std::uint32_t dropped_ = 0;  ///< Greatest number dropped since the request.
  hal::TickCount since_{};     ///< Time at which a line was last taken or requested.
  Form form_ = Form::kNone;
  Verdict said_ = Verdict::kTake;  ///< Last verdict since a line was taken.
  bool lapsed_ = false;
  bool numbered_ = false;
};

}  // namespace cnc
