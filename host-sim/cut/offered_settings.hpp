#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Settings that the project file of a laser program offers for a layer, as keys and values of a
/// rule.
struct OfferedValues {
  /// Keys and values for set(), `kind` first.
  std::vector<std::pair<std::string, std::string>> values{};
  /// Reasons why further settings of the project are not used.
  std::vector<std::string> unusable{};
};

/// Returns the settings that a project offers for a layer. The mode Cut becomes kind=cut, Scan
/// kind=fill, Image kind=image, and Tool kind=skip. Power becomes a share, speed a feed in mm/min,
/// and priority a rank. A layer of any other mode keeps only its rank, because its power and speed
/// belong to an operation that does not exist here.
[[nodiscard]] OfferedValues values_of(const drawing::OfferedSettings& offered);

}  // namespace sim::cut
