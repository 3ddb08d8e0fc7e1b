#include "firmware/store/kerf_tables.hpp"

#include <algorithm>

#include "planner/base/contract.hpp"
#include "planner/kerf/csp_1n.hpp"

namespace cnc {
namespace {

// Numbers of records.
constexpr std::uint16_t kKerfDirectory = 0x6000;
constexpr std::uint16_t kKerfParts = 0x6100;  ///< 32 · bank + part is added.
constexpr std::uint16_t kBankStride = 32;

/// Number of banks: one more than the maximum number of stored tables, so that at least one bank is
/// not in the directory.
constexpr std::size_t kBanks = KerfTables::kMaxStored + 1;
constexpr std::size_t kEntryBytes = 3;
static_assert(KerfTables::kMaxParts <= kBankStride);
static_assert(KerfTables::kMaxStored * kEntryBytes <= hal::RecordStore::kLongestRecord);

constexpr std::array<kerf::TableView<float>, 2> kBuiltInTables{kerf::kCsp1n<float>,
                                                               kerf::kCsp1nPhysical<float>};

using PartBytes = std::array<std::byte, KerfTables::kPartBytes>;

constexpr std::uint16_t part_record(std::size_t bank, std::size_t part) {
  return static_cast<std::uint16_t>(kKerfParts + kBankStride * bank + part);
}

constexpr std::size_t parts_of(std::size_t bytes) {
  return (bytes + KerfTables::kPartBytes - 1) / KerfTables::kPartBytes;
}

/// A stored image of which one part at a time is in memory.
class StoredImage final : public kerf::ImageSource {
 public:
  StoredImage(hal::RecordStore& store, std::size_t bank, std::size_t bytes)
      : store_{store}, bank_{bank}, bytes_{bytes} {}

  [[nodiscard]] std::size_t size() const override { return bytes_; }
  void read(std::size_t at, std::span<std::byte> into) override {
    for (std::byte& byte : into) {
      fetch(at / KerfTables::kPartBytes);
      byte = part_[at++ % KerfTables::kPartBytes];
    }
  }

 private:
  void fetch(std::size_t part) {
    if (part == fetched_) return;
    part_ = {};
    static_cast<void>(store_.load(part_record(bank_, part), part_));
    fetched_ = part;
  }

  hal::RecordStore& store_;
  std::size_t bank_;
  std::size_t bytes_;
  /// Number of the part in memory; initially no part.
  std::size_t fetched_ = KerfTables::kMaxParts;
  PartBytes part_{};
};

bool is_built_in(std::string_view name) {
  return std::any_of(kBuiltInTables.begin(), kBuiltInTables.end(), [&](const auto& table) {
    return table.name == name;
  });
}

/// Returns whether an image with this error can be refused after its first part.
bool shows_in_head(kerf::TableError error) {
  return error == kerf::TableError::kNotATable || error == kerf::TableError::kOtherVersion ||
         error == kerf::TableError::kTooManyRows || error == kerf::TableError::kTooManyBands ||
         error == kerf::TableError::kTooManyPoints;
}

}  // namespace

std::string_view describe(KerfTablesError error) {
  switch (error) {
    case KerfTablesError::kNoSuchTable:
      return "no such kerf table; $K lists them";
    case KerfTablesError::kBuiltIn:
      return "this kerf table is built in";
    case KerfTablesError::kNoRoom:
      return "no room for another kerf table, 4 are kept; $KE= forgets one";
    case KerfTablesError::kDamaged:
      return "this kerf table is damaged; write it again or forget it";
    case KerfTablesError::kOutOfOrder:
      return "parts come in order, each of 96 bytes except the last; begin again with $KW=0:";
    case KerfTablesError::kNothing:
      return "no kerf table was written; begin with $KW=0:";
    case KerfTablesError::kStoreFailed:
      return "the store has failed";
  }
  return {};
}

std::size_t KerfTables::built_in() { return kBuiltInTables.size(); }

KerfTables::Trouble KerfTables::take_part(std::size_t part, std::span<const std::byte> bytes) {
  checked_ = false;
  const std::size_t before = part == 0 ? 0 : size_;
  size_ = 0;  // Every refusal ends the transfer of the table.
  if (bytes.empty() || bytes.size() > kPartBytes || before != part * kPartBytes) {
    return {.tables = KerfTablesError::kOutOfOrder};
  }
  if (before + bytes.size() > kerf::table_image::kMaxBytes) {
    return {.table = kerf::TableFault{kerf::TableError::kBadSize}};
  }
  if (part == 0) {
    ++revision_;
    const auto fault = kerf::read_image(bytes, table_);
    if (fault && shows_in_head(fault->error)) return {.table = fault};
  }
  if (!store_.save(part_record(spare_bank(), part), bytes)) {
    return {.tables = KerfTablesError::kStoreFailed};
  }
  size_ = before + bytes.size();
  return {};
}

KerfTables::Trouble KerfTables::check() {
  if (size_ == 0) return {.tables = KerfTablesError::kNothing};
  const auto fault =
      read({static_cast<std::uint8_t>(spare_bank()), static_cast<std::uint16_t>(size_)});
  if (fault) {
    size_ = 0;
    return {.table = fault};
  }
  if (is_built_in(candidate())) return {.tables = KerfTablesError::kBuiltIn};
  checked_ = true;
  return {};
}

std::optional<KerfTablesError> KerfTables::keep() {
  CNC_ASSERT(checked_);
  checked_ = false;
  Directory directory = load_directory();
  const auto same = [this](const Entry& entry) { return is_named(entry, candidate()); };
  const auto free = [](const Entry& entry) { return entry.bytes == 0; };
  auto* place = std::find_if(directory.begin(), directory.end(), same);
  if (place == directory.end()) place = std::find_if(directory.begin(), directory.end(), free);
  if (place == directory.end()) return KerfTablesError::kNoRoom;
  const Entry before = *place;
  *place = {static_cast<std::uint8_t>(spare_bank()), static_cast<std::uint16_t>(size_)};
  if (!save_directory(directory)) return KerfTablesError::kStoreFailed;
  size_ = 0;
  if (before.bytes != 0) forget_parts(before.bank);
  return std::nullopt;
}

/// Returns the first bank that is not in the directory. At least one bank is always free.
std::size_t KerfTables::spare_bank() const {
  std::array<bool, kBanks> taken{};
  for (const Entry& entry : load_directory()) {
    if (entry.bytes != 0) taken[entry.bank] = true;
  }
  return static_cast<std::size_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
}

/// Erases the parts of a bank to free their space in the store. Failures are ignored, because these
/// parts are never read.
void KerfTables::forget_parts(std::size_t bank) {
  for (std::size_t part = 0; part < kMaxParts; ++part) {
    PartBytes record{};
    const std::uint16_t number = part_record(bank, part);
    if (store_.load(number, record) > 0) static_cast<void>(store_.save(number, {}));
  }
}

std::optional<kerf::TableFault> KerfTables::read(const Entry& entry) {
  ++revision_;
  StoredImage image{store_, entry.bank, entry.bytes};
  return kerf::read_image(image, table_);
}

KerfTables::Directory KerfTables::load_directory() const {
  PartBytes record{};
  const std::size_t size = store_.load(kKerfDirectory, record);
  Directory directory{};
  if (size != kMaxStored * kEntryBytes) return directory;
  for (std::size_t i = 0; i < kMaxStored; ++i) {
    const auto bytes = std::span{record}.subspan(i * kEntryBytes);
    const auto low = std::to_integer<std::uint16_t>(bytes[1]);
    const auto high = std::to_integer<std::uint16_t>(bytes[2]);
    const Entry entry{std::to_integer<std::uint8_t>(bytes[0]),
                      static_cast<std::uint16_t>(low | (high << 8))};
    if (entry.bank < kBanks && entry.bytes <= kerf::table_image::kMaxBytes) directory[i] = entry;
  }
  return directory;
}

bool KerfTables::save_directory(const Directory& directory) {
  ++revision_;
  std::array<std::byte, kMaxStored * kEntryBytes> record{};
  bool any = false;
  for (std::size_t i = 0; i < kMaxStored; ++i) {
    const Entry& entry = directory[i];
    any = any || entry.bytes != 0;
    record[i * kEntryBytes] = static_cast<std::byte>(entry.bank);
    record[i * kEntryBytes + 1] = static_cast<std::byte>(entry.bytes);
    record[i * kEntryBytes + 2] = static_cast<std::byte>(entry.bytes >> 8);
  }
  return store_.save(kKerfDirectory,
                     any ? std::span<const std::byte>{record} : std::span<const std::byte>{});
}

bool KerfTables::is_named(const Entry& entry, std::string_view name) const {
  if (entry.bytes == 0) return false;
  PartBytes part{};
  const std::size_t size = store_.load(part_record(entry.bank, 0), part);
  return size >= kerf::table_image::kHeadBytes && kerf::name_in_image(part) == name;
}

std::size_t KerfTables::stored() const {
  const Directory directory = load_directory();
  return static_cast<std::size_t>(std::count_if(
      directory.begin(), directory.end(), [](const Entry& entry) { return entry.bytes != 0; }));
}

std::size_t KerfTables::count() const { return built_in() + stored(); }

KerfTables::Entry KerfTables::entry_of(std::size_t index) const {
  std::size_t number = built_in();
  for (const Entry& entry : load_directory()) {
    if (entry.bytes != 0 && number++ == index) return entry;
  }
  return {};
}

Result<kerf::TableView<float>, KerfTablesError> KerfTables::table(std::size_t index) {
  if (index < built_in()) return kBuiltInTables[index];
  if (read(entry_of(index))) return KerfTablesError::kDamaged;
  return table_.view();
}

Result<std::size_t, KerfTablesError> KerfTables::find(std::string_view name) const {
  for (std::size_t i = 0; i < kBuiltInTables.size(); ++i) {
    if (kBuiltInTables[i].name == name) return i;
  }
  std::size_t index = built_in();
  for (const Entry& entry : load_directory()) {
    if (entry.bytes == 0) continue;
    if (is_named(entry, name)) return index;
    ++index;
  }
  return KerfTablesError::kNoSuchTable;
}

std::size_t KerfTables::read_part(std::size_t index,
                                  std::size_t part,
                                  std::span<std::byte, kPartBytes> into) const {
  const Entry entry = entry_of(index);
  if (part >= parts_of(entry.bytes)) return 0;
  return std::min(store_.load(part_record(entry.bank, part), into), into.size());
}

std::optional<KerfTablesError> KerfTables::forget(std::string_view name) {
  if (is_built_in(name)) return KerfTablesError::kBuiltIn;
  size_ = 0;  // spare_bank() may return another bank now, which lacks the parts received so far.
  Directory directory = load_directory();
  for (Entry& entry : directory) {
    if (!is_named(entry, name)) continue;
    const std::size_t bank = entry.bank;
    entry = {};
    if (!save_directory(directory)) return KerfTablesError::kStoreFailed;
    forget_parts(bank);
    return std::nullopt;
  }
  return KerfTablesError::kNoSuchTable;
}

bool KerfTables::forget_all() {
  size_ = 0;
  if (!save_directory({})) return false;
  for (std::size_t bank = 0; bank < kBanks; ++bank) forget_parts(bank);
  return true;
}

}  // namespace cnc
