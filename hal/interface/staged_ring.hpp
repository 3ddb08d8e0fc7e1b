#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <type_traits>

namespace hal {

/// A bounded FIFO from the main loop to an interrupt. The reader sees staged items only after they
/// are published, at fixed instants. So the result does not depend on the time within a cycle at
/// which an item was staged.
///
/// The counts wrap. The caller passes the number of taken items to the writer, so that the writer
/// uses no later state than its cycle may know.
template <typename Item, std::uint32_t Capacity>
class StagedRing {
  static_assert(std::is_trivially_copyable_v<Item>, "an interrupt copies bytes, nothing more");
  static_assert(std::has_single_bit(Capacity), "so that % becomes a mask");
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

 public:
  // Functions for the writer.

  /// Returns the number of staged items since the beginning (wraps).
  [[nodiscard]] std::uint32_t staged() const { return staged_.load(std::memory_order_relaxed); }
  /// Returns the number of free slots if the reader has taken `taken` items.
  [[nodiscard]] std::uint32_t room(std::uint32_t taken) const {
    return Capacity - (staged() - taken);
  }
  /// Returns the slot for the next item. The caller writes the item there, then calls stage_next().
  /// @pre room() > 0
  [[nodiscard]] Item& next() { return items_[staged() % Capacity]; }
  void stage_next() { staged_.store(staged() + 1, std::memory_order_release); }
  /// Appends and stages an item.
  /// @pre room() > 0
  void stage(const Item& item) {
    next() = item;
    stage_next();
  }

  // Functions for the reader.

  /// Publishes the staged items up to `count`. Does nothing if `count` is below the published
  /// count.
  void publish(std::uint32_t count) noexcept {
    if (static_cast<std::int32_t>(count - published_.load(std::memory_order_relaxed)) > 0) {
      published_.store(count, std::memory_order_release);
    }
  }
  /// Publishes all staged items.
  /// @pre the writer is not staging
  void publish_all() noexcept { publish(staged_.load(std::memory_order_acquire)); }
  /// Drops all items, both published and unpublished.
  /// @pre the writer is not staging
  void drop_all() noexcept {
    publish_all();
    taken_.store(published_.load(std::memory_order_relaxed), std::memory_order_release);
  }
  /// Returns the number of taken items since the beginning (wraps).
  [[nodiscard]] std::uint32_t taken() const noexcept {
    return taken_.load(std::memory_order_relaxed);
  }
  [[nodiscard]] bool empty() const noexcept {
    return published_.load(std::memory_order_relaxed) == taken();
  }
  /// Returns the oldest item in its slot; null if the ring is empty. The reader may use it until
  /// drop_front(), because the writer cannot reuse the slot before.
  [[nodiscard]] Item* front() noexcept { return empty() ? nullptr : &items_[taken() % Capacity]; }
  /// Removes the oldest item. The writer reuses its slot only after it has filled all other slots.
  /// @pre front() is not null
  void drop_front() noexcept { taken_.store(taken() + 1, std::memory_order_release); }
  /// Takes the oldest item. Returns false and leaves `item` unchanged if the ring is empty.
  [[nodiscard]] bool try_pop(Item& item) noexcept {
    Item* const oldest = front();
    if (oldest == nullptr) return false;
    item = *oldest;
    drop_front();
    return true;
  }

 private:
  std::array<Item, Capacity> items_{};
  /// Number of published items; the reader writes it, like `taken_`.
  std::atomic<std::uint32_t> published_{0};
  std::atomic<std::uint32_t> taken_{0};
  std::atomic<std::uint32_t> staged_{0};
};

}  // namespace hal
