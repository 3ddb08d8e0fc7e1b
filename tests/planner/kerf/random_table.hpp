#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "planner/kerf/stored_table.hpp"
#include "planner/kerf/table_check.hpp"
#include "tests/support/random_source.hpp"

namespace cnc::kerf {

/// A table that owns its parts.
template <typename Real>
struct OwnedTable {
  std::string name = "random";
  HeatUnit unit = HeatUnit::kWattMinutesPerMillimetre;
  std::vector<Row<Real>> rows{};
  std::vector<Band> bands{};
  std::vector<Point> points{};

  [[nodiscard]] TableView<Real> view() const { return {name, unit, rows, bands, points}; }
};

inline OwnedTable<float> in_single(const OwnedTable<double>& table) {
  OwnedTable<float> single{table.name, table.unit, {}, table.bands, table.points};
  for (const Row<double>& row : table.rows) {
    single.rows.push_back(
        {row.thickness_um,
         {static_cast<float>(row.law.slope), static_cast<float>(row.law.intercept)},
         row.measured,
         row.first_band,
         row.bands});
  }
  return single;
}

/// Generates sound tables of any thickness, power and speed that fit into a controller.
class RandomTable {
 public:
  explicit RandomTable(proof::Random& random) : random_{random} {}

  OwnedTable<double> next() {
    OwnedTable<double> table;
    table.unit =
        random_.chance(0.5) ? HeatUnit::kWattMinutesPerMillimetre : HeatUnit::kJoulesPerMillimetre;
    const std::size_t rows = 1 + random_.below(StoredTable::kMaxRows);
    for (const std::uint32_t thickness : rising(rows, 1, kMaxThicknessUm)) {
      add_row(table, thickness);
    }
    return table;
  }

  /// Returns distinct numbers of any size in ascending order.
  std::vector<std::uint32_t> rising(std::size_t count, std::uint32_t least, std::uint32_t most) {
    std::vector<std::uint32_t> all;
    while (all.size() < count) {
      const auto one = static_cast<std::uint32_t>(random_.magnitude(least, most));
      if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
    }
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  void add_row(OwnedTable<double>& table, std::uint32_t thickness) {
    const std::size_t left = StoredTable::kMaxPoints - table.points.size();
    const bool measured = left >= 20 && random_.chance(0.4);
    Row<double> row{thickness,
                    {},
                    measured,
                    static_cast<std::uint16_t>(table.bands.size()),
                    static_cast<std::uint16_t>(1 + random_.below(5))};
    double min_heat = 1.0e30;
    double max_heat = 0.0;
    for (const std::uint32_t power : rising(row.bands, 100, kMaxPowerMw)) {
      const std::size_t count = 2 + (measured ? random_.below(3) : 0);
      const auto speeds = rising(count, kMinSpeedUmMin, kMaxSpeedUmMin);
      table.bands.push_back({power,
                             speeds.front(),
                             speeds.back(),
                             static_cast<std::uint16_t>(table.points.size()),
                             static_cast<std::uint16_t>(measured ? count : 0)});
      for (const std::uint32_t speed : speeds) {
        const auto heat = heat_input<double>(table.unit, power, speed);
        min_heat = std::min(min_heat, heat);
        max_heat = std::max(max_heat, heat);
        if (!measured) continue;
        table.points.push_back({speed, static_cast<std::uint32_t>(random_.between(1, 9.9e6))});
      }
    }
    // The widths at the ends of the heat range are arbitrary, or the width does not depend on the
    // heat.
    const double low = random_.between(0.001, 9.9);
    const double high = random_.between(0.001, 9.9);
    row.law.slope = (high - low) / (max_heat - min_heat);
    row.law.intercept = low - row.law.slope * min_heat;
    if (!(std::abs(row.law.intercept) <= 9.99)) row.law = {0.0, low};
    table.rows.push_back(row);
  }

  proof::Random& random_;
};

}  // namespace cnc::kerf
