#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace sim::surface {

enum class ByteOrder : std::uint8_t { kLittleEndian, kBigEndian };

/// Reads numbers from the bytes of a file. The caller must check left() before each take().
class ByteReader {
 public:
  ByteReader(std::string_view bytes, ByteOrder order) : bytes_{bytes}, order_{order} {}

  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  [[nodiscard]] std::size_t at() const { return at_; }

  void skip(std::size_t count) { at_ += count; }

  /// Returns the next sizeof(Whole) bytes as a number in the reader's byte order.
  /// @pre left() >= sizeof(Whole)
  template <std::unsigned_integral Whole>
  Whole take() {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(Whole); ++i) {
      const std::size_t from = order_ == ByteOrder::kBigEndian ? i : sizeof(Whole) - 1 - i;
      value = value << 8U | static_cast<std::uint8_t>(bytes_[at_ + from]);
    }
    at_ += sizeof(Whole);
    return static_cast<Whole>(value);
  }
  double take_float() { return static_cast<double>(std::bit_cast<float>(take<std::uint32_t>())); }
  double take_double() { return std::bit_cast<double>(take<std::uint64_t>()); }

 private:
  std::string_view bytes_;
  ByteOrder order_;
  std::size_t at_ = 0;
};

}  // namespace sim::surface
