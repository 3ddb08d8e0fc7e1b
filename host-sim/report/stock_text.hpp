#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/stock/stock_report.hpp"

namespace sim {

/// `flat 6 mm`, `bull nose 6 mm with corners of 1 mm`.
[[nodiscard]] std::string to_string(const stock::Cutter& cutter);

/// The element `stock` of a report. Bounds of a figure are `least` and `most`.
[[nodiscard]] nlohmann::ordered_json to_json(const stock::StockReport& report);

/// Name and value of each fact for people.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> stock_facts(
    const stock::StockReport& report);

/// Returns the same of a comparison with a surface: gouge, rest, and the worst places.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> surface_facts(
    const stock::SurfaceFigures& figures);

/// A warning for each of the first lines whose rapids cut stock, one for the others, and one for a
/// pocket or a surface that is gouged.
[[nodiscard]] std::vector<std::string> warnings_of(const stock::StockReport& report,
                                                   const std::string& file);

}  // namespace sim
