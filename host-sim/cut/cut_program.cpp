#include "host-sim/cut/cut_program.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "host-sim/knowledge/experiment.hpp"
#include "planner/gcode/program_writer.hpp"

namespace sim::cut {
namespace {

using cnc::gcode::ProgramWriter;
using cnc::gcode::WriterError;
using Written = cnc::Result<std::string_view, WriterError>;

/// Printable ASCII without what ends a comment or acts at once on the wire.
std::string comment(const std::string& text) {
  std::string line = "(";
  for (const char c : text) {
    const bool printable = c >= ' ' && c <= '~';
    const bool acts = c == '(' || c == ')' || c == '!' || c == '?' || c == '~' || c == '%';
    line += printable && !acts ? c : '_';
  }
  return line + ")\n";
}

/// Writes the strokes of cuts one after the other.
class StrokeWriter {
 public:
  StrokeWriter(const Beam& beam, cnc::gcode::PrintGrid grid)
      : beam_{beam}, digit_mm_{1.0 / grid.per_mm()}, writer_{grid} {}

  void go_to(const Place& place) { take(writer_.rapid(place), place); }

  void write(const Cut& cut, const LayerPlan& layer) {
    const double feed = from_thousandths(layer.condition.cut.speed_um_min);
    go_to(cut.start());
    for (const Stroke& stroke : cut.strokes) {
      double stroke_feed = feed;
      if (stroke.purpose == Purpose::kPierce) {
        stroke_feed = std::min(feed, 60.0 * length_of(stroke) / layer.settings.pierce_s);
      }
      writer_.set_feed(thousandths(std::max(stroke_feed, 0.001)));
      writer_.set_power(stroke.purpose == Purpose::kTab ? 0 : power_of(layer.condition));
      if (stroke.dwell_s > 0.0) text_ += fmt::format("G4 P{:.3f}\n", stroke.dwell_s);
      write(stroke);
    }
  }

  std::string take_text() { return std::move(text_); }

 private:
  static std::uint32_t thousandths(double value) {
    return static_cast<std::uint32_t>(std::lround(1000.0 * value));
  }

  [[nodiscard]] std::uint32_t power_of(const Condition& condition) const {
    const double watts = from_thousandths(condition.cut.power_mw);
    if (watts > beam_.full_power_w) {
      throw std::invalid_argument(fmt::format(
          "{:g} W are more than the laser's {:g} W; choose less with --power, or say with "
          "--full-power what it gives",
          watts,
          beam_.full_power_w));
    }
    return thousandths(watts / beam_.full_power_w * beam_.full_power_s);
  }

  void write(const Stroke& stroke) {
    const Written written = writer_.cut(stroke.from, stroke.to, stroke.bulge);
    if (written.ok() || written.error() != WriterError::kTooFlat) return take(written, stroke.to);
    // So flat that its centre is out of reach: lines within half a digit of it.
    const double height = 0.5 * std::abs(stroke.bulge) * drawing::distance(stroke.from, stroke.to);
    const double lines = std::ceil(std::sqrt(2.0 * height / digit_mm_));
    for (double i = 0.0; i < lines; i += 1.0) {
      const Stroke part = part_of(stroke, i / lines, (i + 1.0) / lines);
      take(writer_.cut(part.from, part.to, 0.0), part.to);
    }
  }

  void take(const Written& written, const Place& place) {
    if (!written.ok()) {
      throw std::invalid_argument(
          fmt::format("X{:g} Y{:g} mm is too far from zero for a program; is the unit of the "
                      "drawing right?",
                      place.x(),
                      place.y()));
    }
    text_ += written.value();
  }

  Beam beam_;
  double digit_mm_;
  ProgramWriter writer_;
  std::string text_;
};

std::string_view kind_of(const Cut& cut, const LayerPlan& layer) {
  if (layer.settings.side == Side::kOn) return "on the line";
  return cut.is_hole ? "hole" : "outer";
}

}  // namespace

std::string program_of(const CutPlan& plan,
                       const drawing::Drawing& drawn,
                       const Beam& beam,
                       cnc::gcode::PrintGrid grid,
                       const std::vector<std::string>& heading) {
  std::string text;
  for (const std::string& line : heading) text += comment(line);
  text += fmt::format("G21 G90 G17 G94 G54\nM8\n{} S0\n", beam.follows_speed ? "M4" : "M3");
  StrokeWriter writer{beam, grid};
  for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
    const Cut& cut = plan.cuts[i];
    const LayerPlan& layer = plan.layers[cut.layer];
    text += comment(fmt::format(
        "{}: {}, {}", i + 1, kind_of(cut, layer), drawn.contours[cut.contour].entity.name));
    writer.write(cut, layer);
    text += writer.take_text();
  }
  writer.go_to({0.0, 0.0});
  return text + "M5\nM9\n" + writer.take_text() + "M2\n";
}

}  // namespace sim::cut
