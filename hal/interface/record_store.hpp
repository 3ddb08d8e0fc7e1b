#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hal {

/// How much of a store's life is used up. All zero for a store without wear.
struct StoreWear {
  std::uint32_t erases = 0;  ///< Erases of all sectors together, since first use.
  std::uint32_t bytes_to_next_erase = 0;
};

/// Small records, each under a number, that outlive power. Main loop context. A save may take most
/// of a second. So records are saved only while nothing moves and no output is on that might have
/// to be switched off at once.
///
/// Content that is longer than a record, such as a large table, takes several records. They are
/// saved under numbers that no stored record names yet; last, one record that names them is saved.
/// Each save is whole by itself, so the new content becomes valid with that last save.
class RecordStore {
 public:
  static constexpr std::size_t kLongestRecord = 96;

  /// Copies the latest record of this number; returns its length in bytes, 0 if there is none.
  /// @pre `into` holds kLongestRecord bytes
  [[nodiscard]] virtual std::size_t load(std::uint16_t number, std::span<std::byte> into) = 0;
  /// Replaces the record; an empty record erases it. Returns false if the store is full or out of
  /// order; then nothing was changed.
  [[nodiscard]] virtual bool save(std::uint16_t number, std::span<const std::byte> record) = 0;
  [[nodiscard]] virtual StoreWear wear() const = 0;
  /// Returns whether, since the last power-up, a saved record could not be read. Then load() may
  /// return an older record, or none. A save that a power cut interrupted is no damage.
  [[nodiscard]] virtual bool damaged() const { return false; }

 protected:
  ~RecordStore() = default;
};

}  // namespace hal
