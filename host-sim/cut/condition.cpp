#include "host-sim/cut/condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "host-sim/knowledge/experiment.hpp"

namespace sim::cut {
namespace {

using cnc::kerf::Window;

std::invalid_argument refusal(const MaterialRecord& record, const std::string& reason) {
  return std::invalid_argument(
      fmt::format("{}: {}; `kerfline kerf advise` lists what is permissible", record.name, reason));
}

/// Returns the powers for which the record has rows, in ascending order. Other powers need not be
/// tried, because a power between two rows permits no other speeds.
std::vector<std::uint32_t> powers_of(const OwnedKerfTable<double>& table) {
  std::vector<std::uint32_t> powers;
  for (const cnc::kerf::Band& band : table.bands) powers.push_back(band.power_mw);
  std::sort(powers.begin(), powers.end());
  powers.erase(std::unique(powers.begin(), powers.end()), powers.end());
  return powers;
}

/// Returns the lowest power that permits the required speed. Without a required speed, returns the
/// lowest power that permits the highest speed. Returns 0 if no power permits the speed.
std::uint32_t choose_power(const OwnedKerfTable<double>& table,
                           std::uint32_t thickness_um,
                           std::optional<std::uint32_t> speed_um_min,
                           std::uint32_t max_power_mw) {
  std::uint32_t best = 0;
  std::uint32_t fastest = 0;
  for (const std::uint32_t power : powers_of(table)) {
    if (power > max_power_mw) break;  // The powers are in ascending order.
    const auto speeds = cnc::kerf::permissible_speeds(table.view(), thickness_um, power);
    if (!speeds.ok()) continue;
    if (speed_um_min) {
      if (speeds.value().holds(*speed_um_min)) return power;
    } else if (speeds.value().most > fastest) {
      best = power;
      fastest = speeds.value().most;
    }
  }
  return best;
}

std::string speeds_at(const OwnedKerfTable<double>& table, std::uint32_t thickness_um) {
  std::string text;
  for (const std::uint32_t power : powers_of(table)) {
    const auto speeds = cnc::kerf::permissible_speeds(table.view(), thickness_um, power);
    if (!speeds.ok()) continue;
    text += fmt::format("{}{:g} to {:g} mm/min at {:g} W",
                        text.empty() ? "" : ", ",
                        from_thousandths(speeds.value().least),
                        from_thousandths(speeds.value().most),
                        from_thousandths(power));
  }
  return text;
}

}  // namespace

Condition choose(const MaterialRecord& record,
                 std::uint32_t thickness_um,
                 std::optional<std::uint32_t> power_mw,
                 std::optional<std::uint32_t> speed_um_min,
                 std::uint32_t max_power_mw) {
  const OwnedKerfTable<double> table = table_of<double>(record);
  cnc::kerf::Condition cut{thickness_um, power_mw.value_or(0), speed_um_min.value_or(0)};
  const auto powers = cnc::kerf::permissible_powers(table.view(), thickness_um);
  if (!powers.ok()) throw refusal(record, describe(powers.error(), cut));
  if (!power_mw) cut.power_mw = choose_power(table, thickness_um, speed_um_min, max_power_mw);
  if (cut.power_mw == 0) {
    const std::string limit = max_power_mw < cnc::kerf::kMaxPowerMw
                                  ? fmt::format(" up to the laser's {:g} W (--full-power)",
                                                from_thousandths(max_power_mw))
                                  : "";
    const std::string speed =
        speed_um_min ? fmt::format(" for {:g} mm/min", from_thousandths(*speed_um_min)) : "";
    throw refusal(record,
                  fmt::format("no power{} is permissible{}; permissible are {}",
                              limit,
                              speed,
                              speeds_at(table, thickness_um)));
  }
  const auto speeds = cnc::kerf::permissible_speeds(table.view(), thickness_um, cut.power_mw);
  if (!speeds.ok()) throw refusal(record, describe(speeds.error(), cut));
  if (!speed_um_min) cut.speed_um_min = speeds.value().most;
  const auto found = predict(record, cut);
  if (!found.ok()) throw refusal(record, describe(found.error(), cut));
  return {cut, found.value().kerf_mm, found.value().half_interval_mm};
}

Condition engraving(const Condition& cut,
                    double share,
                    std::optional<std::uint32_t> power_mw,
                    std::optional<std::uint32_t> speed_um_min) {
  Condition engraved{cut.cut};
  engraved.cut.power_mw =
      power_mw.value_or(to_thousandths(share * from_thousandths(cut.cut.power_mw)));
  engraved.cut.speed_um_min = speed_um_min.value_or(cut.cut.speed_um_min);
  return engraved;
}

std::uint32_t greatest_power(const MaterialRecord& record, std::uint32_t thickness_um) {
  const OwnedKerfTable<double> table = table_of<double>(record);
  const auto powers = cnc::kerf::permissible_powers(table.view(), thickness_um);
  return powers.ok() ? powers.value().most : 0;
}

}  // namespace sim::cut
