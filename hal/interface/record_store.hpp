#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hal {

/// Small records, each under a number, that outlive power. Main loop context;
/// a save may take milliseconds, so it is done only while nothing moves.
class RecordStore {
 public:
  static constexpr std::size_t kLongestRecord = 96;

  /// Copies the record saved last under this number; returns its bytes, 0 when
  /// there is none. @pre `into` holds kLongestRecord bytes
  [[nodiscard]] virtual std::size_t load(std::uint16_t number, std::span<std::byte> into) = 0;
  /// Replaces the record; an empty one forgets it. False when nothing was
  /// changed: the store is full or out of order.
  [[nodiscard]] virtual bool save(std::uint16_t number, std::span<const std::byte> record) = 0;

 protected:
  ~RecordStore() = default;
};

}  // namespace hal
