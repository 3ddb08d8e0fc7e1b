#include <algorithm>
#include <array>

#include "firmware/machine/setting_rows.hpp"
#include "firmware/machine/settings.hpp"

namespace cnc {
namespace {

using setting_rows::kRows;

/// Returns the number of settings in a row: one, or one for each axis that shares it.
constexpr std::size_t settings_of(std::size_t row) {
  const SettingInfo& first = kRows[row];
  if (first.group < SettingGroup::kX) return 1;
  const auto axes =
      static_cast<std::size_t>(SettingGroup::kC) - static_cast<std::size_t>(first.group) + 1U;
  if (row + 1 == kRows.size()) return axes;
  return std::min<std::size_t>(axes, kRows[row + 1].number - first.number);
}

constexpr std::size_t kCount = [] {
  std::size_t count = 0;
  for (std::size_t row = 0; row < kRows.size(); ++row) count += settings_of(row);
  return count;
}();
static_assert(kCount <= Settings::kMaxSettings);

/// Row of each setting.
constexpr std::array<std::uint8_t, kCount> kRowOf = [] {
  std::array<std::uint8_t, kCount> row_of{};
  std::size_t index = 0;
  for (std::size_t row = 0; row < kRows.size(); ++row) {
    for (std::size_t i = 0; i < settings_of(row); ++i) {
      row_of[index++] = static_cast<std::uint8_t>(row);
    }
  }
  return row_of;
}();

/// Returns the number of settings before the setting `index` in the same row.
constexpr std::size_t place_in_row(std::size_t index) {
  std::size_t place = 0;
  while (place < index && kRowOf[index - place - 1] == kRowOf[index]) ++place;
  return place;
}

constexpr std::uint16_t number_of(std::size_t index) {
  return static_cast<std::uint16_t>(kRows[kRowOf[index]].number + place_in_row(index));
}

constexpr bool are_sorted() {
  for (std::size_t i = 1; i < kCount; ++i) {
    if (number_of(i - 1) >= number_of(i)) return false;
  }
  return true;
}
static_assert(are_sorted());

/// Settings are read for every line, so a lookup takes two steps and no search. The first step
/// finds the page, which has eight numbers; the second step finds the index within the page. All
/// pages without settings are one shared page.
constexpr std::size_t kPageBits = 3;
constexpr std::size_t kPageSize = std::size_t{1} << kPageBits;
constexpr std::size_t kPages = (number_of(kCount - 1) >> kPageBits) + 1U;

constexpr bool has_page_before(std::size_t index) {
  return index > 0 && number_of(index - 1) >> kPageBits == number_of(index) >> kPageBits;
}

constexpr std::size_t kUsedPages = [] {
  std::size_t used = 1;
  for (std::size_t i = 0; i < kCount; ++i) used += has_page_before(i) ? 0 : 1;
  return used;
}();

struct PageTable {
  std::array<std::uint8_t, kPages> pages{};  ///< Page 0 is the shared page without settings.
  std::array<std::array<std::uint8_t, kPageSize>, kUsedPages> indices{};
};

constexpr PageTable kPageTable = [] {
  PageTable table;
  for (auto& page : table.indices) page.fill(kCount);
  std::size_t used = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    if (!has_page_before(i)) ++used;
    const std::uint16_t number = number_of(i);
    table.pages[number >> kPageBits] = static_cast<std::uint8_t>(used);
    table.indices[used][number % kPageSize] = static_cast<std::uint8_t>(i);
  }
  return table;
}();

}  // namespace

std::size_t SettingTable::size() { return kCount; }

SettingInfo SettingTable::operator[](std::size_t index) const {
  SettingInfo info = kRows[kRowOf[index]];
  const std::size_t place = place_in_row(index);
  info.number = static_cast<std::uint16_t>(info.number + place);
  info.group = static_cast<SettingGroup>(static_cast<std::size_t>(info.group) + place);
  return info;
}

std::size_t setting_index(std::uint16_t number) {
  const std::size_t page = number >> kPageBits;
  return page < kPages ? kPageTable.indices[kPageTable.pages[page]][number % kPageSize] : kCount;
}

}  // namespace cnc
