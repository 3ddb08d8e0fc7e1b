#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sim {

/// The frames of a WebSocket (RFC 6455, 5.2).
namespace web_opcode {
inline constexpr std::uint8_t kContinuation = 0;
inline constexpr std::uint8_t kText = 1;
inline constexpr std::uint8_t kBinary = 2;
inline constexpr std::uint8_t kClose = 8;
inline constexpr std::uint8_t kPing = 9;
inline constexpr std::uint8_t kPong = 10;
}  // namespace web_opcode

/// Why a WebSocket is closed (RFC 6455, 7.4.1).
namespace web_close {
inline constexpr std::uint16_t kNormal = 1000;
inline constexpr std::uint16_t kProtocolFault = 1002;
inline constexpr std::uint16_t kTooLarge = 1009;
inline constexpr std::uint16_t kTryAgainLater = 1013;
}  // namespace web_close

/// A final frame of a server, which has no mask.
[[nodiscard]] std::string web_frame(std::uint8_t opcode, std::string_view payload);
/// A close frame with its reason.
[[nodiscard]] std::string web_close_frame(std::uint16_t reason);

/// Takes apart what a client sends, as it comes. A frame without a mask, with reserved bits or
/// opcodes, or out of order is a fault, after which nothing more is read.
class WebFrameReader {
 public:
  static constexpr std::uint64_t kMostPayload = std::uint64_t{64} << 20;

  /// Of text and binary messages the payload is appended to `data`, whole or not; a ping is
  /// answered in `answers`.
  void take(std::string_view bytes, std::string& data, std::string& answers);

  /// The client closes, or has done what it must not.
  [[nodiscard]] bool closed() const { return closed_; }
  /// One of web_close; kNormal for a client that closes. @pre closed()
  [[nodiscard]] std::uint16_t reason() const { return reason_; }

 private:
  [[nodiscard]] bool read_head();
  [[nodiscard]] bool head_is_sound(std::uint8_t first, std::uint8_t second);
  void read_payload(std::string_view& bytes, std::string& data);
  void end_frame(std::string& answers);
  void close(std::uint16_t reason);
  [[nodiscard]] bool is_control() const { return opcode_ >= web_opcode::kClose; }

  std::string head_;     ///< Bytes of a head that is not complete.
  std::string control_;  ///< Payload of a control frame.
  std::uint64_t left_ = 0;
  std::uint64_t at_ = 0;  ///< In the payload.
  std::uint32_t mask_ = 0;
  std::uint16_t reason_ = web_close::kNormal;
  std::uint8_t opcode_ = 0;
  bool in_payload_ = false;
  bool final_ = true;
  bool in_message_ = false;  ///< Its last frame is still to come.
  bool closed_ = false;
};

}  // namespace sim
