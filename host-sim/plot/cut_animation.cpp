#include "host-sim/plot/cut_animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "host-sim/plot/animated_cuts.hpp"
#include "host-sim/plot/cut_marks.hpp"
#include "host-sim/plot/key_frames.hpp"
#include "host-sim/plot/svg_element.hpp"
#include "host-sim/report/duration_text.hpp"

namespace sim {
namespace {

using cut::TimeKind;
using cut::TimeStep;
using drawing::Place;

constexpr double kAnimationWidthPx = 1200.0;
constexpr double kAnimationMarginPx = 40.0;
constexpr double kAnimationHeadingPx = 110.0;
constexpr double kAnimationTallestPx = 1000.0;
/// Greatest number of texts of the clock. It limits the number of steps of the clock during a job.
constexpr std::size_t kMaxClockTexts = 300;
/// Greatest distance between an arc and the chords along which the beam moves.
constexpr double kBeamChordPx = 0.2;

bool is_lit(const TimeStep& step) {
  return step.kind != TimeKind::kRapid && step.kind != TimeKind::kWait &&
         step.kind != TimeKind::kCornerDwell && step.kind != TimeKind::kTab &&
         step.kind != TimeKind::kOverscan;
}

/// Position of the beam at a time, which is given as a share of the duration of the job.
struct BeamPlace {
  double x_px;
  double y_px;
  double share;
};

/// Draws one job as an animated SVG document.
class Animator {
 public:
  Animator(const CutScene& scene, const AnimationOptions& options)
      : scene_{scene}, time_{time_of(scene, options)}, view_{view_of(scene)} {}

  std::string draw(const std::string& title) {
    const double height_px = std::ceil(view_.box().bottom_px() + kAnimationMarginPx);
    std::string out = svg::document_start(kAnimationWidthPx, height_px);
    svg::add_box(out, {0.0, 0.0, kAnimationWidthPx, height_px}, "#ffffff");
    svg::add_text(out, kAnimationMarginPx, 48.0, {.size_px = 26.0, .weight = "bold"}, title);
    add_clock(out);
    add_parts(out, scene_, view_);
    if (scene_.timeline->steps.size() <= kMaxGrowingStrokes) {
      add_growing_cuts(out, scene_, view_, time_);
    } else {
      add_appearing_cuts(out, scene_, view_, time_);
    }
    add_beam(out);
    return out + "</svg>\n";
  }

 private:
  static AnimationTime time_of(const CutScene& scene, const AnimationOptions& options) {
    const double total_s = std::max(scene.timeline->total_s(), 1.0e-3);
    return {total_s, std::min(total_s, options.max_seconds)};
  }

  static View view_of(const CutScene& scene) {
    Extent extent = extent_of(scene);
    extent.include(0.0, 0.0);
    const Extent framed = framed_cuts(extent);
    const double width_px = kAnimationWidthPx - 2.0 * kAnimationMarginPx;
    const double natural_px = width_px * framed.height_mm() / framed.width_mm();
    return View{framed,
                {kAnimationMarginPx,
                 kAnimationHeadingPx,
                 width_px,
                 std::clamp(natural_px, 150.0, kAnimationTallestPx)}};
  }

  [[nodiscard]] std::vector<BeamPlace> beam_places() const;
  void add_clock(std::string& out) const;
  void add_beam(std::string& out) const;

  const CutScene& scene_;
  AnimationTime time_;
  View view_;
};

/// Appends the clock. It is a strip with the texts of all times, which moves behind a window that
/// shows one text at a time.
void Animator::add_clock(std::string& out) const {
  const double y_px = 64.0;
  const double step_s = round_step(time_.total_s / static_cast<double>(kMaxClockTexts - 2));
  const auto steps = static_cast<std::size_t>(time_.total_s / step_s);
  constexpr double kLinePx = 30.0;
  KeyFrames frames;
  std::string texts;
  for (std::size_t i = 0; i <= steps + 1; ++i) {
    const double time_s = std::min(static_cast<double>(i) * step_s, time_.total_s);
    const std::string text = duration_text(time_s);
    frames.add(time_s / time_.total_s, fmt::format("0 {:g}", -kLinePx * static_cast<double>(i)));
    const double line_px = 22.0 + kLinePx * static_cast<double>(i);
    fmt::format_to(std::back_inserter(texts), "<text y=\"{:g}\">{}</text>", line_px, text);
  }
  // The window is a clip path and not a nested <svg>, because browsers would give a nested <svg> a
  // separate time. In a viewer that does not animate, the window shows the last text.
  fmt::format_to(
      std::back_inserter(out),
      "<clipPath id=\"window\"><rect width=\"230\" height=\"{2:g}\"/></clipPath>\n"
      "<g transform=\"translate({0:g} {1:g})\" clip-path=\"url(#window)\"><g class=\"clock\" "
      "font-size=\"22\" fill=\"#222222\" transform=\"translate(0 {3:g})\">{4}"
      "<animateTransform attributeName=\"transform\" type=\"translate\" calcMode=\"discrete\" {5} "
      "{6}/></g></g>\n",
      kAnimationMarginPx,
      y_px,
      kLinePx,
      -kLinePx * static_cast<double>(steps + 1),
      texts,
      frames.attributes(),
      time_.attributes());
  std::string note = fmt::format("of {}", duration_text(time_.total_s));
  if (time_.total_s > time_.shown_s)
    note += fmt::format(", shown {:.1f} times faster", time_.total_s / time_.shown_s);
  svg::add_text(
      out, kAnimationMarginPx + 240.0, y_px + 22.0, {.size_px = 22.0, .fill = "#5b626c"}, note);
}

std::vector<BeamPlace> Animator::beam_places() const {
  std::vector<BeamPlace> places{{view_.x_px(0.0), view_.y_px(0.0), 0.0}};
  for (const TimeStep& step : scene_.timeline->steps) {
    double chords = 1.0;
    if (step.path.bulge != 0.0) {
      const double sweep = 4.0 * std::atan(std::abs(step.path.bulge));
      const double radius_px = length_of(step.path) / sweep * view_.px_per_mm();
      chords = std::ceil(sweep / std::sqrt(8.0 * kBeamChordPx / std::max(radius_px, kBeamChordPx)));
    }
    for (double i = 1.0; i <= chords; ++i) {
      const double share = i / chords;
      const Place place = place_at(step.path, share);
      const double time_s = step.begin_s + share * (step.end_s - step.begin_s);
      places.push_back({view_.x_px(place.x()), view_.y_px(place.y()), time_s / time_.total_s});
    }
  }
  return places;
}

/// Returns points without those that are close to the preceding point. The distance is increased
/// until at most kMaxBeamPlaces points are left.
std::vector<BeamPlace> thinned(std::vector<BeamPlace> places) {
  for (double near_px = 0.5; places.size() > kMaxBeamPlaces; near_px *= 2.0) {
    std::vector<BeamPlace> kept{places.front()};
    for (std::size_t i = 1; i < places.size(); ++i) {
      const double way_px =
          std::hypot(places[i].x_px - kept.back().x_px, places[i].y_px - kept.back().y_px);
      if (way_px >= near_px || i + 1 == places.size()) kept.push_back(places[i]);
    }
    places = std::move(kept);
  }
  return places;
}

void Animator::add_beam(std::string& out) const {
  KeyFrames path;
  const std::vector<BeamPlace> places = thinned(beam_places());
  for (const BeamPlace& place : places) {
    path.add(place.share, fmt::format("{:.1f} {:.1f}", place.x_px, place.y_px));
  }
  path.add(1.0, fmt::format("{:.1f} {:.1f}", places.back().x_px, places.back().y_px));
  KeyFrames light;
  bool was_lit = false;
  light.add(0.0, kRapidColour);
  for (const TimeStep& step : scene_.timeline->steps) {
    if (is_lit(step) == was_lit) continue;
    was_lit = is_lit(step);
    light.add(step.begin_s / time_.total_s, was_lit ? "#d55e00" : kRapidColour);
  }
  light.add(1.0, kRapidColour);
  fmt::format_to(std::back_inserter(out),
                 "<g class=\"beam\" fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"2\" "
                 "transform=\"translate({:.1f} {:.1f})\"><circle r=\"7\"/>"
                 "<animateTransform attributeName=\"transform\" type=\"translate\" {} {}/>",
                 kRapidColour,
                 places.back().x_px,
                 places.back().y_px,
                 path.attributes(),
                 time_.attributes());
  fmt::format_to(std::back_inserter(out),
                 "<animate attributeName=\"fill\" calcMode=\"discrete\" {} {}/></g>\n",
                 light.attributes(),
                 time_.attributes());
}

}  // namespace

std::string animate_cuts(const CutScene& scene,
                         const std::string& title,
                         const AnimationOptions& options) {
  return Animator{scene, options}.draw(title);
}

}  // namespace sim
