#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "hal/interface/byte_stream.hpp"

namespace target {

/// Answers senders on one link while the image must not run: sends the banner, then the reason and
/// an error for every line. Needs no clock, no store and no other part of the firmware. Main loop
/// context.
class RefusalTalk {
 public:
  /// @param reason text `[MSG:…]` with its line end; `reason` and `stream` outlive this object
  RefusalTalk(hal::ByteStream& stream, std::string_view reason)
      : stream_{stream}, reason_{reason} {}

  /// Begins with the banner and the reason, because senders expect them on connection. Drops unsent
  /// answers to an earlier sender.
  void greet() {
    owed_.fill(0);
    rest_ = {};
    length_ = 0;
    owe(kGreeting);
    owe(kReason);
  }

  /// Processes the bytes that have arrived and sends as many answers as fit. Never waits.
  /// @return whether the line `$DFU` has arrived, with which a user enters the boot loader
  [[nodiscard]] bool attend() {
    std::array<std::byte, 32> bytes{};
    bool wants_loader = false;
    const std::size_t count = stream_.read(bytes);
    for (const std::byte byte : std::span{bytes}.first(count)) {
      if (take(static_cast<char>(byte))) wants_loader = true;
    }
    send();
    return wants_loader;
  }

  /// Returns whether the link has taken all answers.
  [[nodiscard]] bool idle() const { return rest_.empty() && next_owed() == kParts; }

 private:
  /// Answers, in the order in which they are sent.
  enum Part : std::size_t { kGreeting, kStatus, kReason, kError, kOk, kParts };
  static constexpr std::string_view kLeave = "$DFU";

  /// Processes a byte.
  /// @return whether the byte ends the line `$DFU`
  bool take(char byte) {
    constexpr char kReset = 0x18;
    if (byte == '?') {
      owe(kStatus);
    } else if (byte == kReset) {
      greet();
    } else if (byte == '\n' || byte == '\r') {
      return end_line();
    } else {
      if (length_ < line_.size()) line_[length_] = byte;
      ++length_;
    }
    return false;
  }

  /// Ends a line. Returns whether the line is `$DFU`. An empty line gets no answer, because it is
  /// the second half of a CR LF.
  bool end_line() {
    if (length_ == 0) return false;
    const bool leaves = std::string_view{line_.data(), std::min(length_, line_.size())} == kLeave &&
                        length_ == kLeave.size();
    length_ = 0;
    if (leaves) {
      owe(kOk);
      return true;
    }
    if (owed_[kReason] == 0) owe(kReason);
    owe(kError);
    return false;
  }

  void owe(Part part) { ++owed_[part]; }

  [[nodiscard]] std::size_t next_owed() const {
    std::size_t part = 0;
    while (part < kParts && owed_[part] == 0) ++part;
    return part;
  }

  void send() {
    while (true) {
      if (rest_.empty()) {
        const std::size_t part = next_owed();
        if (part == kParts) return;
        --owed_[part];
        rest_ = text_of(part);
      }
      const std::size_t sent = stream_.write(std::as_bytes(std::span{rest_}));
      rest_.remove_prefix(sent);
      if (sent == 0) return;
    }
  }

  [[nodiscard]] std::string_view text_of(std::size_t part) const {
    switch (part) {
      case kGreeting:
        return "\r\nGrbl 1.1h ['$' for help]\r\n";
      case kStatus:
        return "<Alarm|MPos:0.000,0.000,0.000|FS:0,0>\r\n";
      case kReason:
        return reason_;
      case kError:
        return "error:9\r\n";  // Error 9 is "G-code is locked out".
      default:
        return "ok\r\n";
    }
  }

  hal::ByteStream& stream_;
  std::string_view reason_;
  std::string_view rest_{};  ///< Unsent rest of the present answer.
  /// Number of times that each answer must still be sent.
  std::array<std::uint32_t, kParts> owed_{};
  std::array<char, kLeave.size() + 1> line_{};  ///< Beginning of the line that is arriving.
  std::size_t length_ = 0;                      ///< Number of bytes of the arriving line so far.
};

}  // namespace target
