#include "host-sim/cut/image_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "host-sim/cut/named_values.hpp"
#include "host-sim/engrave/shading_name.hpp"

namespace sim::cut {
namespace {

constexpr double kGreatestPower = 1.0e6;

bool switch_from(std::string_view key, std::string_view text) {
  if (text == "on" || text == "off") return text == "on";
  throw std::invalid_argument(fmt::format("{}={}: must be `on` or `off`", key, text));
}

engrave::Shading shading_from(std::string_view text) {
  if (const auto shading = engrave::shading_named(text)) return *shading;
  throw std::invalid_argument(
      fmt::format("shading={}: must be {}", text, fmt::join(engrave::shading_names(), ", ")));
}

}  // namespace

PowerWish power_from(std::string_view key, std::string_view text) {
  if (text.ends_with('%')) {
    const std::string_view number = text.substr(0, text.size() - 1);
    return {{}, PowerShare{number_from(key, number, 0.01, 100.0, "%"), false}};
  }
  if (text.starts_with('S') || text.starts_with('s')) {
    const double value = number_from(key, text.substr(1), 0.001, kGreatestPower, "of S");
    return {{}, PowerShare{value, true}};
  }
  const bool has_unit = text.ends_with('W') || text.ends_with('w');
  const std::string_view number = text.substr(0, text.size() - (has_unit ? 1 : 0));
  return {number_from(key, number, 0.001, kGreatestPower, "W"), {}};
}

void set_image(ImageSettings& settings, std::string_view key, std::string_view value) {
  if (key == "min-power") {
    settings.min_power = value == "0" ? PowerWish{} : power_from(key, value);
  } else if (key == "shading") {
    settings.shading = shading_from(value);
  } else if (key == "gamma") {
    settings.gamma = number_from(key, value, 0.1, 10.0, "as a gamma");
  } else if (key == "invert") {
    settings.is_inverted = switch_from(key, value);
  } else if (key == "pixel") {
    settings.pixel_mm = number_from(key, value, 0.005, 10.0, "mm");
  } else if (key == "one-way") {
    settings.is_one_way = switch_from(key, value);
  } else if (key == "plain") {
    settings.is_plain = switch_from(key, value);
  } else {
    settings.reverse_shift_mm = number_from(key, value, -10.0, 10.0, "mm");
  }
}

}  // namespace sim::cut
