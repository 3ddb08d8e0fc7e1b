#include "host-sim/plot/animated_cuts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "host-sim/plot/path_simplifier.hpp"

namespace sim {
namespace {

using cut::TimeKind;
using cut::TimeStep;
using drawing::Place;

/// Appends one cut, which is the steps from `first` up to, but not including, `end` of the
/// timeline. A gap in the dash pattern of its line hides the part that is still to be cut.
void add_growing(std::string& out,
                 const CutScene& scene,
                 const View& view,
                 const AnimationTime& time,
                 std::size_t first,
                 std::size_t end) {
  const std::vector<TimeStep>& steps = scene.timeline->steps;
  const cut::Cut& cut = scene.plan.cuts[steps[first].cut];
  const std::string data = path_data_of(cut, view, [](const cut::Stroke&) { return true; });
  double length = 0.0;
  for (const cut::Stroke& stroke : cut.strokes) length += length_of(stroke);
  KeyFrames frames;
  frames.add(0.0, fmt::format("{:.2f}", length));
  double left = length;
  for (std::size_t i = first; i < end; ++i) {
    if (steps[i].kind == TimeKind::kRapid || steps[i].kind == TimeKind::kWait) continue;
    frames.add(steps[i].begin_s / time.total_s, fmt::format("{:.2f}", left));
    left = std::max(left - length_of(steps[i].path), 0.0);
  }
  frames.add(steps[end - 1].end_s / time.total_s, "0");
  frames.add(1.0, "0");
  fmt::format_to(std::back_inserter(out),
                 "<path d=\"{0}\" pathLength=\"{1:.2f}\" stroke-dasharray=\"{1:.2f} "
                 "{1:.2f}\"><animate attributeName=\"stroke-dashoffset\" {2} {3}/></path>\n",
                 data,
                 length,
                 frames.attributes(),
                 time.attributes());
}

/// Returns simplified path data of a cut, for cuts with invisibly small details or with too many
/// strokes.
std::string coarse_data(const cut::Cut& cut, const View& view) {
  PathSimplifier simplifier{{.distance_mm = 0.3 / view.px_per_mm()}};
  simplifier.push({.x_mm = cut.start().x(), .y_mm = cut.start().y(), .move = Move::kCut});
  for (const cut::Stroke& stroke : cut.strokes) {
    const int parts = stroke.bulge == 0.0 ? 1 : 12;
    for (int i = 1; i <= parts; ++i) {
      const Place place = place_at(stroke, static_cast<double>(i) / parts);
      simplifier.push({.x_mm = place.x(),
                       .y_mm = place.y(),
                       .move = has_beam(stroke.purpose) ? Move::kCut : Move::kTravel});
    }
  }
  std::string data;
  for (const PathVertex& vertex : simplifier.finish()) {
    const bool draws = !data.empty() && vertex.move == Move::kCut;
    fmt::format_to(std::back_inserter(data),
                   "{}{:.1f} {:.1f}",
                   draws ? 'L' : 'M',
                   view.x_px(vertex.x_mm),
                   view.y_px(vertex.y_mm));
  }
  return data;
}

}  // namespace

void add_growing_cuts(std::string& out,
                      const CutScene& scene,
                      const View& view,
                      const AnimationTime& time) {
  fmt::format_to(std::back_inserter(out),
                 "<g class=\"cuts\" fill=\"none\" stroke=\"{}\" stroke-width=\"2.4\">\n",
                 kBeamColour);
  const std::vector<TimeStep>& steps = scene.timeline->steps;
  for (std::size_t first = 0; first < steps.size();) {
    std::size_t end = first;
    while (end < steps.size() && steps[end].cut == steps[first].cut) ++end;
    if (steps[first].cut < scene.plan.cuts.size()) add_growing(out, scene, view, time, first, end);
    first = end;
  }
  out += "</g>\n";
}

void add_appearing_cuts(std::string& out,
                        const CutScene& scene,
                        const View& view,
                        const AnimationTime& time) {
  const std::size_t count = scene.plan.cuts.size();
  const std::size_t in_group = (count + kMaxAnimatedCuts - 1) / kMaxAnimatedCuts;
  std::vector<double> ends(count, time.total_s);
  for (const TimeStep& step : scene.timeline->steps) {
    if (step.cut < count) ends[step.cut] = step.end_s;
  }
  fmt::format_to(std::back_inserter(out),
                 "<g class=\"cuts\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" "
                 "stroke-linecap=\"round\">\n",
                 kBeamColour);
  for (std::size_t first = 0; first < count; first += in_group) {
    const std::size_t end = std::min(first + in_group, count);
    std::string data;
    for (std::size_t i = first; i < end; ++i) data += coarse_data(scene.plan.cuts[i], view);
    KeyFrames frames;
    frames.add(0.0, "hidden");
    frames.add(ends[end - 1] / time.total_s, "visible");
    frames.add(1.0, "visible");
    fmt::format_to(std::back_inserter(out),
                   "<path d=\"{}\"><animate attributeName=\"visibility\" calcMode=\"discrete\" {} "
                   "{}/></path>\n",
                   data,
                   frames.attributes(),
                   time.attributes());
  }
  out += "</g>\n";
}

}  // namespace sim
