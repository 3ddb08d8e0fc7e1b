#include "host-sim/wall/beam_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/read_surface.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector3d;

/// Returns the kCount numbers of a line; nothing if the line contains anything else.
template <std::size_t kCount>
std::optional<std::array<double, kCount>> numbers_of(std::string_view line) {
  surface::TextWords words{line, 1};
  std::array<double, kCount> numbers{};
  for (double& number : numbers) {
    const std::optional<double> value = surface::parsed_number(words.next());
    if (!value || !(std::abs(*value) <= surface::kFarthestMm)) return {};
    number = *value;
  }
  if (!words.next().empty()) return {};
  return numbers;
}

/// Calls `take(numbers)` for each line except blank lines and comments. `take` returns whether it
/// accepts the numbers.
template <std::size_t kCount, typename Take>
void for_lines(std::string_view text,
               const std::string& name,
               std::string_view form,
               const Take& take) {
  surface::TextLines lines{text};
  bool has_any = false;
  while (const std::optional<std::string_view> line = lines.next()) {
    if (line->empty() || line->front() == '#') continue;
    const auto numbers = numbers_of<kCount>(*line);
    if (!numbers || !take(*numbers)) {
      surface::refuse(name,
                      lines.number(),
                      fmt::format("`{}` is not a valid line", surface::shown(*line)),
                      fmt::format("give {}, up to 10 m", form));
    }
    has_any = true;
  }
  if (!has_any) surface::refuse(name, 0, "is empty", fmt::format("give {}", form));
}

}  // namespace

std::string cone_answers(std::string_view lines, const std::string& name) {
  std::string text;
  for_lines<17>(lines,
                name,
                "`ox oy oz ax ay az cos2 h` with 0 < cos2 < 1, h > 0, and a triangle's 9 numbers",
                [&text](const std::array<double, 17>& given) {
                  const auto vector = [&given](std::size_t at) {
                    return Vector3d{given[at], given[at + 1], given[at + 2]};
                  };
                  const double length = vector(3).norm();
                  const double square = given[6];
                  if (!(length > 0.0 && square > 0.0 && square < 1.0 && given[7] > 0.0)) {
                    return false;
                  }
                  const Beam beam{.tip = vector(0),
                                  .axis = vector(3) / length,
                                  .sine = std::sqrt(1.0 - square),
                                  .cosine = std::sqrt(square),
                                  .length_mm = given[7]};
                  const Triangle triangle{vector(8), vector(11), vector(14)};
                  fmt::format_to(std::back_inserter(text),
                                 "{} {:.17g}\n",
                                 cnc::wall::meets(beam, triangle) ? 1 : 0,
                                 cnc::wall::clearance(beam, triangle));
                  return true;
                });
  return text;
}

void append_beam_line(const Vector3d& tip, const Vector3d& axis, std::string& text) {
  fmt::format_to(std::back_inserter(text),
                 "{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n",
                 tip.x(),
                 tip.y(),
                 tip.z(),
                 axis.x(),
                 axis.y(),
                 axis.z());
}

void append_lost_line(const Vector3d& tip, std::string& text) {
  fmt::format_to(std::back_inserter(text),
                 "# {:.17g} {:.17g} {:.17g} is out of reach\n",
                 tip.x(),
                 tip.y(),
                 tip.z());
}

BeamList leaning_beams(const Obstacles& obstacles,
                       const TiltRules& rules,
                       std::string_view places,
                       const std::string& name) {
  BeamList list;
  for_lines<3>(places, name, "`X Y Z` in mm", [&](const std::array<double, 3>& place) {
    const Vector3d tip{place[0], place[1], place[2]};
    const std::optional<Beam> beam = least_tilt(obstacles, tip, rules);
    if (!beam) {
      ++list.out_of_reach;
      append_lost_line(tip, list.text);
      return true;
    }
    const Vector3d& axis = beam->axis;
    const double tilt = std::atan2(axis.head<2>().norm(), axis.z());
    list.max_tilt_rad = std::max(list.max_tilt_rad, tilt);
    append_beam_line(tip, axis, list.text);
    return true;
  });
  return list;
}

}  // namespace sim::wall
