#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "firmware/link/realtime_byte.hpp"
#include "hal/interface/spsc_ring.hpp"

namespace cnc {

/// Sorts what a link receives: bytes that act at once, and bytes of lines.
///
/// `receive` may run in a link interrupt, everything else in the main loop.
/// A sender may encode realtime bytes as UTF-8 (`C2 85` for 0x85); both forms
/// act. Other characters of several bytes never do: they go into the line,
/// where only a comment may hold them. Within a comment, from `(` to `)` or
/// from `;` to the end of the line, nothing acts but a reset.
///
/// Where every line is checked (`be_strict`), nothing acts within a line, comment or not, because
/// any byte may be a damaged one: it is part of the line, and spoils it. Between lines a byte
/// acts when it comes twice in a row; but for `?`, which does no harm.
///
/// No byte of a line is ever dropped: when there is no room, `receive` does not
/// take the byte and wants to be offered it again, so that the link stops
/// reading. A reset, which forgets all lines before it, is always taken.
class Receiver {
 public:
  /// Senders are told less than there is: some overrun what they are told.
  static constexpr std::uint32_t kRealBytes = 4096;
  static constexpr std::uint32_t kAdvertisedBytes = 1024;

  /// False: no room; offer the same byte again later.
  [[nodiscard]] bool receive(char received) {
    const auto byte = static_cast<std::uint8_t>(received);
    return plain_ && is_plain(received) ? store(byte) : receive_other(byte);
  }
  /// From the front, as many as there is room for; returns how many.
  [[nodiscard]] std::size_t receive(std::span<const char> received);

  /// All of them, so that realtime bytes act whatever waits: from the first byte of a line on that
  /// finds no room, lines are lost until the next reset, because none may follow a gap.
  void receive_all(std::span<const char> received);
  /// True once for each line that was lost, after all before it have been taken.
  [[nodiscard]] bool take_lost_line();

  /// A realtime byte that came apart from the stream, as on CAN: it acts whatever the text is in
  /// the middle of. Bytes that never act are passed over. Main loop.
  void act_at_once(std::uint8_t code);

  /// How many bytes from the front are nothing but part of a line, here and now.
  [[nodiscard]] std::size_t plain_run(std::span<const char> bytes) const {
    if (!plain_) return 0;
    const auto end = std::find_if_not(bytes.begin(), bytes.end(), is_plain);
    return static_cast<std::size_t>(end - bytes.begin());
  }

  /// Bytes that can be received now without being refused.
  [[nodiscard]] std::uint32_t room() const;
  /// What a status report tells: kAdvertisedBytes when nothing waits.
  [[nodiscard]] std::uint32_t advertised_room() const;

  /// Gives the bytes of lines to `take` until it says true; false when there were too few.
  template <typename Take>
  [[nodiscard]] bool take_until(Take&& take) {
    if (reset_.load()) return false;
    if (!keeps_back_) return lines_.pop_until(take);
    return has_whole_kept() && lines_.pop_behind(kept_, take);
  }

  /// Keeps back the lines, to their ends, that came before the last kToolAcknowledge: lines that
  /// came after it are taken first, until release().
  void keep_back();
  /// Returns whether all that came before the last cycle start is taken, but for lines that are
  /// kept back.
  [[nodiscard]] bool is_at_start() const {
    return static_cast<std::int32_t>(lines_.taken() + kept_ - started_.load()) >= 0;
  }
  void release();
  /// Takes an LF where the next line begins; false where there is none.
  [[nodiscard]] bool take_line_feed();
  /// Lines, or parts of them, wait.
  [[nodiscard]] bool has_text() const { return lines_.size() != 0; }
  /// Lines have been lost since the last reset.
  [[nodiscard]] bool has_overrun() const { return overrun_; }

  /// Forgets what waits, as a reset by a button does.
  void drop_waiting() {
    keeps_back_ = false;
    kept_ = 0;
    lines_.clear();
    commands_.clear();
    end_overrun();
  }

  /// From the next byte on. Not while receive() may run.
  void be_strict(bool strict);

  /// Forgets also what it was in the middle of: another sender begins. Whether a reset
  /// or a report is due stays. Not while receive() may run.
  void begin_anew();

  /// Returns whether nothing that was received waits: no line or part of one, and no byte that
  /// acts.
  [[nodiscard]] bool is_empty() const {
    return !has_text() && commands_.size() == 0 && !reset_.load() && !status_.load() &&
           !full_status_.load() && !late_hold_.load() && lost_lines_.load() == 0;
  }

  // True once after each.
  [[nodiscard]] bool take_reset();  ///< Also forgets the lines before the reset.
  [[nodiscard]] bool take_status_request() { return status_.exchange(false); }
  [[nodiscard]] bool take_full_status_request() { return full_status_.exchange(false); }
  /// The other realtime bytes, in the order in which they came.
  [[nodiscard]] bool take_command(RealtimeByte& command);

 private:
  enum class Comment : std::uint8_t { kNone, kBrackets, kRestOfLine };

  /// By byte: a blank, a line end, or anything printable but ! ? ~ ( ) ;
  static constexpr std::array<bool, 0x100> kPlain = [] {
    std::array<bool, 0x100> plain{};
    using Bytes = std::initializer_list<std::uint8_t>;
    for (const std::uint8_t byte : Bytes{'\t', '\n', '\r'}) plain[byte] = true;
    for (std::uint8_t byte = ' '; byte < '~'; ++byte) plain[byte] = true;
    for (const std::uint8_t byte : Bytes{'!', '?', '(', ')', ';'}) plain[byte] = false;
    return plain;
  }();

  /// Nothing but part of a line outside comments, as nearly all bytes are: it neither
  /// acts nor begins a comment or a character of several bytes.
  [[nodiscard]] static constexpr bool is_plain(char byte) {
    return kPlain[static_cast<std::uint8_t>(byte)];
  }
  [[nodiscard]] bool receive_other(std::uint8_t byte);
  [[nodiscard]] bool receive_strict(std::uint8_t byte);
  [[nodiscard]] bool receive_low(std::uint8_t byte);
  [[nodiscard]] bool receive_high(std::uint8_t byte);
  [[nodiscard]] bool store(std::uint8_t byte) {
    return !overrun_ && lines_.try_push(static_cast<char>(byte));
  }
  void lose(char byte);
  void end_overrun() {
    overrun_ = false;
    lost_lines_.store(0);
  }
  void judge_plain();
  void follow_comment(char byte);
  [[nodiscard]] bool has_whole_kept();
  void act(std::uint8_t code);
  void end_text();
  void reset();

  hal::SpscRing<char, kRealBytes> lines_{};
  hal::SpscRing<RealtimeByte, 64> commands_{};
  std::atomic<bool> reset_{false};
  std::atomic<bool> status_{false};
  std::atomic<bool> full_status_{false};
  std::atomic<bool> late_hold_{false};  ///< A stop that `commands_` had no room for.
  /// Where the lines, and the commands, after the last reset begin.
  std::atomic<std::uint32_t> lines_begin_{0};
  std::atomic<std::uint32_t> commands_begin_{0};
  /// Where the lines begin that came after the last byte of its kind.
  std::atomic<std::uint32_t> acknowledged_{0};
  std::atomic<std::uint32_t> started_{0};
  // The main loop's.
  bool keeps_back_ = false;
  std::uint32_t kept_ = 0;     ///< Bytes in front that are kept back.
  std::uint32_t kept_at_ = 0;  ///< Where they began: as long as they do, nothing behind is taken.

  std::atomic<std::uint32_t> lost_lines_{0};

  // The rest belongs to receive().
  bool plain_ = true;  ///< Nothing of what follows.
  Comment comment_ = Comment::kNone;
  bool lead_waits_ = false;        ///< C2 was received, and not yet stored.
  std::uint8_t continuation_ = 0;  ///< Bytes still to come of a character.
  bool strict_ = false;
  std::uint8_t once_ = 0;  ///< Came between two lines, and waits for its like.
  bool overrun_ = false;   ///< Lines are lost.
  char lost_last_ = 0;     ///< The last byte that was.
};

}  // namespace cnc
