#pragma once

#include <cstddef>
#include <cstdint>

/// Bits of the core's registers by RM0090, 34.16, written again for the model, independently of the
/// driver.
namespace hal::stm32f405::otg_bits {

constexpr std::uint32_t one(unsigned place) { return std::uint32_t{1} << place; }
constexpr std::uint32_t kEpEnabled = one(31), kEpDisable = one(30), kEpData0 = one(28);
constexpr std::uint32_t kEpSnak = one(27), kEpCnak = one(26), kEpStall = one(21);
constexpr std::uint32_t kEpNakking = one(17), kEpActive = one(15);
constexpr std::uint32_t kEpXfrc = one(0), kEpDisd = one(1), kEpStup = one(3), kEpInepne = one(6);
constexpr std::uint32_t kUsbRst = one(12), kEnumDne = one(13), kUsbSusp = one(11), kWkup = one(31);
constexpr unsigned kOutEntry = 2, kOutOverEntry = 3, kSetUpOverEntry = 4, kSetUpEntry = 6;

constexpr std::uint32_t packets_of(std::uint32_t size) { return size >> 19 & 0x3FFU; }
constexpr std::uint32_t bytes_left(std::uint32_t size) { return size & 0x7FFFFU; }
constexpr bool is_endpoint(std::uint32_t offset) {
  return (offset >= 0x900 && offset < 0x980) || (offset >= 0xB00 && offset < 0xB80);
}
constexpr std::size_t words_for(std::size_t bytes) { return (bytes + 3) / 4; }

}  // namespace hal::stm32f405::otg_bits
