#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/interface/record_store.hpp"

namespace hal::stm32f405 {

/// Records that last until the power goes, for as long as there is no store in
/// flash: settings hold for a session only.
class VolatileStore final : public RecordStore {
 public:
  static constexpr std::size_t kBytes = 3072;  ///< All settings changed, and some texts.

  [[nodiscard]] std::size_t load(std::uint16_t number, std::span<std::byte> into) override {
    const std::size_t at = find(number);
    if (at == used_) return 0;
    const std::size_t size = size_at(at);
    for (std::size_t i = 0; i < size && i < into.size(); ++i) into[i] = bytes_[at + kHead + i];
    return size;
  }

  [[nodiscard]] bool save(std::uint16_t number, std::span<const std::byte> record) override {
    if (record.size() > kLongestRecord) return false;
    const std::size_t old = find(number);
    const std::size_t freed = old == used_ ? 0 : kHead + size_at(old);
    const std::size_t wanted = record.empty() ? 0 : kHead + record.size();
    if (used_ - freed + wanted > kBytes) return false;
    for (std::size_t at = old; at + freed < used_; ++at) bytes_[at] = bytes_[at + freed];
    used_ -= freed;
    if (!record.empty()) append(number, record);
    return true;
  }

 private:
  static constexpr std::size_t kHead = 3;  ///< Number, low byte first, and size.

  [[nodiscard]] std::size_t size_at(std::size_t at) const {
    return static_cast<std::size_t>(bytes_[at + 2]);
  }
  /// Where the record begins; the end when there is none.
  [[nodiscard]] std::size_t find(std::uint16_t number) const {
    std::size_t at = 0;
    while (at < used_ && (bytes_[at] != static_cast<std::byte>(number & 0xFFU) ||
                          bytes_[at + 1] != static_cast<std::byte>(number >> 8))) {
      at += kHead + size_at(at);
    }
    return at;
  }
  void append(std::uint16_t number, std::span<const std::byte> record) {
    bytes_[used_++] = static_cast<std::byte>(number & 0xFFU);
    bytes_[used_++] = static_cast<std::byte>(number >> 8);
    bytes_[used_++] = static_cast<std::byte>(record.size());
    for (const std::byte byte : record) bytes_[used_++] = byte;
  }

  std::array<std::byte, kBytes> bytes_{};
  std::size_t used_ = 0;
};

}  // namespace hal::stm32f405
