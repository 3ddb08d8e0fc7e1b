#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <type_traits>

namespace hal {

/// A bounded FIFO from the main loop to an interrupt that admits items at set instants. The reader
/// does not see staged items until they are published. So it does not matter how early within a
/// cycle an item was staged.
///
/// Counts run freely. The caller tells the writer how many items the reader had taken. So the
/// writer uses no later state than the one that its cycle may know.
template <typename Item, std::uint32_t Capacity>
class StagedRing {
  static_assert(std::is_trivially_copyable_v<Item>, "an interrupt copies bytes, nothing more");
  static_assert(std::has_single_bit(Capacity), "so that % becomes a mask");
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

 public:
  // Writer side.

  /// Returns the number of items staged since the beginning (wraps).
  [[nodiscard]] std::uint32_t staged() const { return staged_.load(std::memory_order_relaxed); }
  /// Returns the number of free places after the reader has taken `taken` items.
  [[nodiscard]] std::uint32_t room(std::uint32_t taken) const {
    return Capacity - (staged() - taken);
  }
  /// Returns the place where the next item is to be written before it is staged.
  /// @pre room() > 0
  [[nodiscard]] Item& next() { return items_[staged() % Capacity]; }
  void stage_next() { staged_.store(staged() + 1, std::memory_order_release); }
  /// Appends and stages an item.
  /// @pre room() > 0
  void stage(const Item& item) {
    next() = item;
    stage_next();
  }

  // Reader side.

  /// Publishes the items staged up to `count`. A count below the published one has no effect.
  void publish(std::uint32_t count) noexcept {
    if (static_cast<std::int32_t>(count - published_.load(std::memory_order_relaxed)) > 0) {
      published_.store(count, std::memory_order_release);
    }
  }
  /// Publishes all staged items.
  /// @pre the writer is not staging
  void publish_all() noexcept { publish(staged_.load(std::memory_order_acquire)); }
  /// Drops all items, published or not.
  /// @pre the writer is not staging
  void drop_all() noexcept {
    publish_all();
    taken_.store(published_.load(std::memory_order_relaxed), std::memory_order_release);
  }
  /// Returns the number of items taken since the beginning (wraps).
  [[nodiscard]] std::uint32_t taken() const noexcept {
    return taken_.load(std::memory_order_relaxed);
  }
  [[nodiscard]] bool empty() const noexcept {
    return published_.load(std::memory_order_relaxed) == taken();
  }
  /// Returns the oldest item in its place; null if the ring is empty. The reader may use it until
  /// the writer reuses the place, which cannot happen before drop_front().
  [[nodiscard]] Item* front() noexcept { return empty() ? nullptr : &items_[taken() % Capacity]; }
  /// Removes the oldest item. The writer reuses its place only after it has filled all other
  /// places.
  /// @pre front() is not null
  void drop_front() noexcept { taken_.store(taken() + 1, std::memory_order_release); }
  /// Takes the oldest item. Returns false if the ring is empty; `item` is then untouched.
  [[nodiscard]] bool try_pop(Item& item) noexcept {
    Item* const oldest = front();
    if (oldest == nullptr) return false;
    item = *oldest;
    drop_front();
    return true;
  }

 private:
  std::array<Item, Capacity> items_{};
  std::atomic<std::uint32_t> published_{0};  ///< Written by the reader, like `taken_`.
  std::atomic<std::uint32_t> taken_{0};
  std::atomic<std::uint32_t> staged_{0};
};

}  // namespace hal
