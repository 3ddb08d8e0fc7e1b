#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "planner/base/coordinate.hpp"

namespace cnc {

/// Builds one line for the link, including its line end, in memory of the caller. Text that does
/// not fit is cut off; the line end always fits.
class Reply {
 public:
  static constexpr std::size_t kCapacity = 320;
  using Bytes = std::span<char, kCapacity>;

  explicit Reply(Bytes bytes) : bytes_{bytes} {}

  Reply& text(std::string_view words);
  Reply& letter(char one) { return text({&one, 1}); }
  Reply& number(std::uint32_t value);
  /// Appends `value` with seven significant digits and at most six decimals. Omits trailing zeros
  /// after the first `least` decimals.
  /// @pre |value| < 2^31
  Reply& value(float value, std::uint32_t least);
  /// Appends the whole number that is nearest to `value`.
  /// @pre |value| < 2^31
  Reply& whole(float value);
  /// Appends a position in mm (degrees) with three decimals, or in inches with four decimals.
  Reply& place(Coordinate place, bool inches);
  void clear() { size_ = 0; }
  /// Appends the line end; must be the last call.
  Reply& end();

  /// Returns the free space, for a caller that writes into it directly. The caller must then pass
  /// the number of written bytes to wrote().
  [[nodiscard]] std::span<char> room() {
    return bytes_.subspan(size_, kCapacity - kEnd.size() - size_);
  }
  void wrote(std::size_t count) { size_ += count; }

  [[nodiscard]] std::string_view view() const { return {bytes_.data(), size_}; }

 private:
  static constexpr std::string_view kEnd = "\r\n";

  Reply& fraction(std::uint32_t digits, std::uint32_t count);

  Bytes bytes_;
  std::size_t size_ = 0;
};

}  // namespace cnc
