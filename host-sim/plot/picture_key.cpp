#include "host-sim/plot/picture_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host-sim/plot/svg_element.hpp"

namespace sim {
namespace {

constexpr svg::TextStyle kKeyLabel{.size_px = 20.0};
constexpr svg::TextStyle kKeyNote{.size_px = 18.0, .fill = "#5b626c"};
constexpr svg::TextStyle kKeyHeading{.size_px = 20.0, .weight = "bold"};
constexpr svg::LineStyle kTick{"#222222", 2.0};
constexpr double kBarWidthPx = 30.0;
constexpr double kBarHeightPx = 290.0;
constexpr double kKeySamplePx = 48.0;
constexpr double kSampleRowPx = 34.0;
constexpr double kNoteRowPx = 26.0;

/// Appends a scale of colours. Returns its height, px.
double add_scale(std::string& out, double left_px, double top_px, const ColourScale& scale) {
  svg::add_text(out, left_px, top_px + 16.0, kKeyHeading, scale.heading);
  const Box bar{left_px, top_px + 38.0, kBarWidthPx, kBarHeightPx};
  const double step_px = bar.height_px / static_cast<double>(scale.colours.size());
  for (std::size_t i = 0; i < scale.colours.size(); ++i) {
    // The overlap avoids hairlines between the steps.
    const double overlap_px = i == 0 ? 0.0 : 0.5;
    svg::add_box(out,
                 {bar.left_px,
                  bar.bottom_px() - static_cast<double>(i + 1) * step_px,
                  bar.width_px,
                  step_px + overlap_px},
                 hex(scale.colours[i]));
  }
  const double span = scale.most - scale.least;
  const double tick = round_step(span / 6.0);
  for (double i = std::ceil(scale.least / tick - 1.0e-6); i * tick <= scale.most + 1.0e-6 * span;
       i += 1.0) {
    const double y_px = bar.bottom_px() - bar.height_px * (i * tick - scale.least) / span;
    svg::add_line(out, bar.right_px(), y_px, bar.right_px() + 7.0, y_px, kTick);
    svg::add_text(out, bar.right_px() + 15.0, y_px + 7.0, kKeyLabel, tick_text(i * tick, tick));
  }
  return bar.bottom_px() + 50.0 - top_px;
}

void add_sample(std::string& out, double left_px, double y_px, const KeySample& sample) {
  if (sample.shape == SampleShape::kArea) {
    svg::add_box(out, {left_px, y_px - 10.0, kKeySamplePx, 20.0}, sample.colour);
  } else {
    svg::add_line(out,
                  left_px,
                  y_px,
                  left_px + kKeySamplePx,
                  y_px,
                  {sample.colour, sample.width_px, sample.dashes_px});
  }
  svg::add_text(out, left_px + kKeySamplePx + 14.0, y_px + 7.0, kKeyLabel, sample.label);
}

}  // namespace

std::string tick_text(double value, double step) {
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1.0e-9)));
  const double whole = std::round(value / step);
  return fmt::format("{:.{}f}", whole == 0.0 ? 0.0 : whole * step, decimals);
}

void add_key(std::string& out, const Box& box, const PictureKey& key) {
  double y_px = box.top_px;
  for (const ColourScale& scale : key.scales) y_px += add_scale(out, box.left_px, y_px, scale);
  for (const KeySample& sample : key.samples) {
    add_sample(out, box.left_px, y_px, sample);
    y_px += kSampleRowPx;
  }
  y_px += 8.0;
  for (const std::string& note : key.notes) {
    svg::add_text(out, box.left_px, y_px, kKeyNote, note);
    y_px += kNoteRowPx;
  }
}

}  // namespace sim
