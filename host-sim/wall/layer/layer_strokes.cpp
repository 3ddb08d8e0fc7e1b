#include "host-sim/wall/layer/layer_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "host-sim/contour/contour_loops.hpp"
#include "host-sim/pocket/areas.hpp"
#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/scan_line.hpp"
#include "host-sim/surface/path/part_queue.hpp"
#include "host-sim/wall/least_tilt.hpp"
#include "planner/base/wide_scalar_math.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector2d;

/// Minimum length of a line, mm. Shorter lines are left out.
constexpr double kMinMm = 1.0e-5;
/// Distance, mm, within which points count as on the border of the stock.
constexpr double kBorderMm = 1.0e-5;

/// Rotates points between the plan and a frame in which hatch lines are along X. Rotations by
/// multiples of 90 degrees are exact.
class HatchFrame {
 public:
  explicit HatchFrame(double angle_rad) : angle_{cnc::sin_cos(angle_rad)} {
    constexpr double kAlongAxis = 1.0e-12;
    for (double* part : {&angle_.sine, &angle_.cosine}) {
      if (std::abs(*part) < kAlongAxis) *part = 0.0;
      if (std::abs(*part) > 1.0 - kAlongAxis) *part = std::copysign(1.0, *part);
    }
  }

  [[nodiscard]] Vector2d seen(const Vector2d& place) const {
    return {angle_.cosine * place.x() + angle_.sine * place.y(),
            angle_.cosine * place.y() - angle_.sine * place.x()};
  }
  [[nodiscard]] Vector2d at(double along, double across) const {
    return {angle_.cosine * along - angle_.sine * across,
            angle_.cosine * across + angle_.sine * along};
  }
  [[nodiscard]] Contour seen(const Contour& area) const {
    Contour turned = area;
    for (ContourVertex& vertex : turned.vertices) {
      const Vector2d place = seen(Vector2d{vertex.x, vertex.y});
      vertex = {place.x(), place.y(), vertex.bulge};
    }
    return turned;
  }

 private:
  cnc::WideSinCos angle_;
};

void add_lines(const pocket::OwnedArea& area,
               double hatch_mm,
               std::vector<surface::RowPart>& lines) {
  const auto box = pocket::box_of(area);
  // The lines of all areas are on a common raster. The raster is offset by half a distance, so that
  // no line is on a border at zero or at a multiple of the distance.
  const double first = std::floor(box.y0 / hatch_mm - 0.5) + 0.5;
  for (double number = first; number * hatch_mm < box.y1; number += 1.0) {
    const double row = number * hatch_mm;
    if (row <= box.y0) continue;
    for (const pocket::Stretch& stretch : pocket::stretches_at(area, row)) {
      if (stretch.to_x - stretch.from_x < kMinMm) continue;
      lines.push_back({row, stretch.from_x, stretch.to_x});
    }
  }
}

/// Returns the points of a loop. Arcs become chords whose deviation from the arc is at most half
/// the touch distance kTouchMm.
std::vector<Vector2d> places_of(const Contour& area, std::size_t loop) {
  std::vector<Vector2d> places;
  const std::uint32_t begin = area.view().loop_begin(loop);
  const std::uint32_t end = area.loop_ends[loop];
  for (std::uint32_t i = begin; i < end; ++i) {
    const ContourVertex& vertex = area.vertices[i];
    const ContourVertex& next = area.vertices[i + 1 < end ? i + 1 : begin];
    const Vector2d from{vertex.x, vertex.y};
    const Vector2d to{next.x, next.y};
    places.push_back(from);
    if (vertex.bulge == 0.0) continue;
    const Vector2d half = 0.5 * (to - from);
    const double sweep = 4.0 * cnc::wide_atan2(vertex.bulge, 1.0);
    const double radius = half.norm() / std::abs(cnc::sin_cos(0.5 * sweep).sine);
    const double most = 2.0 * std::sqrt(2.0 * 0.5 * kTouchMm / radius);
    const double parts = std::ceil(std::abs(sweep) / most);
    const double rise = (1.0 / vertex.bulge - vertex.bulge) / 2.0;
    const Vector2d middle = from + half + rise * Vector2d{-half.y(), half.x()};
    for (double part = 1.0; part < parts; part += 1.0) {
      const cnc::WideSinCos turn = cnc::sin_cos(sweep * part / parts);
      const Vector2d out = from - middle;
      places.emplace_back(middle.x() + turn.cosine * out.x() - turn.sine * out.y(),
                          middle.y() + turn.sine * out.x() + turn.cosine * out.y());
    }
  }
  return places;
}

/// Appends the parts of a closed loop whose sides are walls as strokes. If all sides are walls, the
/// stroke is closed.
template <typename IsWall>
void add_walls(const std::vector<Vector2d>& loop, const IsWall& is_wall, std::vector<Stroke>& to) {
  const std::size_t count = loop.size();
  std::size_t first = 0;  // Index of the first point after a side that is not a wall.
  while (first < count && is_wall(loop[(first + count - 1) % count], loop[first])) ++first;
  first %= count;
  Stroke stroke{StrokeUse::kContour, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2d& from = loop[(first + i) % count];
    const Vector2d& next = loop[(first + i + 1) % count];
    if (is_wall(from, next)) {
      if (stroke.places.empty()) stroke.places.push_back(from);
      stroke.places.push_back(next);
    } else if (!stroke.places.empty()) {
      to.push_back(std::exchange(stroke, {StrokeUse::kContour, {}}));
    }
  }
  if (!stroke.places.empty()) to.push_back(std::move(stroke));
}

/// Returns the distance from `here` and the index of the nearest point at which a stroke can begin.
/// A closed stroke can begin at all points, an open stroke only at its ends.
std::pair<double, std::size_t> best_begin(const Stroke& stroke, const Vector2d& here) {
  const std::vector<Vector2d>& places = stroke.places;
  const bool is_closed = places.front() == places.back();
  std::pair<double, std::size_t> best{std::numeric_limits<double>::infinity(), 0};
  const std::size_t step = is_closed ? 1 : places.size() - 1;
  for (std::size_t i = 0; i < places.size(); i += step) {
    best = std::min(best, {(places[i] - here).norm(), i});
  }
  return best;
}

void begin_at(std::size_t place, Stroke& stroke) {
  if (place == 0) return;
  std::vector<Vector2d>& places = stroke.places;
  if (places.front() != places.back()) {
    std::ranges::reverse(places);
    return;
  }
  places.pop_back();
  std::rotate(places.begin(),
              places.begin() + static_cast<std::ptrdiff_t>(place % places.size()),
              places.end());
  places.push_back(places.front());
}

}  // namespace

void LayerStrokes::add_hatch(const std::vector<Contour>& areas,
                             double angle_rad,
                             std::vector<Stroke>& strokes) {
  const HatchFrame frame{angle_rad};
  std::vector<surface::RowPart> lines;
  for (const Contour& area : areas) {
    const Contour turned = frame.seen(area);
    add_lines(pocket::OwnedArea{turned.view()}, options_.hatch_mm, lines);
  }
  surface::PartQueue queue{std::move(lines)};
  while (!queue.empty()) {
    const auto [part, goes_back] = queue.take_nearest(frame.seen(here_), true);
    Vector2d from = frame.at(part.begin, part.row);
    Vector2d to = frame.at(part.end, part.row);
    if (goes_back) std::swap(from, to);
    strokes.push_back({StrokeUse::kHatch, {from, to}});
    here_ = to;
  }
}

bool LayerStrokes::is_on_border(const Vector2d& from, const Vector2d& to) const {
  const double inset = options_.waist_mm;
  for (int axis = 0; axis < 2; ++axis) {
    for (const double border : {stock_.min()[axis] + inset, stock_.max()[axis] - inset}) {
      if (std::abs(from[axis] - border) <= kBorderMm && std::abs(to[axis] - border) <= kBorderMm) {
        return true;
      }
    }
  }
  return false;
}

void LayerStrokes::add_contours(const std::vector<Contour>& areas, std::vector<Stroke>& strokes) {
  std::vector<Stroke> waiting;
  for (const Contour& area : areas) {
    for (std::size_t loop = 0; loop < area.loop_ends.size(); ++loop) {
      add_walls(
          places_of(area, loop),
          [this](const Vector2d& from, const Vector2d& to) { return !is_on_border(from, to); },
          waiting);
    }
  }
  while (!waiting.empty()) {
    std::size_t nearest = 0;
    std::pair<double, std::size_t> least{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      const auto begin = best_begin(waiting[i], here_);
      if (begin >= least) continue;
      least = begin;
      nearest = i;
    }
    begin_at(least.second, waiting[nearest]);
    here_ = waiting[nearest].places.back();
    strokes.push_back(std::move(waiting[nearest]));
    waiting[nearest] = std::move(waiting.back());
    waiting.pop_back();
  }
}

std::vector<Stroke> LayerStrokes::strokes_of(const Layer& layer, std::size_t number) {
  std::vector<Contour> areas = layer.areas;
  if (options_.waist_mm > 0.0) {
    Contour all;
    for (const Contour& area : areas) append_loops(area.view(), all);
    areas = pocket::areas_of(copy_of(offset_.offset(all.view(), -options_.waist_mm)));
  }
  std::vector<Stroke> strokes;
  if (options_.hatch_mm > 0.0) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    const double turns = options_.turn_deg * static_cast<double>(number);
    add_hatch(areas, std::fmod(options_.angle_deg + turns, 360.0) * kDegree, strokes);
  }
  if (options_.has_contour) add_contours(areas, strokes);
  return strokes;
}

}  // namespace sim::wall
