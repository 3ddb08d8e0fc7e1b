#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sim {

/// Returns a client's frame of a WebSocket (RFC 6455, 5.2) that begins with the byte `first`: FIN,
/// RSV bits and opcode. `mask` contains the bytes that mask the payload.
inline std::string client_frame(std::uint8_t first,
                                std::string_view payload,
                                std::string_view mask = "\x37\xfa\x21\x3d") {
  constexpr std::size_t kShort = 125;
  constexpr std::size_t kTwoBytes = 0xFFFF;
  std::string frame{static_cast<char>(first)};
  const std::size_t bytes = payload.size() <= kShort ? 0 : payload.size() <= kTwoBytes ? 2 : 8;
  const std::size_t code = bytes == 0 ? payload.size() : bytes == 2 ? kShort + 1 : kShort + 2;
  frame += static_cast<char>(0x80U | code);
  for (std::size_t byte = bytes; byte > 0; --byte) {
    frame += static_cast<char>(payload.size() >> (8 * (byte - 1)));
  }
  frame += mask;
  const std::size_t head = frame.size();
  frame += payload;
  for (std::size_t at = 0; at < payload.size(); ++at) {
    frame[head + at] = static_cast<char>(frame[head + at] ^ mask[at % mask.size()]);
  }
  return frame;
}

}  // namespace sim
