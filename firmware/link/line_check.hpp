#pragma once

#include <cstdint>
#include <string_view>

#include "firmware/link/line_mark.hpp"
#include "hal/interface/tick_count.hpp"

namespace cnc {

/// Tells lines that carry a number and a check from plain ones, and what is to become
/// of each: `N12 G1 X5*86`, the sum of Marlin and RepRap (all bytes before the `*`, exclusive or),
/// or `N12 G1 X5*3FB66097`, a CRC-32 (`Crc32`) as eight upper-case hexadecimal digits.
///
/// A sender that can repeat lines says M110 first: its number counts from then on. From then on a
/// checked line is taken when it has the number that is wanted, and never twice. Until then a good
/// check means nothing, a wrong one is a fault of its line, and numbers are the program's own.
///
/// Under the CRC every line must be checked, in that form: a plain one is a damaged one. Of a gap
/// one line is asked for again, once, however much is on its way behind it. Under the sum lines
/// without a number may come in between, as in Marlin.
/// `M110*` with the CRC and no number ends that, and so does kLapseUs without a good line, because
/// another sender may be at the link by then; the count goes on.
class LineCheck {
 public:
  using Form = LineMark::Form;
  enum class Verdict : std::uint8_t {
    kTake,      ///< `text`, as if it had come plain.
    kBegin,     ///< Nothing but M110: to be acknowledged.
    kMissing,   ///< wanted() is to be asked for.
    kRepeated,  ///< The same; what came has been taken before.
    kDrop,      ///< It was asked for.
    kWrong,     ///< The check behind `text` is wrong, and nobody can repeat the line.
  };
  struct Judgement {
    Verdict verdict = Verdict::kTake;
    std::string_view text{};  ///< Part of the line that was judged.
  };

  static constexpr std::int32_t kLapseUs = 5'000'000;
  /// What comes so long after it was asked for is no answer: the request was lost.
  static constexpr std::int32_t kAskAgainUs = 250'000;

  /// @param long_line the check of a line that has lost bytes; else null
  [[nodiscard]] Judgement judge(std::string_view line,
                                const LongLineCheck* long_line,
                                hal::TickCount now);

  /// Numbered lines must be checked, and come in order.
  [[nodiscard]] bool active() const { return form_ != Form::kNone && !lapsed_; }
  /// Every line must be checked: under the CRC.
  [[nodiscard]] bool strict() const { return active() && form_ == Form::kCrc; }
  [[nodiscard]] Form form() const { return form_; }
  /// The line judged last was taken under this number, in the form of the CRC.
  [[nodiscard]] bool numbered() const { return numbered_; }
  [[nodiscard]] std::uint32_t taken() const { return wanted_ - 1; }
  [[nodiscard]] std::uint32_t wanted() const { return wanted_; }

  /// The machine keeps the next line waiting: this is no silence.
  void keep(hal::TickCount now) { since_ = now; }
  /// Looks whether it has been quiet for too long.
  void attend(hal::TickCount now) { lapsed_ = lapsed_ || now.since(since_) >= kLapseUs; }

 private:
  struct Checked;

  [[nodiscard]] Judgement judge_plain(std::string_view line,
                                      std::string_view text,
                                      hal::TickCount now);
  [[nodiscard]] Judgement take(const Checked& checked, hal::TickCount now);
  [[nodiscard]] Verdict ask(std::uint32_t number, hal::TickCount now);

  std::uint32_t wanted_ = 1;
  std::uint32_t dropped_ = 0;  ///< The number of the last line that was, since it was asked.
  hal::TickCount since_{};     ///< A line was taken or asked for.
  Form form_ = Form::kNone;
  Verdict said_ = Verdict::kTake;  ///< Since the last line that was taken.
  bool lapsed_ = false;
  bool numbered_ = false;
};

}  // namespace cnc
