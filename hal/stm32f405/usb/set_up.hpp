#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hal::stm32f405::usb {

inline constexpr std::size_t kSetUpBytes = 8;

/// A request from the host to endpoint 0 (USB 2.0, 9.3).
struct SetUp {
  std::uint8_t type = 0;
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;
  std::uint16_t length = 0;  ///< Length in bytes of the data that follow.

  [[nodiscard]] constexpr bool to_host() const { return (type & 0x80U) != 0; }
};

constexpr SetUp set_up_of(const std::array<std::byte, kSetUpBytes>& bytes) {
  const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); };
  const auto half = [&](std::size_t at) {
    return static_cast<std::uint16_t>(byte(at) | byte(at + 1) << 8);
  };
  return {byte(0), byte(1), half(2), half(4), half(6)};
}

/// Returns a request's type (upper byte) and code as one number.
constexpr std::uint16_t request_of(std::uint8_t type, std::uint8_t request) {
  return static_cast<std::uint16_t>(type << 8 | request);
}
constexpr std::uint16_t request_of(const SetUp& set_up) {
  return request_of(set_up.type, set_up.request);
}

namespace request {  // Standard and class requests: USB 2.0, table 9-3; PSTN120, table 13.
inline constexpr std::uint16_t kDeviceStatus = request_of(0x80, 0);
inline constexpr std::uint16_t kInterfaceStatus = request_of(0x81, 0);
inline constexpr std::uint16_t kEndpointStatus = request_of(0x82, 0);
inline constexpr std::uint16_t kClearEndpoint = request_of(0x02, 1);
inline constexpr std::uint16_t kSetEndpoint = request_of(0x02, 3);
inline constexpr std::uint16_t kSetAddress = request_of(0x00, 5);
inline constexpr std::uint16_t kDescriptor = request_of(0x80, 6);
inline constexpr std::uint16_t kConfigurationInUse = request_of(0x80, 8);
inline constexpr std::uint16_t kConfigure = request_of(0x00, 9);
inline constexpr std::uint16_t kAlternateInUse = request_of(0x81, 10);
inline constexpr std::uint16_t kSetLineCoding = request_of(0x21, 0x20);
inline constexpr std::uint16_t kLineCoding = request_of(0xA1, 0x21);
inline constexpr std::uint16_t kSetLineState = request_of(0x21, 0x22);
}  // namespace request

}  // namespace hal::stm32f405::usb
