#include "host-sim/pocket/mill_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/stroke.hpp"
#include "planner/gcode/program_writer.hpp"

namespace sim::pocket {
namespace {

using cnc::gcode::WriterError;
using cnc::pocket::Use;
using Point = cnc::pocket::PathPoint<double>;
using Written = cnc::Result<std::string_view, WriterError>;

/// Writes rows of a tool path, one after another.
class RowWriter {
 public:
  RowWriter(const MillSettings& mill, cnc::gcode::PrintGrid grid)
      : mill_{mill}, digit_mm_{1.0 / grid.per_mm()}, writer_{grid} {
    writer_.leave_power();
  }

  void write(cnc::contour::Slice<const Point> row) {
    const Point& first = row[0];
    rapid_to(first, mill_.safe_mm);
    rapid_to(first, std::min(mill_.safe_mm, first.z + mill_.near_mm));
    writer_.set_feed(thousandths(mill_.plunge_mm_min));
    set_height(first, first.z);
    take(writer_.cut(first.point(), first.point(), 0.0), first);
    for (std::size_t i = 0; i + 1 < row.size(); ++i) write_element(row[i], row[i + 1]);
    rapid_to(row[row.size() - 1], mill_.safe_mm);
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static std::uint32_t thousandths(double value) {
    return static_cast<std::uint32_t>(std::lround(1000.0 * value));
  }

  /// Returns the feed of an element, limited so that the element descends no faster than a plunge.
  [[nodiscard]] double feed_of(const cut::Stroke& stroke, double rise_mm, Use use) const {
    const bool is_raised = use == Use::kLight && mill_.light_feed_mm_min > 0.0;
    const double feed = is_raised ? mill_.light_feed_mm_min : mill_.feed_mm_min;
    if (rise_mm >= 0.0) return feed;
    const double length_mm = std::hypot(cut::length_of(stroke), rise_mm);
    return std::min(feed, mill_.plunge_mm_min * length_mm / -rise_mm);
  }

  /// Writes a return at depth. Its middle part, at least `near_mm` away from the cuts, is a rapid.
  /// The rest is driven at the feed.
  void write_return(const Point& from, const Point& to) {
    const cnc::WideVec2 way = to.point() - from.point();
    const double share = mill_.near_mm / way.norm();
    const cnc::WideVec2 begin = from.point() + share * way;
    const cnc::WideVec2 end = to.point() - share * way;
    writer_.set_feed(thousandths(mill_.feed_mm_min));
    set_height(to, to.z);
    take(writer_.cut(from.point(), begin, 0.0), from);
    take(writer_.rapid(end), to);
    take(writer_.cut(end, to.point(), 0.0), to);
  }

  /// Begins or ends the compensation for the tool's wear.
  void write_compensation(Use use) {
    if (mill_.wear_tool == 0) return;
    if (use == Use::kLeadIn) {
      text_ += fmt::format("{} D{}\n", mill_.wears_to_left ? "G41" : "G42", mill_.wear_tool);
    } else if (use == Use::kLeadOut) {
      text_ += "G40\n";
    }
  }

  /// Returns whether a return stays at one depth and is long enough for a rapid.
  [[nodiscard]] bool is_rapid(const Point& from, const Point& to) const {
    constexpr double kMinMargins = 3.0;
    return from.use == Use::kReturn && from.bulge == 0.0 && from.z == to.z &&
           (to.point() - from.point()).norm() >= kMinMargins * mill_.near_mm;
  }

  void write_element(const Point& from, const Point& to) {
    write_compensation(from.use);
    if (is_rapid(from, to)) return write_return(from, to);
    const cut::Stroke stroke{.from = from.point(), .to = to.point(), .bulge = from.bulge};
    writer_.set_feed(thousandths(feed_of(stroke, to.z - from.z, from.use)));
    set_height(to, to.z);
    const Written written = writer_.cut(stroke.from, stroke.to, stroke.bulge);
    if (written.ok() || written.error() != WriterError::kTooFlat) return take(written, to);
    write_flat(stroke, from, to);
  }

  /// Writes an arc as lines that deviate from it by at most half a unit of the last written digit.
  /// Used for an arc so flat that its centre is out of range.
  void write_flat(const cut::Stroke& stroke, const Point& from, const Point& to) {
    const double height = 0.5 * std::abs(stroke.bulge) * drawing::distance(stroke.from, stroke.to);
    const double lines = std::ceil(std::sqrt(2.0 * height / digit_mm_));
    for (double i = 0.0; i < lines; i += 1.0) {
      const cut::Stroke part = part_of(stroke, i / lines, (i + 1.0) / lines);
      set_height(to, from.z + (to.z - from.z) * (i + 1.0) / lines);
      take(writer_.cut(part.from, part.to, 0.0), to);
    }
  }

  void rapid_to(const Point& point, double height_mm) {
    set_height(point, height_mm);
    take(writer_.rapid(point.point()), point);
  }

  void set_height(const Point& point, double height_mm) {
    if (!writer_.set_height(height_mm)) refuse(point);
  }

  void take(const Written& written, const Point& point) {
    if (!written.ok()) refuse(point);
    text_ += written.value();
  }

  [[noreturn]] static void refuse(const Point& point) {
    throw std::invalid_argument(fmt::format(
        "X{:g} Y{:g} Z{:g} mm is too far from zero for a program; check the unit of the drawing",
        point.x,
        point.y,
        point.z));
  }

  MillSettings mill_;
  double digit_mm_;
  cnc::gcode::ProgramWriter writer_;
  std::string text_;
};

}  // namespace

std::string opening_of(const MillSettings& mill) {
  // The tool must leave the stock before the spindle starts.
  std::string text = fmt::format("G21 G90 G17 G94 G54\nG0 Z{:g}\n", mill.safe_mm);
  if (mill.spindle_rpm > 0.0) {
    text += fmt::format("S{:g} {}\n", mill.spindle_rpm, mill.turns_left ? "M4" : "M3");
    if (mill.spin_up_s > 0.0) text += fmt::format("G4 P{:g}\n", mill.spin_up_s);
  }
  if (mill.coolant != Coolant::kOff) text += mill.coolant == Coolant::kMist ? "M7\n" : "M8\n";
  return text;
}

std::string closing_of(const MillSettings& mill) {
  std::string text;
  if (mill.coolant != Coolant::kOff) text += "M9\n";
  if (mill.spindle_rpm > 0.0) text += "M5\n";
  return text + "M2\n";
}

std::string program_of(const cnc::pocket::ToolPathView<double>& path,
                       const MillSettings& mill,
                       cnc::gcode::PrintGrid grid,
                       const std::vector<std::string>& heading) {
  std::string text;
  for (const std::string& line : heading) text += cut::comment_line(line);
  text += opening_of(mill);
  RowWriter writer{mill, grid};
  for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
    const std::uint32_t begin = path.row_begin(row);
    const std::uint32_t end = path.row_ends[row];
    if (begin < end) writer.write({path.points.begin() + begin, end - begin});
  }
  return text + writer.text() + closing_of(mill);
}

}  // namespace sim::pocket
