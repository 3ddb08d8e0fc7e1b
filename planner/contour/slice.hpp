#pragma once

#include <array>
#include <cstddef>

namespace cnc::contour {

/// A range of storage that this object does not own. Its length is known at run time.
template <typename Item>
class Slice {
 public:
  constexpr Slice() = default;
  constexpr Slice(Item* first, std::size_t size) : first_{first}, size_{size} {}
  template <std::size_t kSize>
  constexpr Slice(std::array<Item, kSize>& items)  // NOLINT(google-explicit-constructor)
      : first_{items.data()}, size_{kSize} {}

  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  /// @pre index < size(). This is not checked, because nearly all of the time of an offset is spent
  ///     in this access.
  [[nodiscard]] constexpr Item& operator[](std::size_t index) const { return first_[index]; }
  [[nodiscard]] constexpr Item* begin() const { return first_; }
  [[nodiscard]] constexpr Item* end() const { return first_ + size_; }

 private:
  Item* first_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace cnc::contour
