#include "host-sim/surface/tip_heights.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::surface {
namespace {

/// Returns the two numbers of a line; nothing if the line does not contain exactly two numbers.
std::optional<Eigen::Vector2d> place_of(std::string_view line) {
  std::string words{line};
  for (char& c : words) {
    if (c == ',' || c == ';') c = ' ';
  }
  TextWords reader{words, 1};
  const std::optional<double> x = parsed_number(reader.next());
  const std::optional<double> y = parsed_number(reader.next());
  if (!x || !y || !std::isfinite(*x) || !std::isfinite(*y) || !reader.next().empty()) return {};
  return Eigen::Vector2d{*x, *y};
}

}  // namespace

std::string tip_heights(const Mesh& mesh,
                        const cnc::surface::Profile& tool,
                        std::string_view places,
                        const std::string& name) {
  const DropCutter cutter{mesh, tool};
  DropCutter::Hint hint;
  std::string text;
  TextLines lines{places};
  while (const std::optional<std::string_view> line = lines.next()) {
    if (line->empty() || line->front() == '#') continue;
    const std::optional<Eigen::Vector2d> place = place_of(*line);
    if (!place) {
      refuse(name,
             lines.number(),
             fmt::format("`{}` is not a position", shown(*line)),
             "give X and Y in mm on each line");
    }
    double height = cutter.tip_height(*place, hint);
    if (height == cnc::surface::kNoContact) height = std::numeric_limits<double>::quiet_NaN();
    fmt::format_to(
        std::back_inserter(text), "{:.17g} {:.17g} {:.17g}\n", place->x(), place->y(), height);
  }
  if (text.empty()) refuse(name, 0, "has no position", "give X and Y in mm on each line");
  return text;
}

}  // namespace sim::surface
