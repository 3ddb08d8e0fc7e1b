#include "host-sim/cut/cut_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "host-sim/cut/cut_name.hpp"
#include "host-sim/cut/rapid_way.hpp"
#include "host-sim/knowledge/experiment.hpp"
#include "planner/gcode/program_writer.hpp"

namespace sim::cut {
namespace {

using cnc::gcode::ProgramWriter;
using cnc::gcode::WriterError;
using Written = cnc::Result<std::string_view, WriterError>;

/// Writes the strokes of cuts as G-code, one after the other.
class StrokeWriter {
 public:
  StrokeWriter(const Beam& beam, cnc::gcode::PrintGrid grid)
      : beam_{beam}, grid_{grid}, digit_mm_{1.0 / grid.per_mm()}, writer_{grid} {}

  void go_to(const Place& place) { take(writer_.rapid(place), place); }

  /// Writes the rapid before a cut or after the last cut. A lifted rapid is straight. Z returns to
  /// 0 at its end, because the beam cuts at this height.
  void go_along(const std::vector<Place>& way, double lift_mm) {
    const std::string before = std::exchange(text_, {});
    for (std::size_t i = 1; i < way.size(); ++i) go_to(way[i]);
    if (lift_mm > 0.0 && !text_.empty()) text_ = fmt::format("G0 Z{:g}\n{}Z0\n", lift_mm, text_);
    text_ = before + text_;
  }

  /// Writes a wait with the beam off. This requires M5, because M3 may keep a beam on at rest.
  void wait(double seconds) {
    if (seconds <= 0.0) return;
    text_ += fmt::format("M5\nG4 P{:.3f}\n{}\n", seconds, beam_.follows_speed ? "M4" : "M3");
  }

  /// Sets Z for a cut before the rapid to it: lower for each further pass, and 0 again for a first
  /// pass.
  void lower_to(const Cut& cut, const LayerPlan& layer) {
    const double height_mm = -layer.settings.z_step_mm * (cut.pass - 1);
    if (height_mm != 0.0) has_lowered_ = true;
    if (has_lowered_ && !writer_.set_height(height_mm)) {
      throw std::invalid_argument(fmt::format(
          "z-step={:g}: Z{:g} is too low; use fewer passes", layer.settings.z_step_mm, height_mm));
    }
  }
  void raise() {
    if (has_lowered_) static_cast<void>(writer_.set_height(0.0));
  }

  void write(const Cut& cut, const LayerPlan& layer) {
    wait(cut.wait_s);
    if (cut.picture) return burn(cut.picture->rows.text);
    if (beam_.kerf_table && !cut.programmed.empty()) return write_for_controller(cut, layer);
    for (const Stroke& stroke : cut.strokes) {
      const bool pierces = stroke.purpose == Purpose::kPierce;
      writer_.set_feed(pierces ? pierce_feed(stroke, layer) : layer.condition.cut.speed_um_min);
      writer_.set_power(has_beam(stroke.purpose) ? power_of(layer.condition) : 0);
      if (stroke.dwell_s > 0.0) text_ += fmt::format("G4 P{:.3f}\n", stroke.dwell_s);
      write(stroke);
    }
  }

  /// Writes the rows of a picture without their first line, which is the rapid that is already
  /// written. The writer does not know the motions, feeds and powers in these rows. Therefore it
  /// restarts, and its next line has all words.
  void burn(const std::string& rows) {
    text_ += rows.substr(rows.find('\n') + 1);
    writer_ = ProgramWriter{grid_};
  }

  /// Writes a cut for G42. F and S of the whole cut come before G42.
  void write_for_controller(const Cut& cut, const LayerPlan& layer) {
    const std::uint32_t feed = layer.condition.cut.speed_um_min;
    const std::uint32_t power = power_of(layer.condition);
    for (const Stroke& stroke : cut.programmed) {
      const bool pierces = stroke.purpose == Purpose::kPierce;
      if (stroke.purpose == Purpose::kLeadIn) {
        text_ +=
            fmt::format("F{:.3f} S{:.3f}\nG42\n", from_thousandths(feed), from_thousandths(power));
      }
      if (stroke.purpose == Purpose::kLeadOut) text_ += "G40\n";
      writer_.set_feed(pierces ? pierce_feed(stroke, layer) : feed);
      writer_.set_power(power);
      write(stroke);
    }
  }

  std::string take_text() { return std::move(text_); }

 private:
  static std::uint32_t thousandths(double value) {
    return static_cast<std::uint32_t>(std::lround(1000.0 * value));
  }

  /// Returns the feed, µm/min, at which a pierce takes its set time, but at most the feed of the
  /// layer.
  static std::uint32_t pierce_feed(const Stroke& stroke, const LayerPlan& layer) {
    const double feed = std::min(from_thousandths(layer.condition.cut.speed_um_min),
                                 60.0 * length_of(stroke) / layer.settings.pierce_s);
    return thousandths(std::max(feed, 0.001));
  }

  [[nodiscard]] std::uint32_t power_of(const Condition& condition) const {
    const double watts = from_thousandths(condition.cut.power_mw);
    if (watts > beam_.full_power_w) {
      throw std::invalid_argument(
          fmt::format("{:g} W are more than the laser's {:g} W; choose less with --power, or give "
                      "the laser's power with --full-power",
                      watts,
                      beam_.full_power_w));
    }
    return thousandths(watts / beam_.full_power_w * beam_.full_power_s);
  }

  void write(const Stroke& stroke) {
    const Written written = writer_.cut(stroke.from, stroke.to, stroke.bulge);
    if (written.ok() || written.error() != WriterError::kTooFlat) return take(written, stroke.to);
    // The arc is so flat that its centre is out of range. It is written as lines that deviate from
    // the arc by at most half of the last printed digit.
    const double height = 0.5 * std::abs(stroke.bulge) * drawing::distance(stroke.from, stroke.to);
    const double lines = std::ceil(std::sqrt(2.0 * height / digit_mm_));
    for (double i = 0.0; i < lines; i += 1.0) {
      const Stroke part = part_of(stroke, i / lines, (i + 1.0) / lines);
      take(writer_.cut(part.from, part.to, 0.0), part.to);
    }
  }

  void take(const Written& written, const Place& place) {
    if (!written.ok()) {
      throw std::invalid_argument(fmt::format(
          "X{:g} Y{:g} mm is too far from zero for a program; check the unit of the drawing",
          place.x(),
          place.y()));
    }
    text_ += written.value();
  }

  Beam beam_;
  cnc::gcode::PrintGrid grid_;
  double digit_mm_;
  ProgramWriter writer_;
  std::string text_;
  bool has_lowered_ = false;  ///< Whether a Z below 0 has been written.
};

std::string_view kind_of(const Cut& cut, const LayerPlan& layer) {
  if (cut.is_slice) return "waste";
  if (cut.picture) return "picture";
  if (layer.settings.side == Side::kOn) return "on the line";
  if (layer.settings.side == Side::kMark) return layer.settings.is_scored ? "scored" : "engraved";
  if (layer.settings.side == Side::kFill) return "filled";
  return cut.is_hole ? "hole" : "outer";
}

std::string_view word_of(Air air) {
  switch (air) {
    case Air::kFlood:
      return "M8\n";
    case Air::kMist:
      return "M7\n";
    case Air::kOff:
      break;
  }
  return "M9\n";
}

/// Returns `, pass 2 of 3` for a cut with several passes, otherwise an empty text.
std::string pass_text(const Cut& cut, const LayerPlan& layer) {
  const unsigned passes = layer.settings.passes;
  return passes == 1 ? "" : fmt::format(", pass {} of {}", cut.pass, passes);
}

}  // namespace

std::string comment_line(const std::string& text) {
  std::string line = "(";
  for (const char c : text) {
    const bool printable = c >= ' ' && c <= '~';
    const bool acts = c == '(' || c == ')' || c == '!' || c == '?' || c == '~' || c == '%';
    line += printable && !acts ? c : '_';
  }
  return line + ")\n";
}

std::string program_of(const CutPlan& plan,
                       const drawing::Drawing& drawn,
                       const Beam& beam,
                       cnc::gcode::PrintGrid grid,
                       const std::vector<std::string>& heading) {
  std::string text;
  for (const std::string& line : heading) text += comment_line(line);
  text += "G21 G90 G17 G94 G54\n";
  if (beam.kerf_table && !plan.cuts.empty()) {
    // All cuts of a job are made in one sheet, so the first cut has the thickness of all cuts.
    const Condition& any = plan.plan_of(plan.cuts.front()).condition;
    text +=
        fmt::format("M190 P{} Q{:g}\n", *beam.kerf_table, from_thousandths(any.cut.thickness_um));
  }
  Air air = plan.cuts.empty() ? Air::kFlood : plan.plan_of(plan.cuts.front()).settings.air;
  text += fmt::format("{}{} S0\n", word_of(air), beam.follows_speed ? "M4" : "M3");
  StrokeWriter writer{beam, grid};
  for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
    const Cut& cut = plan.cuts[i];
    const LayerPlan& layer = plan.plan_of(cut);
    text += comment_line(fmt::format("{}: {}, {}{}",
                                     i + 1,
                                     kind_of(cut, layer),
                                     entity_of(cut, drawn).name,
                                     pass_text(cut, layer)));
    if (layer.settings.air != air) {
      // M7 and M8 may be active at the same time, so the previous gas is switched off first.
      if (air != Air::kOff) text += word_of(Air::kOff);
      if (layer.settings.air != Air::kOff) text += word_of(layer.settings.air);
      air = layer.settings.air;
    }
    writer.lower_to(cut, layer);
    writer.go_along(rapid_before(plan, i), cut.lift_mm);
    writer.write(cut, layer);
    text += writer.take_text();
  }
  writer.raise();
  writer.go_along(rapid_before(plan, plan.cuts.size()), plan.lift_home_mm);
  return text + "M5\nM9\n" + writer.take_text() + "M2\n";
}

}  // namespace sim::cut
