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
  kNoRoom,      ///< All places for tables are taken.
  kDamaged,     ///< The stored data are not a whole table.
  kOutOfOrder,  ///< A part does not follow the part before; part 0 restarts.
  kNothing,     ///< No part has been taken.
  kStoreFailed,
};

[[nodiscard]] std::string_view describe(KerfTablesError error);

/// The controller's kerf tables by name: the built-in ones, and up to four stored ones, which
/// outlive power.
///
/// A table arrives as an image (planner/kerf/table_image.hpp) in parts of 96 bytes. The parts are
/// saved as records of a bank that the directory does not name yet. When the table is whole, the
/// directory, which is one record, is saved with the name of the bank. So after a power cut either
/// the earlier table is there or the new one.
///
/// One table at a time is in memory. Saving may take most of a second: take_part(), keep(),
/// forget() and forget_all() are allowed only while nothing moves. Main loop context.
class KerfTables {
 public:
  static constexpr std::size_t kMaxStored = 4;
  static constexpr std::size_t kPartBytes = hal::RecordStore::kLongestRecord;
  static constexpr std::size_t kMaxParts =
      (kerf::table_image::kMaxBytes + kPartBytes - 1) / kPartBytes;

  explicit KerfTables(hal::RecordStore& store) : store_{store} {}

  /// Reason of a refusal: an error of the tables, or a fault in the content of one.
  struct Trouble {
    std::optional<KerfTablesError> tables{};
    std::optional<kerf::TableFault> table{};
    [[nodiscard]] explicit operator bool() const { return tables || table; }
  };
  /// Takes the next part of an image; part 0 restarts. Only the last part may be shorter than
  /// kPartBytes. Returns an error of the order, or of a table that already proves not to fit.
  [[nodiscard]] Trouble take_part(std::size_t part, std::span<const std::byte> bytes);
  /// Checks whether the parts taken are a whole table; its name is then in candidate().
  [[nodiscard]] Trouble check();
  [[nodiscard]] std::string_view candidate() const { return table_.view().name; }
  /// Stores the table that check() has just accepted, in place of the table of the same name.
  [[nodiscard]] std::optional<KerfTablesError> keep();

  [[nodiscard]] std::optional<KerfTablesError> forget(std::string_view name);
  /// Erases all stored tables. Returns false if the store failed.
  [[nodiscard]] bool forget_all();

  /// Returns the number of tables, built-in ones first. Damaged stored tables count.
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::size_t stored() const;
  [[nodiscard]] static std::size_t built_in();
  /// Returns a number that changes with each change of a stored table, of the list, or of the table
  /// in memory.
  [[nodiscard]] std::uint32_t revision() const { return revision_; }
  /// Returns a table. A stored one is valid until the next call of a member.
  /// @pre index < count()
  [[nodiscard]] Result<kerf::TableView<float>, KerfTablesError> table(std::size_t index);
  [[nodiscard]] Result<std::size_t, KerfTablesError> find(std::string_view name) const;
  /// Reads a part of a stored table's image.
  /// @return length of the part in bytes, 0 after the last
  /// @pre index < count()
  [[nodiscard]] std::size_t read_part(std::size_t index,
                                      std::size_t part,
                                      std::span<std::byte, kPartBytes> into) const;

 private:
  struct Entry {
    std::uint8_t bank = 0;
    std::uint16_t bytes = 0;  ///< Length of the image; 0: free entry.
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
  std::size_t size_ = 0;  ///< Bytes of the parts taken so far, in the spare bank.
  bool checked_ = false;
  std::uint32_t revision_ = 1;
  kerf::StoredTable table_{};  ///< The table in memory.
};

}  // namespace cnc
