#include "tests/target/trace/random_job.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "tests/support/random_machine.hpp"
#include "tests/support/random_program.hpp"
#include "tests/support/random_source.hpp"

namespace trace {
namespace {

using proof::Random;

/// Number of axes of the image's board in its default configuration.
constexpr std::size_t kAxes = 3;
constexpr std::size_t kMaxBytes = 6000;
constexpr std::string_view kLetters = "XYZ";
constexpr std::string_view kOffsets = "IJK";

/// Writes a program in incremental distances, so that inserted lines shift the rest.
class GcodeAuthor {
 public:
  explicit GcodeAuthor(Random& random) : random_{random} {}

  std::string write(const proof::Program& program) {
    text_ = "G21G91G94\n";
    for (const proof::ProgramItem& item : program.items) {
      if (text_.size() > kMaxBytes) break;
      if (item.stop_before) text_ += fmt::format("G4P{:.3f}\n", random_.between(0.0, 0.03));
      if (random_.chance(0.02)) row_of_pixels();
      if (random_.chance(0.02)) spline();
      element(item.request);
    }
    return text_ + "M5\n";
  }

 private:
  void element(const cnc::motion::MotionRequest& request) {
    beam(request.beam);
    std::array<double, kAxes> way{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const auto nm = request.element.end[axis] - request.element.start[axis];
      way[axis] = static_cast<double>(nm.nanometres()) * 1.0e-6;
    }
    if (request.element.bulge != 0.0F) {
      arc(request.element, way);
    } else {
      text_ += request.feed_mm_s > 0.0F ? "G1" : "G0";
      words(way);
    }
    if (request.feed_mm_s > 0.0F && request.feed_mm_s != feed_) {
      feed_ = request.feed_mm_s;
      text_ += fmt::format("F{:.2f}", std::max(1.0, 60.0 * double{feed_}));
    }
    text_ += '\n';
  }

  void words(const std::array<double, kAxes>& way) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (way[axis] != 0.0) text_ += fmt::format("{}{:.6f}", kLetters[axis], way[axis]);
    }
  }

  void arc(const cnc::PathElement& element, const std::array<double, kAxes>& way) {
    const cnc::PlaneAxes axes = cnc::axes_of(element.plane);
    const double bulge = element.bulge;
    const double height = (1.0 - bulge * bulge) / (4.0 * bulge);
    const double along = way[axes.first];
    const double across = way[axes.second];
    constexpr std::array<std::string_view, 3> kPlanes = {"G17", "G18", "G19"};
    const std::size_t normal = kAxes - axes.first - axes.second;
    text_ += fmt::format("{}{}", kPlanes[2 - normal], bulge > 0.0 ? "G3" : "G2");
    words(way);
    text_ += fmt::format("{}{:.6f}{}{:.6f}",
                         kOffsets[axes.first],
                         0.5 * along - height * across,
                         kOffsets[axes.second],
                         0.5 * across + height * along);
  }

  void beam(const cnc::motion::BeamCommand& beam) {
    const int power = static_cast<int>(1000.0F * beam.duty);
    if (power == power_ && beam.follows_speed == follows_speed_) return;
    if (power_ < 0 || beam.follows_speed != follows_speed_) {
      text_ += beam.follows_speed ? "M4" : "M3";
    }
    power_ = power;
    follows_speed_ = beam.follows_speed;
    text_ += fmt::format("S{}\n", power);
  }

  void row_of_pixels() {
    const std::size_t count = 5 + random_.below(40);
    const double pixel = random_.between(0.02, 0.2);
    text_ += fmt::format("F{:.0f}\n", random_.magnitude(600.0, 12'000.0));
    feed_ = 0.0F;
    for (std::size_t i = 0; i < count; ++i) {
      text_ += fmt::format("G1X{:.3f}S{}\n", pixel, random_.below(1001));
    }
    power_ = -1;
  }

  void spline() {
    const auto word = [&] { return random_.between(-2.0, 2.0); };
    text_ += fmt::format("G17F{:.0f}\n", random_.magnitude(300.0, 6000.0));
    feed_ = 0.0F;
    text_ += fmt::format("G5X{:.3f}Y{:.3f}I{:.3f}J{:.3f}P{:.3f}Q{:.3f}\n",
                         word(),
                         word(),
                         word(),
                         word(),
                         word(),
                         word());
  }

  Random& random_;
  std::string text_;
  float feed_ = 0.0F;
  int power_ = -1;
  bool follows_speed_ = false;
};

std::string settings_of(const proof::TestMachine& machine, Random& random) {
  const cnc::motion::Limits& limits = machine.limits;
  std::string text = fmt::format("$858=0\n$32={}\n", random.chance(0.7) ? 1 : 0);
  text += fmt::format("$0={:.2f}\n$29=2\n", machine.timing.pulse / 4.0);
  text += fmt::format("$11={:.4f}\n", limits.junction_deviation_mm);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    text += fmt::format("${}={:.3f}\n", 100 + axis, limits.scale[axis].steps_per_mm());
    text += fmt::format("${}={:.2f}\n", 110 + axis, 60.0F * limits.rate_mm_s[axis]);
    text += fmt::format("${}={:.2f}\n", 120 + axis, limits.acceleration_mm_s2[axis]);
  }
  return text;
}

std::vector<Injection> interruptions(Random& random, std::uint32_t first_turn) {
  constexpr std::string_view kOverrides = "\x90\x91\x92\x93\x94\x95\x96\x97\x99\x9A\x9B\x9C\x9D";
  std::vector<Injection> found;
  std::uint32_t turn = first_turn;
  const std::size_t count = random.below(9);
  for (std::size_t i = 0; i < count; ++i) {
    turn += 1 + static_cast<std::uint32_t>(random.below(200));
    if (random.chance(0.5)) {
      found.push_back({turn, kOverrides[random.below(kOverrides.size())]});
    } else {
      found.push_back({turn, '!'});
      turn += 1 + static_cast<std::uint32_t>(random.below(150));
      found.push_back({turn, '~'});
    }
  }
  // Resumes a hold that came while nothing moved.
  for (int more = 0; more < 3; ++more) found.push_back({turn += 300, '~'});
  return found;
}

}  // namespace

Job random_job(std::uint64_t seed, std::uint32_t first_turn) {
  Random random{seed};
  proof::MachineRanges ranges;
  ranges.max_steps_per_mm = 800.0;
  ranges.min_rate_mm_s = 1.0;
  ranges.min_acceleration = 10.0;
  const proof::TestMachine machine = proof::random_machine(random, ranges);
  const proof::ProgramSize size{.max_time_s = 1.5, .max_steps = 10'000.0, .splines = true};
  const proof::Program program = proof::random_program(random, machine, size);
  return {.settings = settings_of(machine, random),
          .program = GcodeAuthor{random}.write(program),
          .injections = interruptions(random, first_turn)};
}

}  // namespace trace
