#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::drawing {

/// One setting of a library of materials. What the library does not say, or says out of its range,
/// is empty.
struct LibraryEntry {
  std::string material{};
  std::string description{};
  std::optional<double> thickness_mm{};  ///< Above 0, up to kGreatestThicknessMm.
  OfferedSettings settings{};
  std::size_t line = 0;    ///< From 1.
  std::size_t column = 0;  ///< From 1.
};

/// A library of materials of LightBurn, a `.clb` file.
struct MaterialLibrary {
  std::string name{};  ///< As it shows in the program; may be empty.
  std::vector<LibraryEntry> entries{};
  std::vector<std::string> notes{};  ///< `FILE:LINE:COLUMN: what is left out and why`.
};

inline constexpr double kGreatestThicknessMm = 100.0;
inline constexpr std::size_t kMostLibraryEntries = 20'000;
/// Longer names of materials are left out.
inline constexpr std::size_t kLongestMaterialName = 100;

/// Reads a library: `Material` with `Entry` with `CutSetting`. Throws std::invalid_argument
/// `FILE:LINE:COLUMN: reason; remedy` for a text that is no library, is broken, or has more than
/// kMostLibraryEntries.
[[nodiscard]] MaterialLibrary read_clb(const std::string& text, const std::string& file);

}  // namespace sim::drawing
