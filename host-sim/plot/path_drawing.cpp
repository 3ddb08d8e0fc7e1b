#include "host-sim/plot/path_drawing.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "host-sim/plot/colour_map.hpp"

namespace sim {
namespace {

constexpr std::size_t kColours = 32;

/// Builds the attribute `d` of one <path>. The start of a polyline has absolute coordinates and its
/// stretches have relative coordinates, both in integer units. Relative numbers save digits, and
/// integers prevent the accumulation of rounding errors.
class PathData {
 public:
  void add_stretch(const PathVertex& from, const PathVertex& to, double unit_mm) {
    const Place start = rounded(from, unit_mm);
    const Place end = rounded(to, unit_mm);
    if (start.x == end.x && start.y == end.y) return;
    if (text_.empty() || start.x != end_.x || start.y != end_.y) {
      fmt::format_to(std::back_inserter(text_), "M{} {}l", start.x, start.y);
    } else {
      add_separator(end.x - start.x);
    }
    fmt::format_to(std::back_inserter(text_), "{}", end.x - start.x);
    add_separator(end.y - start.y);
    fmt::format_to(std::back_inserter(text_), "{}", end.y - start.y);
    end_ = end;
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  struct Place {
    std::int64_t x;
    std::int64_t y;
  };

  [[nodiscard]] static Place rounded(const PathVertex& vertex, double unit_mm) {
    return {std::llround(vertex.x_mm / unit_mm), std::llround(vertex.y_mm / unit_mm)};
  }
  /// Appends a blank before a number, unless the minus sign of the number separates it.
  void add_separator(std::int64_t next) {
    if (next >= 0) text_ += ' ';
  }

  std::string text_;
  Place end_{};
};

using ColouredData = std::array<PathData, kColours>;

struct Layers {
  PathData kerf;
  PathData travel;
  ColouredData feed;
  ColouredData cut;
};

std::size_t colour_index(float speed_mm_s, double top_speed_mm_s) {
  if (top_speed_mm_s <= 0.0) return 0;
  const double place = static_cast<double>(speed_mm_s) / top_speed_mm_s * kColours;
  return std::min(static_cast<std::size_t>(std::max(place, 0.0)), kColours - 1);
}

Layers sort_into_layers(const std::vector<PathVertex>& vertices,
                        double unit_mm,
                        const PathDrawing& drawing) {
  Layers layers;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const PathVertex& from = vertices[i - 1];
    const PathVertex& to = vertices[i];
    const std::size_t colour = colour_index(to.speed_mm_s, drawing.top_speed_mm_s);
    if (to.move == Move::kTravel) layers.travel.add_stretch(from, to, unit_mm);
    if (to.move == Move::kFeed) layers.feed[colour].add_stretch(from, to, unit_mm);
    if (to.move == Move::kCut) layers.cut[colour].add_stretch(from, to, unit_mm);
    if (to.move == Move::kCut) layers.kerf.add_stretch(from, to, unit_mm);
  }
  return layers;
}

void add_data(std::string& out, const PathData& data, std::string_view attributes) {
  if (data.text().empty()) return;
  fmt::format_to(std::back_inserter(out), "<path {} d=\"{}\"/>\n", attributes, data.text());
}

void add_coloured(std::string& out, const ColouredData& data, double width, Shown shown) {
  fmt::format_to(std::back_inserter(out), "<g stroke-width=\"{:.4g}\">\n", width);
  for (std::size_t drawn = 0; drawn < kColours; ++drawn) {
    const std::size_t i = shown == Shown::kSpeed ? kColours - 1 - drawn : drawn;
    const double middle = (static_cast<double>(i) + 0.5) / kColours;
    add_data(out, data[i], fmt::format("stroke=\"{}\"", colour_of(shown, middle)));
  }
  out += "</g>\n";
}

/// Returns the unit of path data, mm: the greatest power of ten that is at most a tenth of a pixel.
double unit_for(const View& view) {
  return std::pow(10.0, std::floor(std::log10(0.1 / view.px_per_mm())));
}

/// Opens a group whose coordinates are machine coordinates in units of `unit_mm`, with y upwards.
void open_group(std::string& out, const View& view, double unit_mm) {
  const double px_per_unit = view.px_per_mm() * unit_mm;
  fmt::format_to(std::back_inserter(out),
                 "<!-- The path, in units of {:g} mm. -->\n"
                 "<g transform=\"matrix({:.9g} 0 0 {:.9g} {:.4f} {:.4f})\" fill=\"none\" "
                 "stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
                 unit_mm,
                 px_per_unit,
                 -px_per_unit,
                 view.x_px(0.0),
                 view.y_px(0.0));
}

void add_kerf(std::string& out, const PathData& data, double width) {
  if (width <= 0.0) return;
  add_data(out, data, fmt::format(R"(stroke="{}" stroke-width="{:.4g}")", kKerfStroke, width));
}

void add_travel(std::string& out, const PathData& data, double px_per_unit) {
  add_data(out,
           data,
           fmt::format(R"(stroke="{}" stroke-width="{:.4g}" stroke-linecap="butt" )"
                       R"(stroke-dasharray="{:.4g} {:.4g}")",
                       kTravelStroke,
                       kTravelWidthPx / px_per_unit,
                       kTravelDashPx / px_per_unit,
                       kTravelGapPx / px_per_unit));
}

}  // namespace

std::string colour_of(Shown shown, double share) {
  return hex(speed_colour(shown == Shown::kSpeed ? share : 1.0 - share));
}

void add_path(std::string& out,
              const std::vector<PathVertex>& vertices,
              const View& view,
              const PathDrawing& drawing) {
  const double unit_mm = unit_for(view);
  const double px_per_unit = view.px_per_mm() * unit_mm;
  const Layers layers = sort_into_layers(vertices, unit_mm, drawing);
  open_group(out, view, unit_mm);
  add_kerf(out, layers.kerf, drawing.kerf_width_mm / unit_mm);
  add_travel(out, layers.travel, px_per_unit);
  add_coloured(out, layers.feed, kFeedWidthPx / px_per_unit, drawing.shown);
  add_coloured(out, layers.cut, kCutWidthPx / px_per_unit, drawing.shown);
  out += "</g>\n";
}

}  // namespace sim
