#include "host-sim/wall/carve/beam_strokes.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/read_surface.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector3d;

/// Minimum Z of a unit vector along the axis. Below this minimum, the axis counts as horizontal.
constexpr double kMinRise = 1.0e-3;

/// Returns whether a line that is not a beam ends the current stroke.
bool ends_stroke(std::string_view line) {
  return line.empty() || line == "# off" || line.ends_with("is out of reach");
}

std::optional<BeamPose> pose_of(std::string_view line, double depth_mm) {
  surface::TextWords words{line, 1};
  std::array<double, 7> numbers{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, depth_mm};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string_view word = words.next();
    if (word.empty() && i == 6) break;
    const std::optional<double> value = surface::parsed_number(word);
    if (!value || !(std::abs(*value) <= surface::kFarthestMm)) return {};
    numbers[i] = *value;
  }
  const Vector3d axis{numbers[3], numbers[4], numbers[5]};
  const double length = axis.norm();
  if (!words.next().empty() || !(axis.z() > kMinRise * length) || !(numbers[6] >= 0.0)) return {};
  return BeamPose{{numbers[0], numbers[1], numbers[2]}, axis / length, numbers[6]};
}

}  // namespace

std::vector<BeamStroke> read_strokes(std::string_view text,
                                     double depth_mm,
                                     const std::string& name) {
  constexpr const char* kRemedy =
      "give `x y z i j k`: the tip in mm, up to 10 m, and the axis upwards to the lens; a depth of "
      "at least 0 may follow";
  std::vector<BeamStroke> strokes;
  bool is_on = false;
  surface::TextLines lines{text};
  while (const std::optional<std::string_view> line = lines.next()) {
    if (line->empty() || line->front() == '#') {
      if (ends_stroke(*line)) is_on = false;
      continue;
    }
    const std::optional<BeamPose> pose = pose_of(*line, depth_mm);
    if (!pose) {
      surface::refuse(
          name, lines.number(), fmt::format("`{}` is not a beam", surface::shown(*line)), kRemedy);
    }
    if (!is_on) strokes.emplace_back();
    strokes.back().push_back(*pose);
    is_on = true;
  }
  if (strokes.empty()) surface::refuse(name, 0, "has no beam", kRemedy);
  return strokes;
}

}  // namespace sim::wall
