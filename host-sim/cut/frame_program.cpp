#include "host-sim/cut/frame_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry/algorithms/convex_hull.hpp>
#include <boost/geometry/algorithms/envelope.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <stdexcept>

#include "planner/gcode/program_writer.hpp"

namespace sim::cut {
namespace {

using HullPoint = boost::geometry::model::d2::point_xy<double>;

/// Appends points of a stroke. The chords between them deviate from the stroke by at most
/// kFrameToleranceMm.
void add_places(const Stroke& stroke, boost::geometry::model::multi_point<HullPoint>& places) {
  const double chord = drawing::distance(stroke.from, stroke.to);
  const double sweep = 4.0 * std::atan(std::abs(stroke.bulge));
  int count = 1;
  if (sweep > 0.0 && chord > 0.0) {
    const double radius = 0.5 * chord / std::sin(0.5 * sweep);
    // A chord of angle a deviates from its arc by r (1 - cos(a / 2)), which is below r a² / 8.
    const double angle = std::sqrt(8.0 * kFrameToleranceMm / radius);
    count = static_cast<int>(std::ceil(std::max(sweep / angle, 4.0)));
  }
  for (int i = 0; i <= count; ++i) {
    const Place place = place_at(stroke, static_cast<double>(i) / count);
    places.emplace_back(place.x(), place.y());
  }
}

std::vector<Place> corners_of(const boost::geometry::model::multi_point<HullPoint>& places,
                              FrameShape shape) {
  std::vector<Place> corners;
  if (shape == FrameShape::kBox) {
    const auto box =
        boost::geometry::return_envelope<boost::geometry::model::box<HullPoint>>(places);
    const HullPoint& least = box.min_corner();
    const HullPoint& most = box.max_corner();
    return {
        {least.x(), least.y()}, {most.x(), least.y()}, {most.x(), most.y()}, {least.x(), most.y()}};
  }
  boost::geometry::model::polygon<HullPoint, false> hull;
  boost::geometry::convex_hull(places, hull);
  for (const HullPoint& point : hull.outer()) corners.emplace_back(point.x(), point.y());
  // The ring ends at its first point. If all points are on one line, corners are repeated.
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
  return corners;
}

}  // namespace

std::vector<Place> frame_of(const CutPlan& plan, FrameShape shape) {
  boost::geometry::model::multi_point<HullPoint> places;
  for (const Cut& cut : plan.cuts) {
    for (const Stroke& stroke : cut.strokes) add_places(stroke, places);
    for (const Stroke& stroke : cut.programmed) add_places(stroke, places);
  }
  if (places.empty()) return {};
  return corners_of(places, shape);
}

std::string frame_program(const std::vector<Place>& frame,
                          const FrameSettings& settings,
                          const Beam& beam,
                          cnc::gcode::PrintGrid grid,
                          const std::vector<std::string>& heading) {
  const auto thousandths = [](double value) {
    return static_cast<std::uint32_t>(std::lround(1000.0 * value));
  };
  std::string text;
  for (const std::string& line : heading) text += comment_line(line);
  text += "G21 G90 G17 G94 G54\nM5\n";
  cnc::gcode::ProgramWriter writer{grid};
  const auto take = [&text](const auto& written, const Place& place) {
    if (!written.ok()) {
      throw std::invalid_argument(
          fmt::format("X{:g} Y{:g} mm is too far from zero for a program; check the unit",
                      place.x(),
                      place.y()));
    }
    text += written.value();
  };
  take(writer.rapid(frame.front()), frame.front());
  writer.set_feed(thousandths(settings.feed_mm_min));
  const bool has_light = settings.power_share > 0.0;
  if (has_light) {
    text += "M4 S0\n";
    writer.set_power(thousandths(settings.power_share * beam.full_power_s));
  }
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Place& to = frame[(i + 1) % frame.size()];
    take(writer.cut(frame[i], to, 0.0), to);
  }
  if (has_light) text += "M5\n";
  const Place zero{0.0, 0.0};
  take(writer.rapid(zero), zero);
  return text + "M2\n";
}

}  // namespace sim::cut
