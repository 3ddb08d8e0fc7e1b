#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::drawing {

/// One setting of a library of materials. A member is empty where the library gives no value, or a
/// value out of its range.
struct LibraryEntry {
  std::string material{};
  std::string description{};
  std::optional<double> thickness_mm{};  ///< Thickness above 0, up to kGreatestThicknessMm.
  OfferedSettings settings{};
  std::size_t line = 0;    ///< Line of the entry in the file, from 1.
  std::size_t column = 0;  ///< Column of the entry in that line, from 1.
};

/// A library of materials of LightBurn, a `.clb` file.
struct MaterialLibrary {
  std::string name{};  ///< Name that LightBurn displays; may be empty.
  std::vector<LibraryEntry> entries{};
  std::vector<std::string> notes{};  ///< `FILE:LINE:COLUMN: omission and reason`.
};

inline constexpr double kGreatestThicknessMm = 100.0;
inline constexpr std::size_t kMaxLibraryEntries = 20'000;
/// Greatest length of a material's name, in bytes. Materials with longer names are left out.
inline constexpr std::size_t kLongestMaterialName = 100;

/// Reads a library: elements `Material` that contain `Entry`, which contain `CutSetting`. Throws
/// std::invalid_argument `FILE:LINE:COLUMN: reason; remedy` if the text is no library, is broken,
/// or has more than kMaxLibraryEntries.
[[nodiscard]] MaterialLibrary read_clb(const std::string& text, const std::string& file);

}  // namespace sim::drawing
