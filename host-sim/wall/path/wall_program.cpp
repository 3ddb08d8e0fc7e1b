#include "host-sim/wall/path/wall_program.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "host-sim/cut/cut_program.hpp"
#include "host-sim/wall/axis_angle.hpp"
#include "host-sim/wall/beam_text.hpp"
#include "planner/base/wide_scalar_math.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector3d;

/// Digits after the decimal point of angles. At 1 mm above the tip, their rounding moves the beam's
/// side by 9e-8 mm.
constexpr int kAngleDecimals = 5;

/// Returns a number with up to `decimals` decimals, without trailing zeros and without -0.
std::string number_text(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

/// A tip, and the rotary words at this tip.
struct Knot {
  Vector3d tip;
  RotaryWords words;
};

/// Returns whether all axes of the machine continue their linear motion at `here`, so that this
/// knot can be left out.
bool goes_straight_on(const Knot& before, const Knot& here, const Knot& after) {
  constexpr double kSameMm = 1.0e-9;
  constexpr double kSameDeg = 1.0e-7;
  const Vector3d whole = after.tip - before.tip;
  const double length = whole.norm();
  if (length == 0.0) return false;
  const double share = (here.tip - before.tip).norm() / length;
  const auto is_off = [share](double from, double over, double to) {
    return std::abs(over - from - share * (to - from)) > kSameDeg;
  };
  return (before.tip + share * whole - here.tip).norm() <= kSameMm &&
         !is_off(before.words.tilt, here.words.tilt, after.words.tilt) &&
         !is_off(before.words.turn, here.words.turn, after.words.turn);
}

double lean_of(const Vector3d& axis) {
  return cnc::wide_atan2(std::hypot(axis.x(), axis.y()), axis.z());
}

}  // namespace

WallProgram::WallProgram(const BurnSettings& settings, const std::vector<std::string>& heading)
    : settings_{settings}, shown_(5) {
  for (const std::string& line : heading) text_ += cut::comment_line(line);
  text_ += fmt::format("G21 G90 G17 G94 G54\nG0 Z{}\nG0 {}0 C0\nG43.4\n{} S0\n",
                       number_text(settings.safe_mm, settings.decimals),
                       settings.axes == RotaryAxes::kAC ? 'A' : 'B',
                       settings.follows_speed ? "M4" : "M3");
}

/// Returns the rotary words of each beam of a run. Along a stretch with an upright beam, C turns to
/// the angle that the next leaning beam requires.
std::vector<RotaryWords> WallProgram::words_of_run(const std::vector<TipBeam>& beams) const {
  std::vector<RotaryWords> words;
  RotaryWords last = last_;
  bool has_leant = false;
  for (const TipBeam& beam : beams) {
    words.push_back(wall::words_of(settings_.axes, beam.axis, last));
    const bool leans = words.back().tilt != 0.0;
    if (leans && !has_leant) {
      for (RotaryWords& upright : words) upright.turn = words.back().turn;
    }
    has_leant = has_leant || leans;
    last = words.back();
  }
  for (std::size_t i = 1; i + 1 < words.size(); ++i) {
    if (words[i].tilt != 0.0 || words[i - 1].tilt == 0.0) continue;
    std::size_t end = i;
    while (end < words.size() && words[end].tilt == 0.0) ++end;
    if (end == words.size()) break;
    const double whole = (beams[end - 1].tip - beams[i].tip).norm();
    const double from = words[i].turn;
    for (std::size_t k = i + 1; k < end; ++k) {
      const double share = (beams[k].tip - beams[i].tip).norm() / whole;
      words[k].turn = from + share * (words[end].turn - from);
    }
  }
  return words;
}

void WallProgram::write_move(const char* motion, const Vector3d& tip, const RotaryWords& words) {
  const std::array<std::string, 5> values{
      "X" + number_text(tip.x(), settings_.decimals),
      "Y" + number_text(tip.y(), settings_.decimals),
      "Z" + number_text(tip.z(), settings_.decimals),
      (settings_.axes == RotaryAxes::kAC ? "A" : "B") + number_text(words.tilt, kAngleDecimals),
      "C" + number_text(words.turn, kAngleDecimals)};
  std::string line;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (shown_[i] == values[i]) continue;
    shown_[i] = values[i];
    line += " " + values[i];
  }
  if (!line.empty()) text_ += motion + line;
}

/// Turns C to the angle that the next leaning beam requires, with the beam off and upright. This
/// motion is necessary if there was no upright stretch on which C could turn.
void WallProgram::write_swing(const Eigen::Vector3d& tip,
                              const RotaryWords& from,
                              const RotaryWords& to) {
  if (from.tilt != 0.0 || to.tilt == 0.0 || std::abs(from.turn - to.turn) <= kNoTiltDeg) return;
  write_move("G0", tip, {0.0, to.turn});
  text_ += '\n';
}

/// Returns the feed between two beams. It is reduced if the angular speed of the axis would exceed
/// the permitted turn per mm times the full feed.
double WallProgram::feed_of(const TipBeam& from, const TipBeam& to) const {
  const double most = settings_.turn_rate_rad_per_mm * (to.tip - from.tip).norm();
  const double angle = angle_between(from.axis, to.axis);
  // Ratio of angle to permitted angle up to which an excess is only rounding.
  constexpr double kAlmost = 1.0001;
  if (angle <= kAlmost * most) return settings_.feed_mm_min;
  return settings_.feed_mm_min * most / angle;
}

void WallProgram::write_run(const std::vector<TipBeam>& beams) {
  const std::vector<RotaryWords> words = words_of_run(beams);
  const std::size_t before = text_.size();
  write_move("G0", beams.front().tip, words.front());
  if (text_.size() > before) text_ += '\n';
  std::size_t written = 0;  // Index of the last beam that was written.
  bool has_power = false;
  for (std::size_t i = 1; i < beams.size(); ++i) {
    const bool is_last = i + 1 == beams.size();
    const Knot start{beams[written].tip, words[written]};
    if (!is_last &&
        goes_straight_on(start, {beams[i].tip, words[i]}, {beams[i + 1].tip, words[i + 1]})) {
      continue;
    }
    write_swing(start.tip, start.words, words[i]);
    const std::size_t length = text_.size();
    write_move("G1", beams[i].tip, words[i]);
    if (text_.size() == length) continue;
    const std::string feed = number_text(feed_of(beams[written], beams[i]), 3);
    if (feed != feed_) text_ += " F" + feed;
    if (!has_power) text_ += " S" + number_text(settings_.power_s, 3);
    feed_ = feed;
    has_power = true;
    written = i;
    text_ += '\n';
  }
  last_ = words.back();
}

void WallProgram::measure(const std::vector<TipBeam>& beams) {
  ++figures_.runs;
  figures_.beams += beams.size();
  if (figures_.runs > 1) figures_.dark_mm += (beams.front().tip - here_).norm();
  here_ = beams.back().tip;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double tilt = lean_of(beams[i].axis);
    figures_.max_tilt_rad = std::max(figures_.max_tilt_rad, tilt);
    if (beams[i].left_rad > 0.0) ++figures_.overlaps;
    figures_.max_overlap_rad = std::max(figures_.max_overlap_rad, beams[i].left_rad);
    if (i == 0) continue;
    const double length = (beams[i].tip - beams[i - 1].tip).norm();
    const Vector3d& last = beams[i - 1].axis;
    const double turn = angle_between(last, beams[i].axis);
    if (feed_of(beams[i - 1], beams[i]) < settings_.feed_mm_min) figures_.slowed_mm += length;
    figures_.burnt_mm += length;
    figures_.tilt_mm += 0.5 * length * (tilt + lean_of(last));
    if (length > 0.0) {
      figures_.max_turn_rad_per_mm = std::max(figures_.max_turn_rad_per_mm, turn / length);
    }
  }
}

void WallProgram::add(const std::vector<BeamRun>& runs) {
  for (const BeamRun& run : runs) {
    figures_.lost += run.lost.size();
    if (run.beams.empty()) continue;
    measure(run.beams);
    write_run(run.beams);
  }
}

std::string WallProgram::take_text() {
  const char* tilt = settings_.axes == RotaryAxes::kAC ? "A" : "B";
  text_ += fmt::format(
      "M5\nG0 Z{} {}0\nG49\nM2\n", number_text(settings_.safe_mm, settings_.decimals), tilt);
  return std::move(text_);
}

void append_beam_lines(const std::vector<BeamRun>& runs, std::string& text) {
  for (const BeamRun& run : runs) {
    for (const Vector3d& tip : run.lost) append_lost_line(tip, text);
    for (const TipBeam& beam : run.beams) append_beam_line(beam.tip, beam.axis, text);
  }
}

}  // namespace sim::wall
