#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace machine {

/// Model of the adaptive real-time accelerator of the flash (RM0090, 3.5.2) with all its functions
/// enabled. It has lines of 16 bytes, 64 for code and 8 for data, and replaces the line that was
/// used longest ago. One line of code is read ahead. All times are cycles.
class FlashAccelerator {
 public:
  /// Number of wait states at 150 to 168 MHz and 2.7 V or more.
  static constexpr std::uint64_t kWaitStates = 5;

  /// Returns the time that the core waits for the line of code at `address`.
  std::uint64_t fetch(std::uint32_t address, std::uint64_t now) {
    const std::uint32_t line = address / kLineBytes;
    if (line == fetched_) return 0;
    fetched_ = line;
    std::uint64_t wait = 0;
    if (!code_.use(line)) {
      wait = line == ahead_ ? ready_ - std::min(ready_, now) : kWaitStates;
      ++misses_;
    }
    if (line + 1 != ahead_ && !code_.has(line + 1)) {
      ahead_ = line + 1;
      ready_ = now + wait + kWaitStates + 1;
    }
    return wait;
  }

  /// Returns the time that a load from the flash waits.
  std::uint64_t load(std::uint32_t address) {
    return data_.use(address / kLineBytes) ? 0 : kWaitStates;
  }

  /// Returns the number of lines of code that were not in the cache, read ahead or not.
  [[nodiscard]] std::uint64_t misses() const { return misses_; }

 private:
  static constexpr std::uint32_t kLineBytes = 16;
  static constexpr std::uint32_t kNowhere = ~0U;

  template <std::size_t Lines>
  class Cache {
   public:
    Cache() { lines_.fill(kNowhere); }
    [[nodiscard]] bool has(std::uint32_t line) const {
      return std::find(lines_.begin(), lines_.end(), line) != lines_.end();
    }
    /// Makes a line the newest one; returns false if it had to be read.
    bool use(std::uint32_t line) {
      const auto place = std::find(lines_.begin(), lines_.end(), line);
      const bool there = place != lines_.end();
      std::move_backward(
          lines_.begin(), there ? place : lines_.end() - 1, there ? place + 1 : lines_.end());
      lines_.front() = line;
      return there;
    }

   private:
    std::array<std::uint32_t, Lines> lines_{};  ///< Numbers of the lines, the newest first.
  };

  Cache<64> code_;
  Cache<8> data_;
  std::uint32_t fetched_ = kNowhere;  ///< Line that the core executes at present.
  std::uint32_t ahead_ = kNowhere;
  std::uint64_t ready_ = 0;
  std::uint64_t misses_ = 0;
};

}  // namespace machine
