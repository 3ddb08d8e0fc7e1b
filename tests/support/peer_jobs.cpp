#include "tests/support/peer_jobs.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "firmware/machine/configuration.hpp"
#include "host-sim/machine/simulator.hpp"
#include "host-sim/measure/driven_path.hpp"
#include "tests/support/bench_jobs.hpp"
#include "tests/support/product_limits.hpp"

namespace proof {
namespace {

constexpr double kStepsPerMm = 250.0;
constexpr double kRate = 12'000.0;  // Rate of X and Y, mm/min.
constexpr const char* kOpening = "G21 G90 G17 F12000\n";

std::string square() { return std::string{kOpening} + "G1 X100 Y0\nX100 Y100\nX0 Y100\nX0 Y0\n"; }

std::string circle() {
  return std::string{kOpening} + "G1 Y20\nG2 X40 Y20 I20 J0\nG2 X0 Y20 I-20 J0\n";
}

std::string chords() {
  constexpr int kChords = 720;
  std::string text = std::string{kOpening} + "G1 Y20\n";
  for (int i = 1; i <= kChords; ++i) {
    const double angle = std::numbers::pi * (1.0 - 2.0 * i / kChords);
    const double x = 20.0 + 20.0 * std::cos(angle);
    text += fmt::format("G1 X{:.4f} Y{:.4f}\n", x, 20.0 + 20.0 * std::sin(angle));
  }
  return text;
}

sim::PathPiece tangent_arc(const sim::Point& start, double length, double from, double to) {
  const double sweep = to - from;
  const double radius = length / sweep;
  const std::array centre{start[0] - radius * std::sin(from), start[1] + radius * std::cos(from)};
  sim::Point end = start;
  end[0] = centre[0] + radius * std::sin(to);
  end[1] = centre[1] - radius * std::cos(to);
  return {.curve = sim::Curve::arc(start, end, cnc::Plane::kXY, centre, sweep < 0.0),
          .travel = sim::Travel::kFeed,
          .feed = kRate / 60.0};
}

/// Returns the curve of freeform_job, as arcs through the ends of its chords.
sim::ProgrammedPath freeform_curve(int lines) {
  constexpr double kStep = 0.1;  // mm
  const auto direction = [](double s) {
    return 1.5 * std::sin(s / 9.0) + 0.8 * std::sin(s / 31.0) + s / 40.0;
  };
  sim::ProgrammedPath path;
  sim::Point place{100.0, 100.0};
  for (int i = 0; i < lines; ++i) {
    const double from = direction(kStep * (i - 0.5));
    double to = direction(kStep * (i + 0.5));
    // Arcs must not be straight: a straight one gets a minimal sweep.
    if (std::abs(to - from) < 1.0e-7) to = from + 1.0e-7;
    path.pieces.push_back(tangent_arc(place, kStep, from, to));
    place = path.pieces.back().curve.end();
  }
  return path;
}

std::string at_full_feed(std::string text) {
  const std::string slow = "F6000";
  return text.replace(text.find(slow), slow.size(), "F12000");
}

/// Returns 20 rows of 100 mm, back and forth, 0.1 mm apart. Each pixel of 0.1 mm is a line with its
/// S.
std::string raster() {
  constexpr int kRows = 20;
  constexpr int kPixels = 1000;
  std::string text = std::string{kOpening} + "M4 S0\n";
  for (int row = 0; row < kRows; ++row) {
    if (row > 0) text += fmt::format("G1 Y{:.1f} S0\n", 0.1 * row);
    for (int i = 1; i <= kPixels; ++i) {
      const int pixel = row % 2 == 0 ? i : kPixels - i;
      text += fmt::format("G1 X{:.1f} S{}\n", 0.1 * pixel, (i * 37 + row * 11) % 1000);
    }
  }
  return text + "M5\n";
}

std::string zigzag() {
  std::string text = kOpening;
  for (int i = 1; i <= 40; ++i) text += fmt::format("G1 X{} Y{}\n", 5 * i, i % 2 == 0 ? 0 : 50);
  return text;
}

/// Runs the job to its end. Returns the tick at which motion began, which is the boundary of a
/// cycle.
std::uint64_t run(sim::Simulator& simulator) {
  std::uint64_t began = 0;
  for (bool moved = false; !simulator.done();) {
    const std::uint64_t boundary = simulator.now_ticks();
    simulator.turn();
    if (!moved && simulator.moves()) began = boundary;
    moved = moved || simulator.moves();
  }
  return began;
}

void change(sim::Simulator& simulator, std::uint16_t number, double value) {
  if (!simulator.change_setting(number, static_cast<float>(value)).empty()) std::abort();
}

}  // namespace

std::vector<PeerJob> peer_jobs() {
  const std::string freeform = at_full_feed(cnc::test::freeform_job(20'000));
  const std::string arcs = at_full_feed(cnc::test::arc_job(400));
  std::vector<PeerJob> jobs;
  const auto add = [&jobs](const char* name, std::string program, double acceleration) -> PeerJob& {
    return jobs.emplace_back(PeerJob{name, std::move(program), acceleration, {}, {}, true});
  };
  for (const double acceleration : {500.0, 3000.0}) {
    const bool slow = acceleration < 1000.0;
    PeerJob& of_square = add("square 100 mm", square(), acceleration);
    if (slow) of_square.peers = {3.551, 3.602, "LinuxCNC, exact stops"};
    PeerJob& of_circle = add("circle R20, two G2", circle(), acceleration);
    of_circle.peers =
        slow ? PeerTimes{1.617, 1.637, "Klipper"} : PeerTimes{0.794, 0.795, "grblHAL"};
    PeerJob& of_chords = add("the same as 720 chords", chords(), acceleration);
    if (slow) of_chords.peers = {1.613, 1.677, "Klipper"};
    of_chords.curve = sim::read_program(circle());
    of_chords.in_sight = false;
    PeerJob& of_freeform = add("20,000 x 0.1 mm freeform", freeform, acceleration);
    of_freeform.curve = freeform_curve(20'000);
    of_freeform.in_sight = false;
    add("400 tangent arcs", arcs, acceleration);
    add("raster, 20,000 S", raster(), acceleration);
    add("zig-zag", zigzag(), acceleration);
  }
  return jobs;
}

PeerResult run_peer_job(const PeerJob& job, double rise) {
  sim::Simulator simulator{job.program, {}};
  change(simulator, 32, 1.0);
  change(simulator, 11, 0.01);
  for (std::uint16_t axis = 0; axis < 2; ++axis) {
    change(simulator, static_cast<std::uint16_t>(100 + axis), kStepsPerMm);
    change(simulator, static_cast<std::uint16_t>(110 + axis), kRate);
    change(simulator, static_cast<std::uint16_t>(120 + axis), job.acceleration);
    if (rise > 0.0) {
      change(simulator, static_cast<std::uint16_t>(800 + axis), job.acceleration / rise);
    }
  }
  PeerResult result;
  const cnc::motion::Limits product = cnc::limits_from(simulator.settings());
  result.path = sim::driven_path(
      sim::read_program(job.program, sim::read_options_for(simulator.settings())), product);
  result.limits = limits_of(product);
  if (rise > 0.0) result.limits.jerk.fill(job.acceleration / rise);
  const std::uint64_t began = run(simulator);
  const sim::RunResult end = simulator.result();
  result.start_seconds = static_cast<double>(began) / cnc::motion::kTicksPerSecond;
  result.seconds = end.job_time_s - result.start_seconds;
  result.refusals = end.refusals.size() + (end.alarm != 0 ? 1 : 0);
  return result;
}

}  // namespace proof
