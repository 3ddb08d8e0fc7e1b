#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "hal/interface/record_store.hpp"
#include "planner/base/result.hpp"
#include "planner/kerf/table_image.hpp"

namespace cnc {

enum class KerfTablesError : std::uint8_t {
  kNoSuchTable,
  kBuiltIn,     ///< A built-in table can be neither replaced nor erased.
  kNoRoom,      ///< The maximum number of tables is stored.
  kDamaged,     ///< The stored bytes are not a complete, correct table.
  kOutOfOrder,  ///< The part does not follow the previous part; part 0 restarts the transfer.
  kNothing,     ///< No part has been received.
  kStoreFailed,
};

[[nodiscard]] std::string_view describe(KerfTablesError error);

/// The controller's kerf tables by name: the built-in tables, and up to four stored tables, which
/// outlive power.
///
/// A table arrives as an image (planner/kerf/table_image.hpp) in parts of 96 bytes. The parts are
/// saved as records of a bank that is not yet in the directory. When the table is complete, the
/// directory, which is a single record, is saved with the number of the bank. So a power cut leaves
/// either the earlier table or the new table.
///
/// Only one stored table at a time is in memory. Saving may take up to some seconds: take_part(),
/// keep(), forget() and forget_all() are allowed only while nothing moves. Main loop context.
class KerfTables {
 public:
  static constexpr std::size_t kMaxStored = 4;
  static constexpr std::size_t kPartBytes = hal::RecordStore::kLongestRecord;
  static constexpr std::size_t kMaxParts =
      (kerf::table_image::kMaxBytes + kPartBytes - 1) / kPartBytes;

  explicit KerfTables(hal::RecordStore& store) : store_{store} {}

  /// Reason of a refusal: an error in the handling of the tables, or a fault in the content of one
  /// table. If both are empty, there is no refusal.
  struct Trouble {
    std::optional<KerfTablesError> tables{};
    std::optional<kerf::TableFault> table{};
    [[nodiscard]] explicit operator bool() const { return tables || table; }
  };
  /// Takes the next part of an image; part 0 begins a new transfer. Only the last part may be
  /// shorter than kPartBytes. Returns an error if parts are out of order, if the store fails, or if
  /// the parts so far show that the table cannot be used.
  [[nodiscard]] Trouble take_part(std::size_t part, std::span<const std::byte> bytes);
  /// Checks whether the parts taken so far are a complete table. If they are, its name is in
  /// candidate().
  [[nodiscard]] Trouble check();
  [[nodiscard]] std::string_view candidate() const { return table_.view().name; }
  /// Stores the table that the last check() has accepted. Replaces a stored table of the same name.
  [[nodiscard]] std::optional<KerfTablesError> keep();

  [[nodiscard]] std::optional<KerfTablesError> forget(std::string_view name);
  /// Erases all stored tables. Returns false if the store failed.
  [[nodiscard]] bool forget_all();

  /// Returns the number of tables; the built-in tables have the first indices. Damaged stored
  /// tables count.
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::size_t stored() const;
  [[nodiscard]] static std::size_t built_in();
  /// Returns a number that changes whenever a stored table, the list of tables or the table in
  /// memory may have changed.
  [[nodiscard]] std::uint32_t revision() const { return revision_; }
  /// Returns a table. A stored table is valid until the next call of a member function.
  /// @pre index < count()
  [[nodiscard]] Result<kerf::TableView<float>, KerfTablesError> table(std::size_t index);
  [[nodiscard]] Result<std::size_t, KerfTablesError> find(std::string_view name) const;
  /// Reads a part of a stored table's image.
  /// @return length of the part in bytes; 0 after the last part
  /// @pre index < count()
  [[nodiscard]] std::size_t read_part(std::size_t index,
                                      std::size_t part,
                                      std::span<std::byte, kPartBytes> into) const;

 private:
  struct Entry {
    std::uint8_t bank = 0;
    std::uint16_t bytes = 0;  ///< Length of the image in bytes; 0: free entry.
  };
  using Directory = std::array<Entry, kMaxStored>;

  [[nodiscard]] Directory load_directory() const;
  [[nodiscard]] bool save_directory(const Directory& directory);
  [[nodiscard]] bool is_named(const Entry& entry, std::string_view name) const;
  [[nodiscard]] std::size_t spare_bank() const;
  [[nodiscard]] Entry entry_of(std::size_t index) const;
  [[nodiscard]] std::optional<kerf::TableFault> read(const Entry& entry);
  void forget_parts(std::size_t bank);

  hal::RecordStore& store_;
  std::size_t size_ = 0;  ///< Number of received bytes in the spare bank.
  bool checked_ = false;
  std::uint32_t revision_ = 1;
  kerf::StoredTable table_{};  ///< The stored table that is in memory.
};

}  // namespace cnc
