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
  kBuiltIn,     ///< It can neither be replaced nor forgotten.
  kNoRoom,      ///< All places are taken.
  kDamaged,     ///< What is stored is no whole table.
  kOutOfOrder,  ///< A part that does not follow the one before; part 0 begins anew.
  kNothing,     ///< No part has been taken.
  kStoreFailed,
};

[[nodiscard]] std::string_view describe(KerfTablesError error);

/// The controller's kerf tables by name: those built in, and up to four that outlive power.
///
/// A table comes as an image (planner/kerf/table_image.hpp) in parts of 96 bytes, which are records
/// of a bank that nobody reads yet; when it is whole, the directory, one record, names the bank. So
/// power may go at any moment: what was kept before is there, or what came after.
///
/// One table at a time is in memory. Saving may take most of a second: take_part(), keep(),
/// forget() and forget_all() only while nothing moves. Main loop context.
class KerfTables {
 public:
  static constexpr std::size_t kMostStored = 4;
  static constexpr std::size_t kPartBytes = hal::RecordStore::kLongestRecord;
  static constexpr std::size_t kMostParts =
      (kerf::table_image::kMostBytes + kPartBytes - 1) / kPartBytes;

  explicit KerfTables(hal::RecordStore& store) : store_{store} {}

  /// Takes the next part of an image; 0 begins anew. Only the last is shorter than kPartBytes.
  /// @return what is wrong with the order, or with a table that can be seen not to fit
  struct Trouble {
    std::optional<KerfTablesError> tables{};
    std::optional<kerf::TableFault> table{};
    [[nodiscard]] explicit operator bool() const { return tables || table; }
  };
  [[nodiscard]] Trouble take_part(std::size_t part, std::span<const std::byte> bytes);
  /// Whether the parts taken are a table; its name is then in candidate().
  [[nodiscard]] Trouble check();
  [[nodiscard]] std::string_view candidate() const { return table_.view().name; }
  /// Keeps what check() has just found whole, in place of the table of the same name.
  [[nodiscard]] std::optional<KerfTablesError> keep();

  [[nodiscard]] std::optional<KerfTablesError> forget(std::string_view name);
  /// Forgets all that are stored. False when the store failed.
  [[nodiscard]] bool forget_all();

  /// Tables there are, built-in ones first; stored ones that are damaged count.
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::size_t stored() const;
  [[nodiscard]] static std::size_t built_in();
  /// Another number whenever a stored table, the list or what is in memory of it has changed.
  [[nodiscard]] std::uint32_t revision() const { return revision_; }
  /// One of them; a stored one is valid until the next call of a member. @pre index < count()
  [[nodiscard]] Result<kerf::TableView<float>, KerfTablesError> table(std::size_t index);
  [[nodiscard]] Result<std::size_t, KerfTablesError> find(std::string_view name) const;
  /// A part of a stored one's image. @return its bytes, 0 after the last. @pre index < count()
  [[nodiscard]] std::size_t read_part(std::size_t index,
                                      std::size_t part,
                                      std::span<std::byte, kPartBytes> into) const;

 private:
  struct Entry {
    std::uint8_t bank = 0;
    std::uint16_t bytes = 0;  ///< Of the image; 0: the place is free.
  };
  using Directory = std::array<Entry, kMostStored>;

  [[nodiscard]] Directory load_directory() const;
  [[nodiscard]] bool save_directory(const Directory& directory);
  [[nodiscard]] bool is_named(const Entry& entry, std::string_view name) const;
  [[nodiscard]] std::size_t spare_bank() const;
  [[nodiscard]] Entry entry_of(std::size_t index) const;
  [[nodiscard]] std::optional<kerf::TableFault> read(const Entry& entry);
  void forget_parts(std::size_t bank);

  hal::RecordStore& store_;
  std::size_t size_ = 0;  ///< Bytes of the parts taken, in the spare bank.
  bool checked_ = false;
  std::uint32_t revision_ = 1;
  kerf::StoredTable table_{};  ///< What was looked at last.
};

}  // namespace cnc
