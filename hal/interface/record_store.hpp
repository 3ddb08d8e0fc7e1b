#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hal {

/// How much of a store's life is used up. Nothing where nothing wears.
struct StoreWear {
  std::uint32_t erases = 0;  ///< Of all sectors together, since the first.
  std::uint32_t bytes_to_next_erase = 0;
};

/// Small records, each under a number, that outlive power. Main loop context;
/// a save may take most of a second, so it is done only while nothing moves and
/// nothing is switched on that would have to be switched off at once.
///
/// What is longer than a record, such as a large table, is several under numbers of
/// its own that nobody reads yet, and then one that names them: each save is whole by
/// itself, so that last one is the moment in which all of it counts.
class RecordStore {
 public:
  static constexpr std::size_t kLongestRecord = 96;

  /// Copies the record saved last under this number; returns its bytes, 0 when
  /// there is none. @pre `into` holds kLongestRecord bytes
  [[nodiscard]] virtual std::size_t load(std::uint16_t number, std::span<std::byte> into) = 0;
  /// Replaces the record; an empty one forgets it. False when nothing was
  /// changed: the store is full or out of order.
  [[nodiscard]] virtual bool save(std::uint16_t number, std::span<const std::byte> record) = 0;
  [[nodiscard]] virtual StoreWear wear() const = 0;
  /// Since the last power-up: something that had been saved could not be read, and load() may
  /// return an older record, or none. A save that power cut off is no damage.
  [[nodiscard]] virtual bool damaged() const { return false; }

 protected:
  ~RecordStore() = default;
};

}  // namespace hal
