#include "host-sim/surface/path/surface_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <variant>

#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/surface/path/ramp_entry.hpp"
#include "planner/gcode/program_writer.hpp"

namespace sim::surface {
namespace {

using cnc::Plane;
using cnc::WideVec2;
using cnc::gcode::WriterError;
using Written = cnc::Result<std::string_view, WriterError>;

/// Directions of an element at its start and at its end, in radians from the horizontal.
struct ElementCourse {
  double begin;
  double end;

  ElementCourse(const ContourVertex& from, const ContourVertex& to) {
    const double across = std::atan2(to.y - from.y, to.x - from.x);
    const double half_turn = 2.0 * std::atan(from.bulge);
    begin = across - half_turn;
    end = across + half_turn;
  }

  /// Returns the greatest ratio of descending speed to feed along the element; 0 for an element
  /// that never descends.
  [[nodiscard]] double descent() const { return std::max({0.0, -std::sin(begin), -std::sin(end)}); }
};

cut::Stroke stroke_of(const ContourVertex& from, const ContourVertex& to) {
  return {.from = {from.x, from.y}, .to = {to.x, to.y}, .bulge = from.bulge};
}

/// Updates the figures with the heights of an element, also between its ends.
void note_heights(const SurfaceStretch& stretch,
                  const ContourVertex& from,
                  const ContourVertex& to,
                  SurfaceProgramFigures& figures) {
  const auto note = [&figures](double height) {
    figures.lowest_mm = std::min(figures.lowest_mm, height);
    figures.highest_mm = std::max(figures.highest_mm, height);
  };
  note(stretch.place_of(from).z());
  note(stretch.place_of(to).z());
  if (std::holds_alternative<LevelPlane>(stretch.plane)) return;
  const ElementCourse course{from, to};
  if (course.begin * course.end >= 0.0) return;
  const double level = course.begin / (course.begin - course.end);
  note(cut::place_at(stroke_of(from, to), level).y());
}

/// Converts the coordinates of a stretch's plane to the plane of a program (G17, G18 or G19).
class WriterPlane {
 public:
  explicit WriterPlane(const StretchPlane& plane) {
    if (const auto* level = std::get_if<LevelPlane>(&plane)) {
      level_mm_ = level->height_mm;
      return;
    }
    slice_ = std::get<Slice>(plane);
    if (slice_.direction.y() == 0.0) plane_ = Plane::kZX;
    if (slice_.direction.x() == 0.0) plane_ = Plane::kYZ;
  }

  [[nodiscard]] Plane plane() const { return plane_; }
  [[nodiscard]] WideVec2 place(const ContourVertex& vertex) const {
    if (level_mm_) return {vertex.x, vertex.y};
    WideVec2 seen = slice_.at(vertex.x);
    if (plane_ == Plane::kZX) return {vertex.y, seen.x()};
    if (plane_ == Plane::kYZ) return {seen.y(), vertex.y};
    return seen;
  }
  /// Returns the coordinate along the plane's normal.
  [[nodiscard]] double height(const ContourVertex& vertex) const {
    if (level_mm_) return *level_mm_;
    if (plane_ == Plane::kZX) return slice_.from.y();
    if (plane_ == Plane::kYZ) return slice_.from.x();
    return vertex.y;
  }
  [[nodiscard]] double bulge(const ContourVertex& vertex) const {
    if (level_mm_) return vertex.bulge;
    if (plane_ == Plane::kZX) return -slice_.direction.x() * vertex.bulge;
    return slice_.direction.y() * vertex.bulge;
  }

 private:
  Slice slice_;
  std::optional<double> level_mm_;
  Plane plane_ = Plane::kXY;
};

/// Writes the runs of a path, one after another.
class RunWriter {
 public:
  RunWriter(const pocket::MillSettings& mill,
            cnc::gcode::PrintGrid grid,
            std::optional<double> ramp_slope)
      : mill_{mill}, ramp_slope_{ramp_slope}, digit_mm_{1.0 / grid.per_mm()}, writer_{grid} {
    writer_.leave_power();
  }

  /// Descends to the start of a run: in a rapid down to the height where stock may begin, then at
  /// the plunge feed. Uses a ramp instead if a slope is set and the run is long enough.
  void begin_run(std::span<const SurfaceStretch> run, double stock_mm) {
    const SurfaceStretch& first = run.front();
    const WideVec2 place = first.start().head<2>();
    const double height = first.start().z();
    set_height(mill_.safe_mm, place);
    take(writer_.rapid(place), place);
    const double top = std::min(mill_.safe_mm, std::max(height, stock_mm) + mill_.near_mm);
    set_height(top, place);
    take(writer_.rapid(place), place);
    if (ramp_slope_) write_ramp(run, top);
    writer_.set_feed(thousandths(mill_.plunge_mm_min));
    set_height(height, place);
    take(writer_.cut(place, place, 0.0), place);
  }

  void write(const SurfaceStretch& stretch) {
    const WriterPlane plane{stretch.plane};
    const bool is_level = std::holds_alternative<LevelPlane>(stretch.plane);
    const bool is_slow = stretch.use == StretchUse::kSlot && mill_.slot_feed_mm_min > 0.0;
    const double feed = is_slow ? mill_.slot_feed_mm_min : mill_.feed_mm_min;
    text_ += writer_.use_plane(plane.plane());
    for (std::size_t i = 0; i + 1 < stretch.vertices.size(); ++i) {
      const ContourVertex& from = stretch.vertices[i];
      const ContourVertex& to = stretch.vertices[i + 1];
      writer_.set_feed(thousandths(is_level ? feed : feed_of(from, to, feed)));
      set_height(plane.height(to), stretch.place_of(to).head<2>());
      write_element({.from = plane.place(from), .to = plane.place(to), .bulge = plane.bulge(from)});
    }
  }

  void end_run(const SurfaceStretch& last) {
    const WideVec2 place = last.end().head<2>();
    text_ += writer_.use_plane(Plane::kXY);
    set_height(mill_.safe_mm, place);
    take(writer_.rapid(place), place);
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static std::uint32_t thousandths(double value) {
    return static_cast<std::uint32_t>(std::lround(1000.0 * value));
  }

  /// @param feed feed if the tip does not descend too fast
  [[nodiscard]] double feed_of(const ContourVertex& from,
                               const ContourVertex& to,
                               double feed) const {
    const double descent = ElementCourse{from, to}.descent();
    if (descent * feed <= mill_.plunge_mm_min) return feed;
    return mill_.plunge_mm_min / descent;
  }

  void write_ramp(std::span<const SurfaceStretch> run, double top_mm) {
    Eigen::Vector3d here = run.front().start();
    here.z() = top_mm;
    for (const Eigen::Vector3d& tip : ramp_entry(run, top_mm, *ramp_slope_)) {
      const Eigen::Vector3d way = tip - here;
      const double descent = std::max(0.0, -way.z()) / way.norm();
      const bool is_steep = descent * mill_.feed_mm_min > mill_.plunge_mm_min;
      writer_.set_feed(thousandths(is_steep ? mill_.plunge_mm_min / descent : mill_.feed_mm_min));
      const WideVec2 from = here.head<2>();
      const WideVec2 place = tip.head<2>();
      set_height(tip.z(), place);
      take(writer_.cut(from, place, 0.0), place);
      here = tip;
    }
    writer_.set_feed(thousandths(mill_.plunge_mm_min));
  }

  void write_element(const cut::Stroke& stroke) {
    const Written written = writer_.cut(stroke.from, stroke.to, stroke.bulge);
    if (written.ok() || written.error() != WriterError::kTooFlat) return take(written, stroke.to);
    // The centre of such a flat arc is too far away for a program. Lines replace the arc, within
    // half a unit of the last digit.
    const double height = 0.5 * std::abs(stroke.bulge) * cut::length_of(stroke);
    const double lines = std::ceil(std::sqrt(2.0 * height / digit_mm_));
    for (double i = 0.0; i < lines; i += 1.0) {
      const cut::Stroke part = cut::part_of(stroke, i / lines, (i + 1.0) / lines);
      take(writer_.cut(part.from, part.to, 0.0), part.to);
    }
  }

  void set_height(double height_mm, const WideVec2& place) {
    if (!writer_.set_height(height_mm)) refuse(place);
  }

  void take(const Written& written, const WideVec2& place) {
    if (!written.ok()) refuse(place);
    text_ += written.value();
  }

  [[noreturn]] static void refuse(const WideVec2& place) {
    throw std::invalid_argument(fmt::format(
        "X {:g}, Y {:g} mm is too far from zero for a program; check the unit of the surface",
        place.x(),
        place.y()));
  }

  pocket::MillSettings mill_;
  std::optional<double> ramp_slope_;
  double digit_mm_;
  cnc::gcode::ProgramWriter writer_;
  std::string text_;
};

}  // namespace

SurfaceProgramFigures figures_of(const SurfacePath& path) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  SurfaceProgramFigures figures{
      .lifts = path.runs.size(), .lowest_mm = kInfinite, .highest_mm = -kInfinite};
  for (const SurfaceStretch& stretch : path.stretches) {
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < stretch.vertices.size(); ++i) {
      const ContourVertex& from = stretch.vertices[i];
      const ContourVertex& to = stretch.vertices[i + 1];
      length += cut::length_of(stroke_of(from, to));
      note_heights(stretch, from, to, figures);
      ++(from.bulge == 0.0 ? figures.lines : figures.arcs);
    }
    (stretch.use == StretchUse::kLink ? figures.link_mm : figures.row_mm) += length;
  }
  return figures;
}

std::string program_of(const SurfacePath& path,
                       const pocket::MillSettings& mill,
                       cnc::gcode::PrintGrid grid,
                       const std::vector<std::string>& heading,
                       std::optional<double> ramp_slope) {
  std::string text;
  for (const std::string& line : heading) text += cut::comment_line(line);
  text += pocket::opening_of(mill);
  RunWriter writer{mill, grid, ramp_slope};
  std::size_t begin = 0;
  for (const SurfaceRun& run : path.runs) {
    const std::span stretches{path.stretches.data() + begin, run.end - begin};
    writer.begin_run(stretches, run.stock_mm);
    for (const SurfaceStretch& stretch : stretches) writer.write(stretch);
    writer.end_run(stretches.back());
    begin = run.end;
  }
  return text + writer.text() + pocket::closing_of(mill);
}

}  // namespace sim::surface
