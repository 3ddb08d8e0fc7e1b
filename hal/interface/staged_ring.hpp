#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <type_traits>

namespace hal {

/// A bounded FIFO from the main loop to an interrupt which lets the items in at
/// set instants: what is staged does not exist for the reader until it is
/// published, so how early within a turn it was staged changes nothing.
///
/// Counts run freely. The writer is told by its caller how many the reader had
/// taken, and so asks for no more than what it may know in its turn.
template <typename Item, std::uint32_t Capacity>
class StagedRing {
  static_assert(std::is_trivially_copyable_v<Item>, "an interrupt copies bytes, nothing more");
  static_assert(std::has_single_bit(Capacity), "so that % becomes a mask");
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

 public:
  // Writer.

  /// Items staged since the beginning.
  [[nodiscard]] std::uint32_t staged() const { return staged_.load(std::memory_order_relaxed); }
  /// Places that are free when `taken` items have been taken.
  [[nodiscard]] std::uint32_t room(std::uint32_t taken) const {
    return Capacity - (staged() - taken);
  }
  /// Where the next item is written before it is staged. @pre room() > 0
  [[nodiscard]] Item& next() { return items_[staged() % Capacity]; }
  void stage_next() { staged_.store(staged() + 1, std::memory_order_release); }
  /// @pre room() > 0
  void stage(const Item& item) {
    next() = item;
    stage_next();
  }

  // Reader.

  /// Lets in what was staged up to this count; never fewer than before.
  void publish(std::uint32_t count) noexcept {
    if (static_cast<std::int32_t>(count - published_.load(std::memory_order_relaxed)) > 0) {
      published_.store(count, std::memory_order_release);
    }
  }
  /// Lets in all there is. @pre the writer is not staging
  void publish_all() noexcept { publish(staged_.load(std::memory_order_acquire)); }
  /// Forgets all there is, published or not. @pre the writer is not staging
  void drop_all() noexcept {
    publish_all();
    taken_.store(published_.load(std::memory_order_relaxed), std::memory_order_release);
  }
  /// Items taken since the beginning.
  [[nodiscard]] std::uint32_t taken() const noexcept {
    return taken_.load(std::memory_order_relaxed);
  }
  [[nodiscard]] bool empty() const noexcept {
    return published_.load(std::memory_order_relaxed) == taken();
  }
  /// The oldest item, where it lies and is the reader's until the writer comes round; null when
  /// empty.
  [[nodiscard]] Item* front() noexcept { return empty() ? nullptr : &items_[taken() % Capacity]; }
  /// Done with it. @pre front() is not null
  void drop_front() noexcept { taken_.store(taken() + 1, std::memory_order_release); }
  /// False when empty; `item` is then untouched.
  [[nodiscard]] bool try_pop(Item& item) noexcept {
    Item* const oldest = front();
    if (oldest == nullptr) return false;
    item = *oldest;
    drop_front();
    return true;
  }

 private:
  std::array<Item, Capacity> items_{};
  std::atomic<std::uint32_t> published_{0};  ///< Reader's, as is what it has taken.
  std::atomic<std::uint32_t> taken_{0};
  std::atomic<std::uint32_t> staged_{0};
};

}  // namespace hal
