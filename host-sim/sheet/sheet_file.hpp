#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::sheet {

using drawing::Place;
using drawing::Stock;

/// Where a copy of a part lies: mirrored first (x becomes −x), then turned, then moved. The
/// coordinates are those of the drawing's own origin on the sheet.
struct Placing {
  Place at_mm{0.0, 0.0};
  double angle_deg = 0.0;  ///< Counter-clockwise.
  bool mirror = false;

  [[nodiscard]] bool operator==(const Placing& other) const = default;
};

/// A drawing and its copies.
struct SheetPart {
  std::string name;
  std::string drawing;  ///< As written: relative to the folder of the sheet file.
  std::vector<Placing> places;
  std::vector<std::string> after{};  ///< Names of parts of which all copies are cut before.
  std::size_t turn = 0;              ///< Greater than those of the parts that come before.
  std::string pointer{};             ///< Place in the file, for messages: `/parts/3`.
};

/// A sheet of stock and the parts that are cut from it.
struct Sheet {
  std::string file;
  std::optional<Stock> stock{};
  std::vector<SheetPart> parts;
  bool locked = false;  ///< Copies are cut in the order in which the file lists them.
  std::vector<drawing::Fault> faults{};
};

inline constexpr std::size_t kMaxParts = 10'000;
inline constexpr std::size_t kMaxCopies = 100'000;  ///< Of all parts together.
inline constexpr double kMaxSheetMm = 1.0e5;        ///< Width and height of stock.
inline constexpr double kMaxPlaceMm = 1.0e6;        ///< Distance of a place from zero, either way.

/// Returns whether the text is meant as a sheet file: a JSON object with the key `kerfline_sheet`.
[[nodiscard]] bool is_sheet(std::string_view text);

/// Reads a sheet file; docs/sheets.md has its format. Never throws for what the text says: each
/// fault names its place as a JSON pointer, or as line and column where the text is no JSON. Parts
/// with faults are left out.
[[nodiscard]] Sheet read_sheet(const std::string& file, const std::string& text);

/// Returns the text of a sheet file with all places written out, which read_sheet() reads back to
/// the same numbers.
[[nodiscard]] std::string text_of(const Sheet& sheet);

}  // namespace sim::sheet
