#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hal {

/// Wear of a store: the used part of its life. All values are zero for a store without wear.
struct StoreWear {
  std::uint32_t erases = 0;  ///< Number of erases of all sectors together, since first use.
  std::uint32_t bytes_to_next_erase = 0;
};

/// Small numbered records that outlive power. Main loop context. A save may take up to some
/// seconds, if it erases flash. Records may be saved only while nothing moves and while no output
/// is on that might have to be switched off immediately.
///
/// Content that is longer than a record, such as a large table, takes several records. First save
/// these under numbers to which no stored record refers. Then save one record that refers to them.
/// Each save is atomic, so the new content becomes valid with the last save.
class RecordStore {
 public:
  static constexpr std::size_t kLongestRecord = 96;

  /// Copies the latest record of this number to `into`. Returns its length in bytes, 0 if there is
  /// none.
  /// @pre `into` has at least kLongestRecord bytes
  [[nodiscard]] virtual std::size_t load(std::uint16_t number, std::span<std::byte> into) = 0;
  /// Replaces the record of this number; an empty record erases it. Returns false and changes
  /// nothing if the store is full or broken.
  [[nodiscard]] virtual bool save(std::uint16_t number, std::span<const std::byte> record) = 0;
  [[nodiscard]] virtual StoreWear wear() const = 0;
  /// Returns whether, since the last power-up, a saved record could not be read. Then load() may
  /// return an older record or none. A save that a power cut interrupted is not damage.
  [[nodiscard]] virtual bool damaged() const { return false; }

 protected:
  ~RecordStore() = default;
};

}  // namespace hal
