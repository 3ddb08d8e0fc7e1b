#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "tests/target/machine/can_frame.hpp"

namespace machine {

/// The 28 filter banks of CAN1 and CAN2 (RM0090, 32.7.4 and 32.9.4). Banks below CAN2SB belong to
/// CAN1. While FINIT is set, no frame is accepted.
class CanFilters {
 public:
  /// FIFO of an accepted frame, and the number of the filter that it passed.
  struct Passed {
    unsigned fifo;
    std::uint32_t index;
  };

  void reset();
  /// Access to the registers by offsets from 0x200.
  [[nodiscard]] std::uint32_t read(std::uint32_t offset) const;
  void write(std::uint32_t offset, std::uint32_t value);
  [[nodiscard]] std::optional<Passed> pass(const CanFrame& frame) const;

 private:
  static constexpr unsigned kBanks = 28;

  /// Returns the number of filters of a bank: 32-bit mask 1, 32-bit list 2, 16-bit mask 2, 16-bit
  /// list 4.
  [[nodiscard]] unsigned filters_of(unsigned bank) const;
  [[nodiscard]] bool passes(unsigned bank, unsigned filter, const CanFrame& frame) const;
  [[nodiscard]] bool bit(std::uint32_t word, unsigned bank) const {
    return (word >> bank & 1U) != 0;
  }

  std::uint32_t master_ = 0, lists_ = 0, wide_ = 0, fifos_ = 0, active_ = 0;
  std::array<std::array<std::uint32_t, 2>, kBanks> banks_{};
};

}  // namespace machine
