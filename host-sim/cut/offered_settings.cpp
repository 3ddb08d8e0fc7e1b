#include "host-sim/cut/offered_settings.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "host-sim/cut/layer_settings.hpp"

namespace sim::cut {
namespace {

constexpr double kSecondsPerMinute = 60.0;

struct Mode {
  std::string_view of_project;
  std::string_view kind;
};

constexpr std::array<Mode, 4> kModes{
    {{"Cut", "cut"}, {"Scan", "fill"}, {"Image", "image"}, {"Tool", "skip"}}};

std::optional<std::string_view> kind_of(std::string_view mode) {
  for (const Mode& known : kModes) {
    if (known.of_project == mode) return known.kind;
  }
  return std::nullopt;
}

/// Adds a value, or the reason why set() refuses it.
void offer(OfferedValues& offered, std::string_view key, std::string value) {
  LayerSettings tried;
  try {
    set(tried, key, value);
  } catch (const std::invalid_argument& error) {
    offered.unusable.emplace_back(error.what());
    return;
  }
  offered.values.emplace_back(key, std::move(value));
}

void offer_number(OfferedValues& offered,
                  std::string_view key,
                  const std::optional<double>& value,
                  std::string_view unit = {}) {
  if (value) offer(offered, key, fmt::format("{:.10g}{}", *value, unit));
}

std::optional<double> times(const std::optional<double>& value, double factor) {
  if (!value) return std::nullopt;
  return *value * factor;
}

void offer_picture(OfferedValues& found, const drawing::OfferedSettings& offered) {
  if (!offered.shading.empty()) {
    offer(found, "shading", offered.shading == "grayscale" ? "grey" : offered.shading);
  }
  if (offered.min_power_share.value_or(0.0) > 0.0) {
    offer_number(found, "min-power", times(offered.min_power_share, 100.0), "%");
  }
}

}  // namespace

OfferedValues values_of(const drawing::OfferedSettings& offered) {
  OfferedValues found;
  const auto kind = kind_of(offered.kind);
  if (kind) {
    offer(found, "kind", std::string{*kind});
  } else {
    found.unusable.push_back(
        fmt::format("the mode {:.40} is none of Cut, Scan, Image and Tool; set its kind with kind=",
                    offered.kind.empty() ? "without a name" : offered.kind));
  }
  if (kind && kind != "skip") {
    offer_number(found, "power", times(offered.power_share, 100.0), "%");
    offer_number(found, "feed", times(offered.speed_mm_s, kSecondsPerMinute));
    if (offered.passes) offer(found, "passes", fmt::format("{}", *offered.passes));
    if (kind == "fill" || kind == "image") offer_number(found, "interval", offered.interval_mm);
    if (kind == "fill") offer_number(found, "angle", offered.angle_deg);
    if (kind == "image") offer_picture(found, offered);
  }
  if (offered.priority && kind != "skip") {
    offer(found, "rank", fmt::format("{}", *offered.priority));
  }
  return found;
}

}  // namespace sim::cut
