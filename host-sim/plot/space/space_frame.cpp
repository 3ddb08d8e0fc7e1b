#include "host-sim/plot/space/space_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "host-sim/plot/picture_key.hpp"
#include "host-sim/plot/svg_element.hpp"

namespace sim {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr svg::LineStyle kFrameGrid{"#e1e4e8", 1.0};
constexpr svg::LineStyle kFrameEdge{"#9aa1aa", 1.3};
constexpr double kTickPx = 8.0;
constexpr double kLabelPx = 22.0;
constexpr double kNamePx = 66.0;

void add_line(std::string& out,
              const Axonometry& axonometry,
              const Vector3d& from,
              const Vector3d& to,
              const svg::LineStyle& style) {
  const SeenPoint a = axonometry.seen(from);
  const SeenPoint b = axonometry.seen(to);
  svg::add_line(out, a.x_px, a.y_px, b.x_px, b.y_px, style);
}

/// Returns at most `wanted` + 1 round numbers between the ends of an axis of the box. Sets `step`
/// to the difference between consecutive numbers.
std::vector<double> ticks_of(const SpaceBox& box, Index axis, double wanted, double& step) {
  const double least = box.least[axis];
  const double most = box.most[axis];
  std::vector<double> ticks;
  step = round_step(std::max(most - least, 1.0e-9) / wanted);
  const double slack = 1.0e-6 * step;
  for (double i = std::ceil((least - slack) / step); i * step <= most + slack; i += 1.0) {
    ticks.push_back(i * step);
  }
  return ticks;
}

double wanted_ticks(Index axis) { return axis == 2 ? 4.0 : 6.0; }

/// Returns the corner of the floor that is nearest to the viewer.
unsigned near_corner(const Axonometry& axonometry, const SpaceBox& box) {
  unsigned nearest = 0;
  for (unsigned corner = 1; corner < 4; ++corner) {
    const auto depth = [&](unsigned number) {
      return axonometry.seen(box.corner(number)).depth_px;
    };
    if (depth(corner) < depth(nearest)) nearest = corner;
  }
  return nearest;
}

/// Appends the grid of one side of the box.
/// @param normal axis at right angles to the side
/// @param value position of the side on that axis
void add_side(std::string& out,
              const Axonometry& axonometry,
              const SpaceBox& box,
              Index normal,
              double value) {
  for (Index axis = 0; axis < 3; ++axis) {
    if (axis == normal) continue;
    const Index along = 3 - normal - axis;
    double step = 0.0;
    std::vector<double> places = ticks_of(box, axis, wanted_ticks(axis), step);
    const std::size_t inner = places.size();
    places.push_back(box.least[axis]);
    places.push_back(box.most[axis]);
    for (std::size_t i = 0; i < places.size(); ++i) {
      Vector3d from;
      from[normal] = value;
      from[axis] = places[i];
      from[along] = box.least[along];
      Vector3d to = from;
      to[along] = box.most[along];
      add_line(out, axonometry, from, to, i < inner ? kFrameGrid : kFrameEdge);
    }
  }
}

/// An edge of the box that has a scale, and the direction in the picture from the edge to the
/// numbers of the scale.
struct ScaledEdge {
  Index axis;
  Vector3d corner;  ///< A point on the edge, mm.
  double out_x;
  double out_y;
  const char* name;
};

void add_scale(std::string& out,
               const Axonometry& axonometry,
               const SpaceBox& box,
               const ScaledEdge& edge) {
  const char* const anchor = std::abs(edge.out_x) < 0.3 ? "middle"
                             : edge.out_x > 0.0         ? "start"
                                                        : "end";
  double step = 0.0;
  const auto text_at = [&](double value, double far_px, const std::string& text, double size_px) {
    Vector3d place = edge.corner;
    place[edge.axis] = value;
    const SeenPoint seen = axonometry.seen(place);
    svg::add_text(out,
                  seen.x_px + far_px * edge.out_x,
                  seen.y_px + far_px * edge.out_y + 7.0,
                  {.size_px = size_px, .anchor = anchor, .fill = "#3b424c"},
                  text);
  };
  for (const double tick : ticks_of(box, edge.axis, wanted_ticks(edge.axis), step)) {
    Vector3d place = edge.corner;
    place[edge.axis] = tick;
    const SeenPoint seen = axonometry.seen(place);
    svg::add_line(out,
                  seen.x_px,
                  seen.y_px,
                  seen.x_px + kTickPx * edge.out_x,
                  seen.y_px + kTickPx * edge.out_y,
                  kFrameEdge);
    text_at(tick, kLabelPx, tick_text(tick, step), 20.0);
  }
  if (edge.axis == 2) return;
  text_at(0.5 * (box.least[edge.axis] + box.most[edge.axis]), kNamePx, edge.name, 22.0);
}

}  // namespace

void add_back_sides(std::string& out, const Axonometry& axonometry, const SpaceBox& box) {
  const unsigned near = near_corner(axonometry, box);
  const Vector3d far = box.corner(near ^ 3U);
  out += "<g stroke-linecap=\"round\">\n";
  add_side(out, axonometry, box, 2, box.least.z());
  add_side(out, axonometry, box, 0, far.x());
  add_side(out, axonometry, box, 1, far.y());
  out += "</g>\n";
}

void add_space_axes(std::string& out, const Axonometry& axonometry, const SpaceBox& box) {
  const unsigned near = near_corner(axonometry, box);
  const Vector3d corner = box.corner(near);
  const SeenPoint middle = axonometry.seen(0.5 * (box.corner(0) + box.corner(3)));
  // The numbers of X and Y are outside of the floor: those of X in the direction of Y, and those of
  // Y in the direction of X.
  for (const auto& [axis, name] : {std::pair{Index{0}, "X, mm"}, std::pair{Index{1}, "Y, mm"}}) {
    Vector3d inner = corner;
    inner[1 - axis] = 0.5 * (box.least[1 - axis] + box.most[1 - axis]);
    Vector3d begin = corner;
    begin[axis] = inner[axis] = 0.5 * (box.least[axis] + box.most[axis]);
    const SeenPoint from = axonometry.seen(inner);
    const SeenPoint to = axonometry.seen(begin);
    const double length = std::max(1.0e-9, std::hypot(to.x_px - from.x_px, to.y_px - from.y_px));
    add_scale(out,
              axonometry,
              box,
              {axis, corner, (to.x_px - from.x_px) / length, (to.y_px - from.y_px) / length, name});
  }
  unsigned left = 0;
  for (const unsigned candidate : {1U, 2U, 3U}) {
    const auto x_px = [&](unsigned number) { return axonometry.seen(box.corner(number)).x_px; };
    if (x_px(candidate) < x_px(left)) left = candidate;
  }
  const Vector3d low = box.corner(left);
  const double out_x = axonometry.seen(low).x_px < middle.x_px ? -1.0 : 1.0;
  add_line(out, axonometry, low, box.corner(left | 4U), kFrameEdge);
  add_scale(out, axonometry, box, {2, low, out_x, 0.0, ""});
  const SeenPoint top = axonometry.seen(box.corner(left | 4U));
  svg::add_text(out,
                top.x_px + 0.5 * kLabelPx,
                top.y_px - kLabelPx,
                {.size_px = 22.0, .anchor = "end", .fill = "#3b424c"},
                "Z, mm");
}

}  // namespace sim
