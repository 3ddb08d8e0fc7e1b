#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::drawing {

/// One cutting setting of a library of materials. A member is empty if the library gives no value
/// for it, or a value that is out of range.
struct LibraryEntry {
  std::string material{};
  std::string description{};
  /// Thickness of the material, mm: above 0, up to kGreatestThicknessMm.
  std::optional<double> thickness_mm{};
  OfferedSettings settings{};
  std::size_t line = 0;    ///< Line of the entry in the file, from 1.
  std::size_t column = 0;  ///< Column of the entry in that line, from 1.
};

/// A library of materials of LightBurn, a `.clb` file.
struct MaterialLibrary {
  std::string name{};  ///< Name that LightBurn displays; may be empty.
  std::vector<LibraryEntry> entries{};
  /// Notes on entries that are left out, each as `FILE:LINE:COLUMN: omission and reason`.
  std::vector<std::string> notes{};
};

inline constexpr double kGreatestThicknessMm = 100.0;
inline constexpr std::size_t kMaxLibraryEntries = 20'000;
/// Greatest length of the name of a material, in bytes. Materials with longer names are left out.
inline constexpr std::size_t kLongestMaterialName = 100;

/// Reads a library of materials. Its elements `Material` contain elements `Entry`, which contain
/// elements `CutSetting`. Throws std::invalid_argument `FILE:LINE:COLUMN: reason; remedy` if the
/// text is no library, is broken, or has more than kMaxLibraryEntries entries.
[[nodiscard]] MaterialLibrary read_clb(const std::string& text, const std::string& file);

}  // namespace sim::drawing
