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

/// Sorts received bytes into bytes that act at once and bytes of lines.
///
/// `receive` may run in a link interrupt, all other functions in the main loop. A sender may encode
/// realtime bytes as UTF-8 (`C2 85` for 0x85); both forms act. Other characters of several bytes
/// never act: they go into the line, where only a comment may hold them. Within a comment, from `(`
/// to `)` or from `;` to the end of the line, only a reset acts.
///
/// Where every line is checked (`be_strict`), no byte acts within a line, whether in a comment or
/// not, because any byte may be a damaged one: the byte becomes part of the line, and the check of
/// the line then fails. Between lines a byte acts if it comes twice in a row; `?`, which does no
/// harm, acts alone.
///
/// No byte of a line is ever dropped: without free space `receive` refuses the byte, and the caller
/// must offer it again, so that the link stops reading. A reset, which discards all lines before
/// it, is always taken.
class Receiver {
 public:
  /// The advertised capacity is smaller than the real one, because some senders exceed the
  /// advertised one.
  static constexpr std::uint32_t kRealBytes = 4096;
  static constexpr std::uint32_t kAdvertisedBytes = 1024;

  /// Takes a byte. Returns false if there is no free space: the caller must offer the byte again
  /// later.
  [[nodiscard]] bool receive(char received) {
    const auto byte = static_cast<std::uint8_t>(received);
    return plain_ && is_plain(received) ? store(byte) : receive_other(byte);
  }
  /// Takes bytes from the front as long as there is free space; returns how many.
  [[nodiscard]] std::size_t receive(std::span<const char> received);

  /// Takes all bytes, so that realtime bytes act even if lines wait. From the first byte of a line
  /// that does not fit, lines are lost until the next reset, because no line may follow a gap.
  void receive_all(std::span<const char> received);
  /// Returns true once for each lost line, after all lines before it have been taken.
  [[nodiscard]] bool take_lost_line();

  /// Handles a realtime byte that came apart from the stream, as on CAN: it acts even within a line
  /// or comment. Other bytes are ignored. Main loop.
  void act_at_once(std::uint8_t code);

  /// Returns the number of bytes from the front that are part of a line and have no other effect.
  [[nodiscard]] std::size_t plain_run(std::span<const char> bytes) const {
    if (!plain_) return 0;
    const auto end = std::find_if_not(bytes.begin(), bytes.end(), is_plain);
    return static_cast<std::size_t>(end - bytes.begin());
  }

  /// Returns the number of bytes that can be received now without being refused.
  [[nodiscard]] std::uint32_t room() const;
  /// Returns the free space for status reports: kAdvertisedBytes if no byte waits.
  [[nodiscard]] std::uint32_t advertised_room() const;

  /// Passes bytes of lines to `take` until it returns true. Returns false if the bytes ran out
  /// before.
  template <typename Take>
  [[nodiscard]] bool take_until(Take&& take) {
    if (reset_.load()) return false;
    if (!keeps_back_) return lines_.pop_until(take);
    return has_whole_kept() && lines_.pop_behind(kept_, take);
  }

  /// Keeps back the lines that came before the last kToolAcknowledge, up to their ends. Later lines
  /// are taken first, until release().
  void keep_back();
  /// Returns whether all lines that came before the last cycle start have been taken, except lines
  /// that are kept back.
  [[nodiscard]] bool is_at_start() const {
    return static_cast<std::int32_t>(lines_.taken() + kept_ - started_.load()) >= 0;
  }
  void release();
  /// Takes an LF if it is the next byte. Returns false if it is not.
  [[nodiscard]] bool take_line_feed();
  /// Returns whether lines, or parts of lines, wait.
  [[nodiscard]] bool has_text() const { return lines_.size() != 0; }
  /// Returns whether lines have been lost since the last reset.
  [[nodiscard]] bool has_overrun() const { return overrun_; }

  /// Drops all waiting lines and commands, as a reset by a button does.
  void drop_waiting() {
    keeps_back_ = false;
    kept_ = 0;
    lines_.clear();
    commands_.clear();
    end_overrun();
  }

  /// Sets whether every line is checked, from the next byte on. Not to be called while receive()
  /// may run.
  void be_strict(bool strict);

  /// Restarts for another sender: also forgets a line or character that is incomplete. A pending
  /// reset or report stays pending. Not to be called while receive() may run.
  void begin_anew();

  /// Returns whether no received line, part of a line or realtime byte is waiting.
  [[nodiscard]] bool is_empty() const {
    return !has_text() && commands_.size() == 0 && !reset_.load() && !status_.load() &&
           !full_status_.load() && !late_hold_.load() && lost_lines_.load() == 0;
  }

  // Each returns true once after its realtime byte.
  [[nodiscard]] bool take_reset();  ///< Also drops lines before the reset.
  [[nodiscard]] bool take_status_request() { return status_.exchange(false); }
  [[nodiscard]] bool take_full_status_request() { return full_status_.exchange(false); }
  /// Takes the oldest of the other realtime bytes. Returns false if there is none.
  [[nodiscard]] bool take_command(RealtimeByte& command);

 private:
  enum class Comment : std::uint8_t { kNone, kBrackets, kRestOfLine };

  /// For each byte: whether it is a blank, a line end, or printable and none of ! ? ~ ( ) ;
  static constexpr std::array<bool, 0x100> kPlain = [] {
    std::array<bool, 0x100> plain{};
    using Bytes = std::initializer_list<std::uint8_t>;
    for (const std::uint8_t byte : Bytes{'\t', '\n', '\r'}) plain[byte] = true;
    for (std::uint8_t byte = ' '; byte < '~'; ++byte) plain[byte] = true;
    for (const std::uint8_t byte : Bytes{'!', '?', '(', ')', ';'}) plain[byte] = false;
    return plain;
  }();

  /// Returns whether a byte outside comments is only part of a line, as nearly all bytes are: it
  /// neither acts nor begins a comment or a character of several bytes.
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
  std::atomic<bool> late_hold_{false};  ///< A stop for which `commands_` had no free space.
  /// Positions of the first line and the first command after the last reset.
  std::atomic<std::uint32_t> lines_begin_{0};
  std::atomic<std::uint32_t> commands_begin_{0};
  /// Position of the first line after the last kToolAcknowledge, and after the last cycle start.
  std::atomic<std::uint32_t> acknowledged_{0};
  std::atomic<std::uint32_t> started_{0};
  // Used by the main loop.
  bool keeps_back_ = false;
  std::uint32_t kept_ = 0;     ///< Number of bytes at the front that are kept back.
  std::uint32_t kept_at_ = 0;  ///< Position at which the kept bytes begin.

  std::atomic<std::uint32_t> lost_lines_{0};

  // Used by receive() only.
  bool plain_ = true;  ///< None of the following states holds.
  Comment comment_ = Comment::kNone;
  bool lead_waits_ = false;        ///< C2 was received and is not yet stored.
  std::uint8_t continuation_ = 0;  ///< Bytes of a character that are still to come.
  bool strict_ = false;
  std::uint8_t once_ = 0;  ///< Byte that came once between two lines and acts if it comes again.
  bool overrun_ = false;   ///< Lines are being lost.
  char lost_last_ = 0;     ///< Last byte that was lost.
};

}  // namespace cnc
