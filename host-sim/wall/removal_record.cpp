#include "host-sim/wall/removal_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host-sim/surface/refusal.hpp"

namespace sim::wall {
namespace {

constexpr const char* kForm =
    R"(give {"passes": [{"power_w": 10, "feed_mm_min": 600, "depth_mm": 0.01}, …]})";
/// Number of seconds in a minute, to convert W / (mm/min) to J/mm.
constexpr double kMinute = 60.0;

/// Returns the value of `key` in a pass. Throws std::invalid_argument unless it is a number > 0.
double value_of(const nlohmann::json& pass, const char* key, const std::string& name) {
  const auto found = pass.is_object() ? pass.find(key) : pass.end();
  if (!pass.is_object() || found == pass.end() || !found->is_number() ||
      !(found->get<double>() > 0.0 && found->get<double>() < 1.0e9)) {
    surface::refuse(name, 0, fmt::format("a pass has no `{}` above 0", key), kForm);
  }
  return found->get<double>();
}

}  // namespace

RemovalRecord::RemovalRecord(std::string_view json, const std::string& name) : name_{name} {
  const nlohmann::json record = nlohmann::json::parse(json, nullptr, false);
  if (!record.is_object() || !record.contains("passes") || !record["passes"].is_array()) {
    surface::refuse(name, 0, "is not a record of passes", kForm);
  }
  std::map<double, std::pair<double, int>> sums;
  for (const nlohmann::json& pass : record["passes"]) {
    const double energy =
        value_of(pass, "power_w", name) * kMinute / value_of(pass, "feed_mm_min", name);
    auto& [sum, count] = sums[energy];
    sum += value_of(pass, "depth_mm", name);
    ++count;
  }
  if (sums.size() < 2) {
    surface::refuse(name, 0, "has passes of fewer than two energies", "measure another energy");
  }
  for (const auto& [energy, sum] : sums) depths_.emplace_back(energy, sum.first / sum.second);
}

double RemovalRecord::depth_of_pass(double power_w, double feed_mm_min) const {
  const double energy = power_w * kMinute / feed_mm_min;
  const double least = depths_.front().first;
  const double most = depths_.back().first;
  if (!(energy >= least && energy <= most)) {
    throw std::invalid_argument(
        fmt::format("{}: {:g} W at {:g} mm/min are {:g} J/mm, but only {:g} to {:g} were measured; "
                    "change --power or --feed, or measure more energies",
                    name_,
                    power_w,
                    feed_mm_min,
                    energy,
                    least,
                    most));
  }
  const auto above =
      std::ranges::find_if(depths_, [energy](const auto& entry) { return entry.first >= energy; });
  if (above->first == energy) return above->second;
  const auto& below = *(above - 1);
  const double share = (energy - below.first) / (above->first - below.first);
  return below.second + share * (above->second - below.second);
}

}  // namespace sim::wall
