#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace cnc {

/// Text being put together for the link. What does not fit is cut off.
class Reply {
 public:
  static constexpr std::size_t kCapacity = 192;

  Reply& text(std::string_view words);
  Reply& number(std::uint32_t value);
  /// Room for somebody who writes by himself; tell with `wrote` how much it was.
  [[nodiscard]] std::span<char> room() { return std::span{bytes_}.subspan(size_); }
  void wrote(std::size_t count) { size_ += count; }

  [[nodiscard]] std::string_view view() const { return {bytes_.data(), size_}; }

 private:
  std::array<char, kCapacity> bytes_{};
  std::size_t size_ = 0;
};

}  // namespace cnc
