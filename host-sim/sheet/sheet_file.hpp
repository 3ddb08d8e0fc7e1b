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

/// The position of a copy of a part. The copy is first mirrored (x becomes −x), then turned, then
/// moved. `at_mm` is the position of the drawing's origin on the sheet.
struct Placing {
  Place at_mm{0.0, 0.0};
  double angle_deg = 0.0;  ///< Angle of rotation, counter-clockwise.
  bool mirror = false;

  [[nodiscard]] bool operator==(const Placing& other) const = default;
};

/// A part of a sheet: its drawing, and the positions of its copies.
struct SheetPart {
  std::string name;
  /// Name of the drawing, as the sheet file has it, relative to the folder of this file.
  std::string drawing;
  std::vector<Placing> places;
  /// Names of the parts that must be cut before this part, with all their copies.
  std::vector<std::string> after{};
  /// Rank in the order of cutting, above the ranks of the parts in `after`.
  std::size_t turn = 0;
  std::string pointer{};  ///< JSON pointer to the part for messages, such as `/parts/3`.
};

/// A sheet of stock and the parts that are cut from it.
struct Sheet {
  std::string file;
  std::optional<Stock> stock{};
  std::vector<SheetPart> parts;
  bool locked = false;  ///< Whether the copies must be cut in the order of the file.
  std::vector<drawing::Fault> faults{};
};

inline constexpr std::size_t kMaxParts = 10'000;
/// Greatest number of copies of all parts together.
inline constexpr std::size_t kMaxCopies = 100'000;
inline constexpr double kMaxSheetMm = 1.0e5;  ///< Greatest width and height of stock.
/// Greatest absolute value of a coordinate of a position.
inline constexpr double kMaxPlaceMm = 1.0e6;

/// Returns whether a text is meant as a sheet file: it begins with `{` and contains the key
/// `kerfline_sheet`.
[[nodiscard]] bool is_sheet(std::string_view text);

/// Reads a sheet file, in the format that docs/sheets.md describes. Does not throw, whatever the
/// text contains. Each fault gives its position as a JSON pointer, or as line and column if the
/// text is not JSON. Parts with faults are left out.
[[nodiscard]] Sheet read_sheet(const std::string& file, const std::string& text);

/// Returns the text of a sheet file that lists the position of each copy. read_sheet() reads the
/// same numbers from it.
[[nodiscard]] std::string text_of(const Sheet& sheet);

}  // namespace sim::sheet
