#pragma once

#include <cstdint>
#include <string_view>

#include "firmware/link/line_mark.hpp"
#include "hal/interface/tick_count.hpp"

namespace cnc {

/// Distinguishes checked lines, which have a number and a check, from plain lines, and decides the
/// treatment of each line. A check has one of two forms. `N12 G1 X5*86` has the sum of Marlin and
/// RepRap: the exclusive or of all bytes before the `*`. `N12 G1 X5*3FB66097` has a CRC-32
/// (`Crc32`) as eight upper-case hexadecimal digits.
///
/// A sender that can repeat lines first sends M110, whose number starts the count. From then on a
/// checked line is taken only if it has the wanted number, and never twice. Before M110, line
/// numbers belong to the G-code program and are not checked. A correct check then has no effect,
/// and a wrong check makes the line an error.
///
/// With the CRC every line must have a number and a CRC; a plain line counts as damaged. After a
/// gap in the numbers, one line is requested once, even if many later lines are already on their
/// way. With the sum, lines without a number may come in between, as in Marlin. `M110*` with the
/// CRC and without a number ends the checking. Checking also pauses after kLapseUs without a good
/// line, because another sender may use the link by then. The count of lines is kept.
class LineCheck {
 public:
  using Form = LineMark::Form;
  enum class Verdict : std::uint8_t {
    kTake,      ///< Execute `text` as a plain line.
    kBegin,     ///< Acknowledge the line; it contains only M110.
    kMissing,   ///< Request the line with the number wanted().
    kRepeated,  ///< Request the line wanted(); the received line was taken earlier.
    kDrop,      ///< Ignore the line; the wanted line is already requested.
    /// Report an error: the check after `text` is wrong, and the sender cannot repeat the line.
    kWrong,
  };
  struct Judgement {
    Verdict verdict = Verdict::kTake;
    std::string_view text{};  ///< Part of the line to execute or to report.
  };

  static constexpr std::int32_t kLapseUs = 5'000'000;
  /// Time after which a request counts as lost, microseconds. After this time, the next line that
  /// is not the wanted line causes another request.
  static constexpr std::int32_t kAskAgainUs = 250'000;

  /// Decides the treatment of a line.
  /// @param long_line check of a line from which bytes were dropped; null for a complete line
  [[nodiscard]] Judgement judge(std::string_view line,
                                const LongLineCheck* long_line,
                                hal::TickCount now);

  /// Returns whether numbered lines must have a correct check and must arrive in order.
  [[nodiscard]] bool active() const { return form_ != Form::kNone && !lapsed_; }
  /// Returns whether every line must have a correct check, as with the CRC.
  [[nodiscard]] bool strict() const { return active() && form_ == Form::kCrc; }
  [[nodiscard]] Form form() const { return form_; }
  /// Returns whether the last line had a number and a CRC and was taken, so that its answer must
  /// have both, too.
  [[nodiscard]] bool numbered() const { return numbered_; }
  [[nodiscard]] std::uint32_t taken() const { return wanted_ - 1; }
  [[nodiscard]] std::uint32_t wanted() const { return wanted_; }

  /// Restarts the count of kLapseUs, because the sender must wait for the machine.
  void keep(hal::TickCount now) { since_ = now; }
  /// Pauses the checking if no good line has arrived for kLapseUs.
  void attend(hal::TickCount now) { lapsed_ = lapsed_ || now.since(since_) >= kLapseUs; }

 private:
  struct Checked;

  [[nodiscard]] Judgement judge_plain(std::string_view line,
                                      std::string_view text,
                                      hal::TickCount now);
  [[nodiscard]] Judgement take(const Checked& checked, hal::TickCount now);
  [[nodiscard]] Verdict ask(std::uint32_t number, hal::TickCount now);

  std::uint32_t wanted_ = 1;
  std::uint32_t dropped_ = 0;  ///< Largest number of a line that was dropped since the request.
  /// Time at which a line was last taken or requested, or of the last keep().
  hal::TickCount since_{};
  Form form_ = Form::kNone;
  /// Last verdict that requested a line; kTake if a line was taken since.
  Verdict said_ = Verdict::kTake;
  bool lapsed_ = false;
  bool numbered_ = false;
};

}  // namespace cnc
