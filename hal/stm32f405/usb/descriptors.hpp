#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/stm32f405/usb/identity.hpp"

/// Descriptors that the device sends to the host (USB 2.0, chapter 9; CDC 1.2 and its PSTN120,
/// chapter 5). They describe a serial line that needs no special driver on the host.
namespace hal::stm32f405::usb {

/// Greatest packet size at full speed, for endpoint 0 and kData.
inline constexpr std::size_t kPacketBytes = 64;
/// Number of the bulk endpoint for data, in and out.
inline constexpr unsigned kData = 1;
/// Number of the interrupt endpoint, in; unused, but host drivers expect it.
inline constexpr unsigned kNews = 2;
inline constexpr std::size_t kNewsBytes = 8;
inline constexpr std::uint8_t kOnlyConfiguration = 1;
/// Number of interfaces: interface 0 is for control, interface 1 for data.
inline constexpr std::uint8_t kInterfaces = 2;

enum class DescriptorType : std::uint8_t {
  kDevice = 1,
  kConfiguration = 2,
  kString = 3,
  kInterface = 4,
  kEndpoint = 5,
  kClassInterface = 0x24,
};

enum class StringIndex : std::uint8_t { kLanguages, kMaker, kProduct, kSerial };

template <typename... Values>
constexpr std::array<std::byte, sizeof...(Values)> bytes_of(Values... values) {
  return {static_cast<std::byte>(values)...};
}

constexpr int low(std::size_t value) { return static_cast<int>(value & 0xFFU); }
constexpr int high(std::size_t value) { return static_cast<int>(value >> 8 & 0xFFU); }

constexpr auto device_descriptor(const Identity& identity) {
  return bytes_of(18,
                  DescriptorType::kDevice,
                  0x00,
                  0x02,  // USB release 2.0
                  2,
                  0,
                  0,  // Communications class, defined by its interfaces
                  kPacketBytes,
                  low(identity.vendor),
                  high(identity.vendor),
                  low(identity.product),
                  high(identity.product),
                  0x00,
                  0x01,  // Device release 1.00
                  StringIndex::kMaker,
                  StringIndex::kProduct,
                  StringIndex::kSerial,
                  1);
}

inline constexpr std::size_t kConfigurationBytes = 67;

inline constexpr auto kConfigurationDescriptor =
    bytes_of(9,
             DescriptorType::kConfiguration,
             low(kConfigurationBytes),
             high(kConfigurationBytes),
             kInterfaces,
             kOnlyConfiguration,
             0,
             0xC0,  // The board has its own supply.
             50,    // It takes at most 100 mA from USB.
             // Interface 0: an abstract control model without commands.
             9,
             DescriptorType::kInterface,
             0,
             0,
             1,
             2,
             2,
             0,
             0,
             5,
             DescriptorType::kClassInterface,
             0x00,
             0x10,
             0x01,
             5,
             DescriptorType::kClassInterface,
             0x01,
             0x00,
             1,  // Call management is not supported.
             4,
             DescriptorType::kClassInterface,
             0x02,
             0x02,  // Line coding and line state are supported, breaks are not.
             5,
             DescriptorType::kClassInterface,
             0x06,
             0,
             1,
             7,
             DescriptorType::kEndpoint,
             0x80U | kNews,
             3,
             kNewsBytes,
             0,
             255,
             // Interface 1: data.
             9,
             DescriptorType::kInterface,
             1,
             0,
             2,
             10,
             0,
             0,
             0,
             7,
             DescriptorType::kEndpoint,
             kData,
             2,
             kPacketBytes,
             0,
             0,
             7,
             DescriptorType::kEndpoint,
             0x80U | kData,
             2,
             kPacketBytes,
             0,
             0);

inline constexpr auto kLanguages = bytes_of(4, DescriptorType::kString, 0x09, 0x04);

/// Checks that the length fields of the descriptors lead exactly to the end of `bytes`.
template <std::size_t Count>
constexpr bool is_chain(const std::array<std::byte, Count>& bytes) {
  std::size_t at = 0;
  while (at + 1 < Count && bytes[at] != std::byte{0}) at += static_cast<std::size_t>(bytes[at]);
  return at == Count;
}
/// Returns the number of descriptors of one type in a chain of descriptors (see is_chain).
template <std::size_t Count>
constexpr int count_of(const std::array<std::byte, Count>& bytes, DescriptorType type) {
  int count = 0;
  for (std::size_t at = 0; at + 1 < Count; at += static_cast<std::size_t>(bytes[at])) {
    if (bytes[at + 1] == static_cast<std::byte>(type)) ++count;
  }
  return count;
}

static_assert(kConfigurationDescriptor.size() == kConfigurationBytes);
static_assert(is_chain(kConfigurationDescriptor) && is_chain(device_descriptor({})));
static_assert(count_of(kConfigurationDescriptor, DescriptorType::kInterface) == kInterfaces);
static_assert(count_of(kConfigurationDescriptor, DescriptorType::kEndpoint) == 3);
static_assert(count_of(kConfigurationDescriptor, DescriptorType::kClassInterface) == 4);

}  // namespace hal::stm32f405::usb
