#include "host-sim/wall/carve/taper.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::wall {
namespace {

/// Angles of a measured wall, degrees.
struct MeasuredCut {
  double over_deg = 0.0;  ///< Lean of the beam beyond the lean that its cone requires.
  double off_deg = 0.0;   ///< Lean of the wall beyond the drawn angle.
};

constexpr const char* kRemedy =
    "give `drawn carved gain`: two angles from the vertical between -89 and 89 degrees, and a gain "
    "from 0 to 12, which may be omitted";

/// Returns the drawn angle, the carved angle and the gain of a line; nothing if the line is not a
/// cut.
std::optional<std::array<double, 3>> numbers_of_cut(std::string_view line) {
  surface::TextWords words{line, 1};
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string_view word = words.next();
    if (word.empty() && i == 2) break;
    const std::optional<double> value = surface::parsed_number(word);
    if (!value || !(std::abs(*value) < 89.0)) return {};
    numbers[i] = *value;
  }
  if (!words.next().empty() || numbers[2] < 0.0 || numbers[2] > kMaxTaperGain) return {};
  return numbers;
}

/// Returns the cuts for which the beam had to lean. Counts these cuts in `used` and the other cuts
/// in `passed`.
std::vector<MeasuredCut> read_cuts(std::string_view text,
                                   double half_angle_deg,
                                   const std::string& name,
                                   TaperFit& fit) {
  std::vector<MeasuredCut> cuts;
  surface::TextLines lines{text};
  while (const std::optional<std::string_view> line = lines.next()) {
    if (line->empty() || line->front() == '#') continue;
    const auto numbers = numbers_of_cut(*line);
    if (!numbers) {
      surface::refuse(
          name, lines.number(), fmt::format("`{}` is not a cut", surface::shown(*line)), kRemedy);
    }
    const auto [drawn, carved, gain] = *numbers;
    const double over = gain * half_angle_deg;
    if (drawn > half_angle_deg + over) {
      ++fit.passed;
    } else {
      cuts.push_back({over, carved - drawn});
    }
  }
  fit.used = cuts.size();
  return cuts;
}

}  // namespace

TaperFit fit_taper(std::string_view cuts, double half_angle_deg, const std::string& name) {
  TaperFit fit;
  const std::vector<MeasuredCut> measured = read_cuts(cuts, half_angle_deg, name, fit);
  if (measured.empty()) {
    surface::refuse(name,
                    0,
                    fit.passed == 0 ? "has no cut" : "has only walls that an upright beam clears",
                    kRemedy);
  }
  const auto count = static_cast<double>(measured.size());
  double over = 0.0;
  double off = 0.0;
  for (const MeasuredCut& cut : measured) {
    over += cut.over_deg / count;
    off += cut.off_deg / count;
  }
  double mixed = 0.0;
  double square = 0.0;
  for (const MeasuredCut& cut : measured) {
    mixed += (cut.over_deg - over) * (cut.off_deg - off);
    square += (cut.over_deg - over) * (cut.over_deg - over);
  }
  constexpr double kOneGainDeg = 1.0e-6;
  if (square > kOneGainDeg) fit.response = -mixed / square;
  fit.heat_deg = off + fit.response * over;
  for (const MeasuredCut& cut : measured) {
    const double rest = cut.off_deg - fit.heat_deg + fit.response * cut.over_deg;
    fit.rest_deg += rest * rest / count;
  }
  fit.rest_deg = std::sqrt(fit.rest_deg);
  fit.gain = fit.heat_deg / (fit.response * half_angle_deg);
  if (!(fit.response > 0.0) || !(fit.gain >= 0.0 && fit.gain <= kMaxTaperGain)) {
    surface::refuse(
        name,
        0,
        fmt::format("heat leans the walls by {:.3g} degrees, and the fitted response to "
                    "a lean of the beam is {:.3g}; no gain from 0 to 12 cancels this",
                    fit.heat_deg,
                    fit.response),
        "measure walls from which the beam leans away, with at least two gains");
  }
  return fit;
}

}  // namespace sim::wall
