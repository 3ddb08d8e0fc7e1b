#include "host-sim/engrave/shading_name.hpp"

#include <array>
#include <utility>

namespace sim::engrave {
namespace {

constexpr std::array<std::pair<std::string_view, Shading>, 6> kShadings{
    {{"grey", Shading::kGrey},
     {"threshold", Shading::kThreshold},
     {"ordered", Shading::kOrdered},
     {"floyd-steinberg", Shading::kFloydSteinberg},
     {"jarvis", Shading::kJarvis},
     {"stucki", Shading::kStucki}}};

}  // namespace

std::vector<std::string> shading_names() {
  std::vector<std::string> names;
  names.reserve(kShadings.size());
  for (const auto& [name, shading] : kShadings) names.emplace_back(name);
  return names;
}

std::optional<Shading> shading_named(std::string_view name) {
  for (const auto& [known, shading] : kShadings) {
    if (known == name) return shading;
  }
  return std::nullopt;
}

}  // namespace sim::engrave
