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
/// moved. The coordinates are those that the drawing's origin has on the sheet.
struct Placing {
  Place at_mm{0.0, 0.0};
  double angle_deg = 0.0;  ///< Angle of the turn, counter-clockwise.
  bool mirror = false;

  [[nodiscard]] bool operator==(const Placing& other) const = default;
};

/// A drawing and its copies.
struct SheetPart {
  std::string name;
  /// Name of the drawing as written, relative to the folder of the sheet file.
  std::string drawing;
  std::vector<Placing> places;
  /// Names of parts. All copies of these parts are cut before this part.
  std::vector<std::string> after{};
  std::size_t turn = 0;   ///< Turn of the part, greater than the turns of the parts in `after`.
  std::string pointer{};  ///< JSON pointer to the part, for messages: `/parts/3`.
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
/// Greatest number of copies of all parts together.
inline constexpr std::size_t kMaxCopies = 100'000;
inline constexpr double kMaxSheetMm = 1.0e5;  ///< Greatest width and height of stock.
/// Greatest distance of a position from zero, in either direction.
inline constexpr double kMaxPlaceMm = 1.0e6;

/// Returns whether a text is meant as a sheet file: a JSON object with the key `kerfline_sheet`.
[[nodiscard]] bool is_sheet(std::string_view text);

/// Reads a sheet file. docs/sheets.md describes the format. Never throws because of the content of
/// the text. Each fault gives its position as a JSON pointer, or as line and column if the text is
/// no JSON. Parts with faults are left out.
[[nodiscard]] Sheet read_sheet(const std::string& file, const std::string& text);

/// Returns the text of a sheet file with all positions written out. read_sheet() reads back the
/// same numbers.
[[nodiscard]] std::string text_of(const Sheet& sheet);

}  // namespace sim::sheet
