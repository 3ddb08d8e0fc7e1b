#pragma once

#include <poll.h>

#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/web_frame.hpp"

namespace sim {

/// The server's end of a WebSocket. No call blocks.
class WebSocket {
 public:
  using Clock = std::chrono::steady_clock;
  /// Bytes that wait to be sent at most; what does not fit is not taken.
  static constexpr std::size_t kMostUnsent = std::size_t{1} << 20;
  /// A client that takes nothing of what waits for it is gone after this time.
  static constexpr std::chrono::seconds kPatience{30};
  /// For its own end of a WebSocket that was ended here.
  static constexpr std::chrono::seconds kFarewell{2};

  /// @param early what the client sent behind its request
  WebSocket(hal::host::Descriptor socket, std::string_view early);

  /// Copies the payload of messages that have arrived, one after the other; returns how many
  /// bytes.
  [[nodiscard]] std::size_t read(std::span<std::byte> into);
  /// Queues what fits as a message: text where every byte is ASCII, which a browser may read as
  /// such, else binary. Returns how many bytes.
  std::size_t write(std::span<const std::byte> from);
  std::size_t write(std::string_view text) { return write(std::as_bytes(std::span{text})); }
  /// Nothing more in either direction, once what was written has been sent.
  void end(std::uint16_t reason);
  /// The client is there, or something that it sent is unread.
  [[nodiscard]] bool open() const { return !gone_ || !incoming_.empty(); }
  [[nodiscard]] bool gone() const { return gone_; }
  [[nodiscard]] std::size_t unsent() const { return outgoing_.size(); }

  /// Receives and sends what is possible now.
  void attend(Clock::time_point now);
  void add_to(std::vector<pollfd>& descriptors) const;

 private:
  // A client is read no further while so many bytes of it are unread.
  static constexpr std::size_t kIncoming = std::size_t{1} << 16;

  void receive();
  void take(std::string_view bytes);
  void send();

  hal::host::Descriptor socket_;
  WebFrameReader frames_{};
  std::string incoming_;  ///< Payload that was not read.
  std::string outgoing_;  ///< Frames that are not sent.
  Clock::time_point sent_at_ = Clock::now();
  bool ended_ = false;
  bool gone_ = false;
};

}  // namespace sim
