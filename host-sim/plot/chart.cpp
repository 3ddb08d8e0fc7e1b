#include "host-sim/plot/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/plot/svg_element.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {
namespace {

constexpr double kChartWidthPx = 1600.0;
constexpr double kChartHeightPx = 900.0;
constexpr double kPanelTopPx = 160.0;
constexpr double kPanelBottomPx = 800.0;
constexpr double kLeftRoomPx = 120.0;  ///< Width left of each panel, for the numbers of the y axis.
constexpr double kRightRoomPx = 175.0;  ///< Width right of each panel, for the names of the lines.
constexpr svg::LineStyle kRule{"#e9ebee", 1.0};
constexpr svg::LineStyle kFrame{"#c3c8cf", 1.5};
constexpr svg::TextStyle kNumber{.size_px = 20.0, .anchor = "middle", .fill = "#5b626c"};

/// An axis with numbers. Both of its ends are round numbers.
class ChartAxis {
 public:
  void include(double value) {
    min_ = std::min(min_, value);
    max_ = std::max(max_, value);
  }
  [[nodiscard]] bool is_empty() const { return max_ < min_; }

  /// Computes the scale of the axis, from `from_px` to `to_px`. Must be called after all values
  /// were included.
  void place(double from_px, double to_px) {
    from_px_ = from_px;
    to_px_ = to_px;
    const double span = std::max(max_ - min_, 1e-3 * std::max(std::abs(max_), 1e-9));
    step_ = round_step(span / 6.0);
    first_ = std::floor(min_ / step_ + 1e-9);
    last_ = std::max(std::ceil(max_ / step_ - 1e-9), first_ + 1.0);
  }
  [[nodiscard]] double px(double value) const {
    return from_px_ + (to_px_ - from_px_) * (value / step_ - first_) / (last_ - first_);
  }
  template <typename Visit>
  void for_each_tick(Visit visit) const {
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step_) + 1e-9)));
    for (double tick = first_; tick <= last_ + 0.5; tick += 1.0) {
      visit(px(tick * step_), fmt::format("{:.{}f}", tick * step_, decimals));
    }
  }

 private:
  double min_ = std::numeric_limits<double>::infinity();
  double max_ = -std::numeric_limits<double>::infinity();
  double from_px_ = 0.0;
  double to_px_ = 0.0;
  double step_ = 1.0;
  double first_ = 0.0;
  double last_ = 1.0;
};

class PanelDrawing {
 public:
  PanelDrawing(std::string& out, const ChartPanel& panel, const Box& box)
      : out_{out}, panel_{panel}, box_{box} {
    for (const ChartSeries& series : panel.series) {
      for (const auto* points : {&series.line, &series.dots}) {
        for (const ChartPoint& point : *points) {
          x_.include(point.x);
          y_.include(point.y);
        }
      }
      for (std::size_t i = 0; i < series.half_bands.size(); ++i) {
        y_.include(series.line[i].y - series.half_bands[i]);
        y_.include(series.line[i].y + series.half_bands[i]);
      }
    }
  }

  void draw() {
    const double middle_px = box_.left_px + 0.5 * box_.width_px;
    if (x_.is_empty()) {
      svg::add_text(
          out_, middle_px, box_.top_px + 0.5 * box_.height_px, kNumber, "nothing to show");
      return;
    }
    x_.place(box_.left_px, box_.right_px());
    y_.place(box_.bottom_px(), box_.top_px);
    add_axes();
    svg::add_text(out_, middle_px, box_.bottom_px() + 64.0, kNumber, panel_.x_label);
    svg::TextStyle left = kNumber;
    left.anchor = "start";
    svg::add_text(out_, box_.left_px - 80.0, box_.top_px - 24.0, left, panel_.y_label);
    for (const bool bands : {true, false}) add_all_series(bands);
  }

 private:
  void add_all_series(bool bands) {
    for (std::size_t i = 0; i < panel_.series.size(); ++i) {
      const double share =
          panel_.series.size() < 2
              ? 0.4
              : static_cast<double>(i) / static_cast<double>(panel_.series.size() - 1);
      const std::string colour = hex(speed_colour(share));
      if (bands) {
        add_band(panel_.series[i], colour);
      } else {
        add_series(panel_.series[i], colour);
      }
    }
  }

  /// Appends the band of a series as a polygon, which runs along the upper side of the band and
  /// back along the lower side. Bands must be appended before all lines, so that the lines cover
  /// the bands.
  void add_band(const ChartSeries& series, const std::string& colour) {
    if (series.half_bands.empty()) return;
    std::string points;
    const auto add = [&](std::size_t i, double sign) {
      const ChartPoint& point = series.line[i];
      fmt::format_to(std::back_inserter(points),
                     "{:.1f},{:.1f} ",
                     x_.px(point.x),
                     y_.px(point.y + sign * series.half_bands[i]));
    };
    for (std::size_t i = 0; i < series.half_bands.size(); ++i) add(i, 1.0);
    for (std::size_t i = series.half_bands.size(); i-- > 0;) add(i, -1.0);
    fmt::format_to(std::back_inserter(out_),
                   R"(<polygon class="band" points="{}" fill="{}" fill-opacity="0.13"/>)"
                   "\n",
                   points,
                   colour);
  }

  struct Label {
    double x_px;
    double y_px;
    double width_px;  ///< Upper bound of the width of a text.
  };

  void add_axes() {
    x_.for_each_tick([this](double px, const std::string& label) {
      svg::add_line(out_, px, box_.top_px, px, box_.bottom_px(), kRule);
      svg::add_text(out_, px, box_.bottom_px() + 30.0, kNumber, label);
    });
    svg::TextStyle right = kNumber;
    right.anchor = "end";
    y_.for_each_tick([&](double px, const std::string& label) {
      svg::add_line(out_, box_.left_px, px, box_.right_px(), px, kRule);
      svg::add_text(out_, box_.left_px - 12.0, px + 7.0, right, label);
    });
    svg::add_line(out_, box_.left_px, box_.top_px, box_.left_px, box_.bottom_px(), kFrame);
    svg::add_line(out_, box_.left_px, box_.bottom_px(), box_.right_px(), box_.bottom_px(), kFrame);
  }

  void add_series(const ChartSeries& series, const std::string& colour) {
    for (std::size_t i = 1; i < series.line.size(); ++i) {
      const ChartPoint& from = series.line[i - 1];
      const ChartPoint& to = series.line[i];
      svg::add_line(out_, x_.px(from.x), y_.px(from.y), x_.px(to.x), y_.px(to.y), {colour, 3.0});
    }
    for (const ChartPoint& dot : series.dots) {
      fmt::format_to(std::back_inserter(out_),
                     R"(<circle cx="{:.1f}" cy="{:.1f}" r="6" fill="{}" fill-opacity="0.7"/>)"
                     "\n",
                     x_.px(dot.x),
                     y_.px(dot.y),
                     colour);
    }
    add_label(series, colour);
  }

  /// Appends the name of a series at the end of its line. Moves the name down if it would cover
  /// another name.
  void add_label(const ChartSeries& series, const std::string& colour) {
    const auto& points = series.line.empty() ? series.dots : series.line;
    if (points.empty()) return;
    constexpr double kRowPx = 24.0;
    constexpr double kLetterPx = 12.0;
    Label label{x_.px(points.back().x) + 12.0,
                y_.px(points.back().y) + 7.0,
                kLetterPx * static_cast<double>(series.label.size())};
    const auto taken = [&](const Label& other) {
      return std::abs(other.y_px - label.y_px) < kRowPx &&
             other.x_px < label.x_px + label.width_px && label.x_px < other.x_px + other.width_px;
    };
    while (std::any_of(labels_.begin(), labels_.end(), taken)) label.y_px += 2.0;
    labels_.push_back(label);
    svg::add_text(out_, label.x_px, label.y_px, {.size_px = 20.0, .fill = colour}, series.label);
  }

  std::string& out_;
  const ChartPanel& panel_;
  Box box_;
  ChartAxis x_;
  ChartAxis y_;
  std::vector<Label> labels_;
};

}  // namespace

std::string draw_chart(const std::string& title,
                       const std::string& subtitle,
                       const std::vector<ChartPanel>& panels) {
  std::string out = svg::document_start(kChartWidthPx, kChartHeightPx);
  svg::add_box(out, {0.0, 0.0, kChartWidthPx, kChartHeightPx}, "#ffffff");
  svg::add_text(out, 40.0, 52.0, {.size_px = 30.0, .weight = "bold"}, title);
  svg::add_text(out, 40.0, 86.0, {.size_px = 20.0, .fill = "#5b626c"}, subtitle);
  const double width_px = kChartWidthPx / static_cast<double>(panels.size());
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Box box{static_cast<double>(i) * width_px + kLeftRoomPx,
                  kPanelTopPx,
                  width_px - kLeftRoomPx - kRightRoomPx,
                  kPanelBottomPx - kPanelTopPx};
    PanelDrawing{out, panels[i], box}.draw();
  }
  return out + "</svg>\n";
}

}  // namespace sim
