#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Settings for a layer from the project file of a laser program, written as key and value of a
/// rule.
struct OfferedValues {
  /// Keys and values for set(), with `kind` first.
  std::vector<std::pair<std::string, std::string>> values{};
  std::vector<std::string> unusable{};  ///< Reasons why other settings of the project are not used.
};

/// Returns the settings that a project offers. The mode Cut becomes kind=cut, Scan kind=fill, Image
/// kind=image, and Tool kind=skip. Power becomes a share, speed a feed in mm/min, and priority a
/// rank. A layer of another mode keeps only its rank, since its power and speed belong to an
/// operation that does not exist here.
[[nodiscard]] OfferedValues values_of(const drawing::OfferedSettings& offered);

}  // namespace sim::cut
