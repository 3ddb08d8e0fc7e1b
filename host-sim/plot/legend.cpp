#include "host-sim/plot/legend.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/plot/path_drawing.hpp"
#include "host-sim/plot/svg_element.hpp"

namespace sim {
namespace {

constexpr svg::TextStyle kLabel{.size_px = 20.0};
constexpr svg::TextStyle kHeading{.size_px = 20.0, .weight = "bold"};
constexpr svg::LineStyle kInk{"#222222", 2.0};
constexpr double kSampleWidthPx = 56.0;
constexpr double kEntryHeightPx = 38.0;
constexpr double kScaleHeightPx = 290.0;

/// Writes the entries of the legend, each below the preceding one.
class Legend {
 public:
  Legend(std::string& out, const Box& box) : out_{out}, box_{box}, y_px_{box.top_px} {}

  void add_speed_scale(const LegendContent& content) {
    const char* heading = content.shown == Shown::kSpeed   ? "Speed, mm/min"
                          : content.shown == Shown::kDepth ? "Depth, mm"
                                                           : "Power, %";
    svg::add_text(out_, box_.left_px, y_px_ + 16.0, kHeading, heading);
    const Box bar{box_.left_px, y_px_ + 38.0, 30.0, kScaleHeightPx};
    add_colours(bar, content.shown);
    const double top = content.top_speed_mm_min;
    const long ticks = std::lround(top / content.tick_speed_mm_min);
    for (long tick = 0; tick <= ticks; ++tick) {
      const double speed = static_cast<double>(tick) * content.tick_speed_mm_min;
      const double y_px = bar.bottom_px() - bar.height_px * speed / top;
      svg::add_line(out_, bar.right_px(), y_px, bar.right_px() + 7.0, y_px, kInk);
      svg::add_text(out_, bar.right_px() + 15.0, y_px + 7.0, kLabel, fmt::format("{:g}", speed));
    }
    y_px_ = bar.bottom_px() + 50.0;
  }

  void add_line_sample(const svg::LineStyle& style, std::string_view label) {
    svg::add_line(out_, box_.left_px, y_px_, box_.left_px + kSampleWidthPx, y_px_, style);
    add_label(label);
  }

  void add_cut_sample(const LegendContent& content, const View& view) {
    const double band_px = std::min(content.kerf_width_mm * view.px_per_mm(), 24.0);
    const Box band{box_.left_px, y_px_ - 0.5 * band_px, kSampleWidthPx, band_px};
    if (band_px > 0.0) svg::add_box(out_, band, kKerfStroke);
    const std::string stroke = colour_of(content.shown, 0.6);
    const char* wide = content.shown == Shown::kDepth ? "tool" : "kerf";
    const bool has_kerf = content.kerf_width_mm > 0.0;
    add_line_sample({stroke, kCutWidthPx},
                    has_kerf ? fmt::format("cut, {} {:g} mm", wide, content.kerf_width_mm) : "cut");
  }

  template <typename Mark>
  void add_mark(Mark mark, std::string_view label) {
    mark(out_, box_.left_px + 0.5 * kSampleWidthPx, y_px_);
    add_label(label);
  }

  void add_scale_bar(const View& view) {
    const double length_mm = round_step(0.4 * box_.width_px / view.px_per_mm());
    const double right_px = box_.left_px + length_mm * view.px_per_mm();
    svg::add_text(out_, box_.left_px, y_px_ + 10.0, kLabel, fmt::format("{:g} mm", length_mm));
    y_px_ += 28.0;
    fmt::format_to(std::back_inserter(out_),
                   R"(<path d="M{0:.2f} {1:.1f}v14M{0:.2f} {2:.1f}H{3:.2f}M{3:.2f} {1:.1f}v14" )"
                   R"(stroke="#222222" stroke-width="2"/>)"
                   "\n",
                   box_.left_px,
                   y_px_ - 7.0,
                   y_px_,
                   right_px);
  }

 private:
  void add_colours(const Box& bar, Shown shown) {
    // Number of steps of the scale. It is greater than the number of colours of the path, so that
    // the scale looks continuous.
    constexpr int kSteps = 58;
    const double step_px = bar.height_px / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const double top_px = bar.bottom_px() - (i + 1) * step_px;
      // The overlap avoids hairlines between the steps.
      const double overlap_px = i == 0 ? 0.0 : 0.5;
      svg::add_box(out_,
                   {bar.left_px, top_px, bar.width_px, step_px + overlap_px},
                   colour_of(shown, (i + 0.5) / kSteps));
    }
  }

  void add_label(std::string_view label) {
    svg::add_text(out_, box_.left_px + kSampleWidthPx + 16.0, y_px_ + 7.0, kLabel, label);
    y_px_ += kEntryHeightPx;
  }

  std::string& out_;
  const Box& box_;
  double y_px_;
};

}  // namespace

void add_legend(std::string& out, const Box& box, const View& view, const LegendContent& content) {
  Legend legend{out, box};
  if (content.top_speed_mm_min > 0.0) legend.add_speed_scale(content);
  if (content.has_cut) legend.add_cut_sample(content, view);
  if (content.has_feed) {
    legend.add_line_sample({colour_of(content.shown, 0.6), kFeedWidthPx},
                           content.shown == Shown::kDepth ? "spindle off" : "beam off");
  }
  if (content.has_travel) {
    const std::string dashes = fmt::format("{} {}", kTravelDashPx, kTravelGapPx);
    legend.add_line_sample({kTravelStroke, kTravelWidthPx, dashes}, "rapid");
  }
  if (content.has_marks) {
    legend.add_mark(add_start_mark, "start");
    legend.add_mark(add_end_mark, "end");
  }
  legend.add_scale_bar(view);
}

void add_start_mark(std::string& out, double x_px, double y_px) {
  fmt::format_to(std::back_inserter(out),
                 R"(<circle cx="{:.1f}" cy="{:.1f}" r="10" fill="none" stroke="#ffffff" )"
                 R"(stroke-width="6"/><circle cx="{:.1f}" cy="{:.1f}" r="10" fill="none" )"
                 R"(stroke="#00796b" stroke-width="3"/>)"
                 "\n",
                 x_px,
                 y_px,
                 x_px,
                 y_px);
}

void add_end_mark(std::string& out, double x_px, double y_px) {
  fmt::format_to(std::back_inserter(out),
                 R"(<rect x="{:.1f}" y="{:.1f}" width="9" height="9" fill="#222222" )"
                 R"(stroke="#ffffff" stroke-width="1.5"/>)"
                 "\n",
                 x_px - 4.5,
                 y_px - 4.5);
}

}  // namespace sim
