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

/// Sorts received bytes into realtime bytes, which act immediately, and bytes of lines.
///
/// `receive` may run in a link interrupt; all other functions run in the main loop. A sender may
/// encode realtime bytes as UTF-8 (`C2 85` for 0x85); both forms act. Other characters of several
/// bytes never act: they go into the line, where only a comment may contain them. Within a comment,
/// from `(` to `)` or from `;` to the end of the line, only a reset acts.
///
/// If every line is checked (`be_strict`), no byte acts within a line or comment, because any byte
/// may be damaged. The byte becomes part of the line, and the check of the line then fails. Between
/// lines, a realtime byte acts only if it arrives twice in a row. A single `?` also acts between
/// lines, because a status report is harmless.
///
/// No byte of a line is ever dropped by `receive`. If there is no free space, `receive` refuses the
/// byte, the caller must offer the byte again, and the link stops reading meanwhile. A reset is
/// always accepted, because it discards all earlier lines.
class Receiver {
 public:
  /// Capacity for lines, bytes. The advertised capacity is smaller than the real one, because some
  /// senders send more than the advertised number of bytes.
  static constexpr std::uint32_t kRealBytes = 4096;
  static constexpr std::uint32_t kAdvertisedBytes = 1024;

  /// Processes a byte. Returns false if there is no free space; the caller must then offer the byte
  /// again later.
  [[nodiscard]] bool receive(char received) {
    const auto byte = static_cast<std::uint8_t>(received);
    return plain_ && is_plain(received) ? store(byte) : receive_other(byte);
  }
  /// Processes bytes from the front of `received` while there is free space. Returns the number of
  /// processed bytes.
  [[nodiscard]] std::size_t receive(std::span<const char> received);

  /// Processes all bytes, so that realtime bytes act even if lines wait. If a byte of a line does
  /// not fit, this line and all later lines until the next reset are lost, because no line may be
  /// executed after a gap.
  void receive_all(std::span<const char> received);
  /// Returns true once for each lost line, after all earlier lines have been taken.
  [[nodiscard]] bool take_lost_line();

  /// Handles a realtime byte that arrived outside the stream, as on CAN. The byte acts even within
  /// a line or comment. Other bytes are ignored. Main loop.
  void act_at_once(std::uint8_t code);

  /// Returns the number of bytes at the front of `bytes` that would only be stored as bytes of a
  /// line.
  [[nodiscard]] std::size_t plain_run(std::span<const char> bytes) const {
    if (!plain_) return 0;
    const auto end = std::find_if_not(bytes.begin(), bytes.end(), is_plain);
    return static_cast<std::size_t>(end - bytes.begin());
  }

  /// Returns the number of bytes that can be received now without refusal.
  [[nodiscard]] std::uint32_t room() const;
  /// Returns the free space that status reports show, in bytes; it is kAdvertisedBytes if no byte
  /// waits.
  [[nodiscard]] std::uint32_t advertised_room() const;

  /// Passes bytes of lines to `take` until `take` returns true. Returns false if the available
  /// bytes end before.
  template <typename Take>
  [[nodiscard]] bool take_until(Take&& take) {
    if (reset_.load()) return false;
    if (!keeps_back_) return lines_.pop_until(take);
    return has_whole_kept() && lines_.pop_behind(kept_, take);
  }

  /// Keeps back the lines whose beginning arrived before the last kToolAcknowledge. Until
  /// release(), only lines that arrived later are taken.
  void keep_back();
  /// Returns whether all lines that arrived before the last cycle start have been taken, except
  /// lines that are kept back.
  [[nodiscard]] bool is_at_start() const {
    return static_cast<std::int32_t>(lines_.taken() + kept_ - started_.load()) >= 0;
  }
  void release();
  /// Takes the next byte if it is LF. Returns false if it is not.
  [[nodiscard]] bool take_line_feed();
  /// Returns whether complete or incomplete lines wait.
  [[nodiscard]] bool has_text() const { return lines_.size() != 0; }
  /// Returns whether lines have been lost since the last reset.
  [[nodiscard]] bool has_overrun() const { return overrun_; }

  /// Drops all waiting lines and commands, as a reset by a button requires.
  void drop_waiting() {
    keeps_back_ = false;
    kept_ = 0;
    lines_.clear();
    commands_.clear();
    end_overrun();
  }

  /// Sets whether every line is checked, from the next byte on. Must not be called while receive()
  /// may run.
  void be_strict(bool strict);

  /// Restarts for a new sender: drops all waiting text, including an incomplete line or character.
  /// A pending reset or status request stays pending. Must not be called while receive() may run.
  void begin_anew();

  /// Returns whether no received line, part of a line or realtime byte is waiting.
  [[nodiscard]] bool is_empty() const {
    return !has_text() && commands_.size() == 0 && !reset_.load() && !status_.load() &&
           !full_status_.load() && !late_hold_.load() && lost_lines_.load() == 0;
  }

  // Each of the following functions returns true once after its realtime byte has arrived.
  [[nodiscard]] bool take_reset();  ///< Also drops all lines that arrived before the reset.
  [[nodiscard]] bool take_status_request() { return status_.exchange(false); }
  [[nodiscard]] bool take_full_status_request() { return full_status_.exchange(false); }
  /// Takes the oldest realtime byte other than resets and requests for reports. Returns false if
  /// there is none.
  [[nodiscard]] bool take_command(RealtimeByte& command);

 private:
  enum class Comment : std::uint8_t { kNone, kBrackets, kRestOfLine };

  /// For each byte: true for a blank, a line end, and a printable character other than ! ? ~ ( ) ;
  static constexpr std::array<bool, 0x100> kPlain = [] {
    std::array<bool, 0x100> plain{};
    using Bytes = std::initializer_list<std::uint8_t>;
    for (const std::uint8_t byte : Bytes{'\t', '\n', '\r'}) plain[byte] = true;
    for (std::uint8_t byte = ' '; byte < '~'; ++byte) plain[byte] = true;
    for (const std::uint8_t byte : Bytes{'!', '?', '(', ')', ';'}) plain[byte] = false;
    return plain;
  }();

  /// Returns whether a byte outside comments only belongs to a line, as nearly all bytes do. Such a
  /// byte does not act and does not begin a comment or a character of several bytes.
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
  std::atomic<bool> late_hold_{false};  ///< A stop arrived while `commands_` had no free space.
  /// Positions in `lines_` and `commands_` at which the first line and the first command after the
  /// last reset begin.
  std::atomic<std::uint32_t> lines_begin_{0};
  std::atomic<std::uint32_t> commands_begin_{0};
  /// Positions up to which lines had arrived at the last kToolAcknowledge and at the last cycle
  /// start.
  std::atomic<std::uint32_t> acknowledged_{0};
  std::atomic<std::uint32_t> started_{0};
  // Used by the main loop only.
  bool keeps_back_ = false;
  std::uint32_t kept_ = 0;     ///< Number of bytes at the front of `lines_` that are kept back.
  std::uint32_t kept_at_ = 0;  ///< Position in `lines_` at which the kept bytes begin.

  std::atomic<std::uint32_t> lost_lines_{0};

  /// No comment, character or pair of bytes is open, and no line is being lost. So a plain byte is
  /// only stored.
  bool plain_ = true;
  Comment comment_ = Comment::kNone;
  /// 0xC2 was received and is not stored yet, because it may begin a realtime byte in UTF-8.
  bool lead_waits_ = false;
  std::uint8_t continuation_ = 0;  ///< Number of bytes of the character that have not arrived.
  bool strict_ = false;
  /// Realtime byte that arrived once between two lines; it acts if it is also the next byte. 0 for
  /// none.
  std::uint8_t once_ = 0;
  bool overrun_ = false;  ///< Lines are lost until the next reset.
  char lost_last_ = 0;    ///< Last byte that was lost.
};

}  // namespace cnc
