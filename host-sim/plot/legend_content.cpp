#include "host-sim/plot/legend_content.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host-sim/plot/view.hpp"

namespace sim {
namespace {

/// Shares of length and of speed that the scale ignores. Speeds that are measured over the steps of
/// short stretches scatter, mostly upwards. The scale ignores the fastest 0.2 % of the length, and
/// ends at 98 % of the greatest remaining speed. Scatter thus does not extend a scale of 3000
/// mm/min to 4000 mm/min.
constexpr double kScatteredLength = 0.002;
constexpr double kScatter = 0.98;

/// Least length of a stretch that is visible as a line. A shorter stretch is only a dot.
constexpr double kVisiblePx = 4.0;

double length_mm(const PathVertex& from, const PathVertex& to) {
  return std::hypot(to.x_mm - from.x_mm, to.y_mm - from.y_mm);
}

struct Stretch {
  float speed_mm_s;
  double length_mm;
};

std::vector<Stretch> driven_stretches(const std::vector<PathVertex>& vertices) {
  std::vector<Stretch> stretches;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    if (vertices[i].move == Move::kTravel) continue;
    stretches.push_back({vertices[i].speed_mm_s, length_mm(vertices[i - 1], vertices[i])});
  }
  return stretches;
}

/// Returns the greatest speed of feeds and cuts, without the values that scatter; 0 if there are no
/// feeds or cuts.
double greatest_speed_mm_s(const std::vector<PathVertex>& vertices) {
  std::vector<Stretch> stretches = driven_stretches(vertices);
  std::sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) {
    return a.speed_mm_s > b.speed_mm_s;
  });
  double left_mm = 0.0;
  for (const Stretch& stretch : stretches) left_mm += kScatteredLength * stretch.length_mm;
  for (const Stretch& stretch : stretches) {
    left_mm -= stretch.length_mm;
    if (left_mm <= 0.0) return static_cast<double>(stretch.speed_mm_s);
  }
  return 0.0;
}

double greatest_shown(const std::vector<PathVertex>& vertices, Shown shown) {
  if (shown == Shown::kSpeed) return kScatter * greatest_speed_mm_s(vertices);
  float greatest = 0.0F;
  for (const PathVertex& vertex : vertices) {
    if (vertex.move == Move::kCut) greatest = std::max(greatest, vertex.speed_mm_s);
  }
  return static_cast<double>(greatest);
}

/// Returns the length of the longest piece of the path that has only moves of one kind.
double longest_run_mm(const std::vector<PathVertex>& vertices, Move move) {
  double longest_mm = 0.0;
  double run_mm = 0.0;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const bool is_such = vertices[i].move == move;
    run_mm = is_such ? run_mm + length_mm(vertices[i - 1], vertices[i]) : 0.0;
    longest_mm = std::max(longest_mm, run_mm);
  }
  return longest_mm;
}

}  // namespace

double legend_unit(Shown shown) {
  constexpr double kMmMin = 1.0 / 60.0;
  constexpr double kPercent = 0.01;
  if (shown == Shown::kSpeed) return kMmMin;
  return shown == Shown::kPower ? kPercent : 1.0;
}

LegendContent legend_content(const std::vector<PathVertex>& vertices,
                             double kerf_width_mm,
                             double px_per_mm,
                             Shown shown) {
  const auto is_seen = [&](Move move) {
    return longest_run_mm(vertices, move) * px_per_mm >= kVisiblePx;
  };
  LegendContent content{.shown = shown,
                        .kerf_width_mm = kerf_width_mm,
                        .has_cut = is_seen(Move::kCut),
                        .has_feed = is_seen(Move::kFeed),
                        .has_travel = is_seen(Move::kTravel)};
  const double top_mm_min = greatest_shown(vertices, shown) / legend_unit(shown);
  if (top_mm_min <= 0.0) return content;
  content.tick_speed_mm_min = round_step(top_mm_min / 6.0);
  content.top_speed_mm_min =
      content.tick_speed_mm_min * std::ceil(top_mm_min / content.tick_speed_mm_min);
  return content;
}

}  // namespace sim
