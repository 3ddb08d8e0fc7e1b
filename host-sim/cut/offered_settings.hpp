#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Settings that a project of a laser program has for a layer, in the words of a rule.
struct OfferedValues {
  std::vector<std::pair<std::string, std::string>> values{};  ///< For set(), `kind` first.
  std::vector<std::string> unusable{};  ///< Reasons why others of the project are not there.
};

/// Returns the settings that a project offers: Cut is kind=cut, Scan kind=fill, Image
/// kind=image, Tool kind=skip;
/// power is a share, speed a feed in mm/min, priority a rank. A layer of another mode has its rank
/// only, since its power and speed are of an operation that is not here.
[[nodiscard]] OfferedValues values_of(const drawing::OfferedSettings& offered);

}  // namespace sim::cut
