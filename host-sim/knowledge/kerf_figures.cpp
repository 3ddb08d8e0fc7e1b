#include "host-sim/knowledge/kerf_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "host-sim/plot/chart.hpp"

namespace sim {
namespace {

namespace kerf = cnc::kerf;

constexpr int kLineParts = 60;
constexpr const char* kKerfLabel = "kerf in mm, bands hold 95 % of cuts";

/// Returns the value that divides a window in equal parts: its start for `part` 0, its end for the
/// last part.
std::uint32_t part_of(const kerf::Window& window, int part) {
  const auto span = static_cast<std::uint64_t>(window.most - window.least);
  return window.least +
         static_cast<std::uint32_t>(span * static_cast<std::uint64_t>(part) / kLineParts);
}

/// Returns the powers that were cut at the thickness, or at its neighbours.
std::set<std::uint32_t> powers_around(const OwnedKerfTable<double>& table,
                                      std::uint32_t thickness_um) {
  const auto permissible = kerf::permissible_powers(table.view(), thickness_um);
  if (!permissible.ok()) {
    throw std::invalid_argument(table.name + ": " +
                                describe(permissible.error(), {thickness_um, 0, 0}));
  }
  const auto around =
      kerf::detail::neighbours(table.view().rows, &kerf::Row<double>::thickness_um, thickness_um);
  std::set<std::uint32_t> powers;
  for (const std::size_t row : {around.low, around.high}) {
    for (const kerf::Band& band : table.view().bands_of(table.rows[row])) {
      if (permissible.value().holds(band.power_mw)) powers.insert(band.power_mw);
    }
  }
  return powers;
}

/// Appends a point of the law to `series`, with the interval of single cuts around it.
void add_point(ChartSeries& series,
               const MaterialRecord& record,
               const kerf::Condition& at,
               double x) {
  const auto found = predict(record, at);
  if (!found.ok()) return;
  series.line.push_back({x, found.value().kerf_mm});
  series.half_bands.push_back(found.value().half_interval_mm);
}

void sort_by_x(ChartSeries& series) {
  std::vector<std::pair<ChartPoint, double>> points;
  for (std::size_t i = 0; i < series.line.size(); ++i) {
    points.emplace_back(series.line[i], series.half_bands[i]);
  }
  std::ranges::sort(points, {}, [](const auto& point) { return point.first.x; });
  for (std::size_t i = 0; i < points.size(); ++i) {
    series.line[i] = points[i].first;
    series.half_bands[i] = points[i].second;
  }
}

ChartPanel over_speed(const MaterialRecord& record,
                      std::uint32_t thickness_um,
                      std::span<const Experiment> cuts) {
  const OwnedKerfTable<double> table = table_of<double>(record);
  ChartPanel panel{.x_label = "speed in mm/min", .y_label = kKerfLabel};
  for (const std::uint32_t power : powers_around(table, thickness_um)) {
    ChartSeries series{.label = fmt::format("{:g} W", from_thousandths(power))};
    const auto speeds = kerf::permissible_speeds(table.view(), thickness_um, power);
    for (int part = 0; speeds.ok() && part <= kLineParts; ++part) {
      const std::uint32_t speed = part_of(speeds.value(), part);
      add_point(series, record, {thickness_um, power, speed}, from_thousandths(speed));
    }
    for (const Experiment& cut : cuts) {
      const kerf::Condition& at = cut.condition;
      if (!cut.accepted() || at.thickness_um != thickness_um || at.power_mw != power) continue;
      series.dots.push_back({from_thousandths(at.speed_um_min), cut.kerf_mm()});
    }
    panel.series.push_back(std::move(series));
  }
  return panel;
}

/// Returns a few round speeds between the least and the greatest permissible speed at a thickness.
std::set<std::uint32_t> sample_speeds(const OwnedKerfTable<double>& table,
                                      std::uint32_t thickness_um) {
  kerf::Window all{kerf::kMaxSpeedUmMin, 0};
  for (const std::uint32_t power : powers_around(table, thickness_um)) {
    const auto speeds = kerf::permissible_speeds(table.view(), thickness_um, power);
    if (!speeds.ok()) continue;
    all = {std::min(all.least, speeds.value().least), std::max(all.most, speeds.value().most)};
  }
  std::set<std::uint32_t> speeds;
  constexpr std::uint32_t kParts = 4;
  for (std::uint32_t i = 0; all.least <= all.most && i <= kParts; ++i) {
    speeds.insert(all.least + (all.most - all.least) / kParts * i);
  }
  return speeds;
}

ChartPanel over_power(const MaterialRecord& record, std::uint32_t thickness_um) {
  const OwnedKerfTable<double> table = table_of<double>(record);
  ChartPanel panel{.x_label = "power in W", .y_label = kKerfLabel};
  const kerf::Window powers = kerf::permissible_powers(table.view(), thickness_um).value();
  for (const std::uint32_t speed : sample_speeds(table, thickness_um)) {
    ChartSeries series{.label = fmt::format("{:g} mm/min", from_thousandths(speed))};
    for (int part = 0; part <= kLineParts; ++part) {
      const std::uint32_t power = part_of(powers, part);
      add_point(series, record, {thickness_um, power, speed}, from_thousandths(power));
    }
    if (!series.line.empty()) panel.series.push_back(std::move(series));
  }
  return panel;
}

std::string origin_of(const MaterialRecord& record) {
  return fmt::format("{}  ·  Q in {}  ·  {}",
                     record.laser.empty() ? "a laser without a name" : record.laser,
                     name_of(record.unit),
                     record.provenance);
}

}  // namespace

std::string draw_kerf_over_speed(const MaterialRecord& record,
                                 std::uint32_t thickness_um,
                                 std::span<const Experiment> cuts) {
  return draw_chart(
      fmt::format(
          "{}, {:g} mm: kerf over speed and power", record.name, from_thousandths(thickness_um)),
      origin_of(record),
      {over_speed(record, thickness_um, cuts), over_power(record, thickness_um)});
}

std::string draw_kerf_over_heat(const MaterialRecord& record, std::span<const Experiment> cuts) {
  ChartPanel panel{.x_label = fmt::format("effective heat input Q in {}", name_of(record.unit)),
                   .y_label = kKerfLabel};
  for (const ThicknessRecord& row : record.thicknesses) {
    ChartSeries series{.label = fmt::format("{:g} mm", from_thousandths(row.thickness_um))};
    const auto add = [&](std::uint32_t power, std::uint32_t speed) {
      add_point(series,
                record,
                {row.thickness_um, power, speed},
                kerf::heat_input<double>(record.unit, power, speed));
    };
    for (const PowerRecord& power : row.powers) {
      add(power.power_mw, power.speeds_um_min.least);
      add(power.power_mw, power.speeds_um_min.most);
      for (const kerf::Point& point : power.points) add(power.power_mw, point.speed_um_min);
    }
    sort_by_x(series);
    for (const Experiment& cut : cuts) {
      const kerf::Condition& at = cut.condition;
      if (!cut.accepted() || at.thickness_um != row.thickness_um) continue;
      series.dots.push_back(
          {kerf::heat_input<double>(record.unit, at.power_mw, at.speed_um_min), cut.kerf_mm()});
    }
    panel.series.push_back(std::move(series));
  }
  return draw_chart(
      fmt::format("{}: kerf over effective heat input", record.name), origin_of(record), {panel});
}

}  // namespace sim
