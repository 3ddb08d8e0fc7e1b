// Tests G41.1 and G42.1 from lines of text to the motors, against the host's offset.

#include <fmt/core.h>

#include <cmath>

#include "tests/support/contour_corpus.hpp"
#include "tests/support/contour_oracle.hpp"
#include "tests/support/machine_bench.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

constexpr double kStepMm = 1.0 / 250.0;  ///< Length of a step by $100 and $101, mm.

/// Returns the G-code of an element: a line, an arc by its radius, or an arc by its centre if it is
/// close to half a turn.
std::string line_to(const sim::Contour& outline, std::size_t index) {
  const auto& vertices = outline.vertices;
  const auto& from = vertices[index];
  const auto& to = vertices[(index + 1) % vertices.size()];
  if (from.bulge == 0.0) return fmt::format("G1 X{:.4f} Y{:.4f}", to.x, to.y);
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  // Distance from the middle of the chord to the centre, in chords.
  const double aside = (1.0 - from.bulge * from.bulge) / (4.0 * from.bulge);
  return fmt::format("{} X{:.4f} Y{:.4f} I{:.9f} J{:.9f}",
                     from.bulge > 0.0 ? "G3" : "G2",
                     to.x,
                     to.y,
                     0.5 * dx - aside * dy,
                     0.5 * dy + aside * dx);
}

/// A job on a machine, with the positions of the tool while the beam was on.
class Beside : public MachineBench {
 public:
  Beside() { set({{32, 1}, {11, 0}, {110, 6000}, {111, 6000}, {120, 1500}, {121, 1500}}); }

  void say(const std::string& line) {
    while (machine().busy() && !machine().locked()) step();
    if (machine().locked()) return;
    EXPECT_FALSE(machine().accept(line).has_value()) << line;
  }
  void end() {
    for (int left = 60'000; left > 0 && !machine().locked(); --left) {
      if (!machine().busy() && machine().idle()) return;
      step();
    }
  }

  std::vector<std::array<double, 2>> places;

 private:
  void step() {
    controller.turn();
    if (controller.port().power > 0) places.push_back({mm(0), mm(1)});
  }
};

struct Tally {
  int driven = 0;
  int refused = 0;
  double farthest = 0.0;  ///< Greatest distance of the tool from the host's offset, mm.
};

/// Drives the outline with an entry from 1.5 times the offset and an exit back to there.
void drive(Beside& job, const sim::Contour& outline, double offset_mm) {
  const ExactContour exact{outline.view()};
  std::array<double, 4> at{};
  exact.elements()[0].at(0.0, at[0], at[1], at[2], at[3]);
  const std::string outside = fmt::format(
      "X{:.4f} Y{:.4f}", at[0] + 1.5 * offset_mm * at[2], at[1] + 1.5 * offset_mm * at[3]);
  job.say("G0 " + outside);
  job.say("M4 S1000 F3000");
  job.say(
      fmt::format("{} D{:.4f}", offset_mm > 0.0 ? "G42.1" : "G41.1", 2.0 * std::abs(offset_mm)));
  job.say(fmt::format("G1 X{:.4f} Y{:.4f}", outline.vertices[0].x, outline.vertices[0].y));
  for (std::size_t i = 0; i < outline.vertices.size(); ++i) job.say(line_to(outline, i));
  job.say("G40 G1 " + outside);
  job.end();
}

void judge(Random& random, Tally& tally) {
  const sim::Contour outline = programmed_star(random, 12);
  const double offset_mm = 0.5 * programmed(2.0 * random.signed_magnitude(0.05, 1.0));
  sim::ContourOffset offsetter;
  const auto wanted = offsetter.offset(outline.view(), offset_mm);
  const ExactContour exact{outline.view()};
  const ExactContour oracle{wanted};
  Beside job;
  drive(job, outline, offset_mm);
  if (job.machine().alarm() != cnc::Alarm::kNone) {
    ++tally.refused;
    EXPECT_EQ(job.machine().alarm(), cnc::Alarm::kCompensation);
    EXPECT_TRUE(job.places.empty()) << "refused after motion";
    return;
  }
  ++tally.driven;
  ASSERT_EQ(wanted.loop_ends.size(), 1U);
  ASSERT_FALSE(job.places.empty());
  const double r = std::abs(offset_mm);
  const auto& first = outline.vertices[0];
  for (const auto& [x, y] : job.places) {
    // The tool comes no nearer than the offset, except for the grid of the steps. Points of entry
    // and exit are farther away.
    EXPECT_GE(exact.distance(x, y), r - kStepMm);
    if (std::hypot(x - first.x, y - first.y) < 3.0 * r + 0.1) continue;
    tally.farthest = std::max(tally.farthest, oracle.distance(x, y));
  }
  EXPECT_LE(tally.farthest, kStepMm);
}

TEST(CompensatedJobs, DriveTheHostsOffsetOrAreRefusedBeforeTheyMove) {
  const Trials trials{60};
  Tally tally;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    judge(random, tally);
  }
  if (trials.count() >= 60) {
    EXPECT_GT(tally.driven, static_cast<int>(trials.count()) / 10);
  }
  std::printf("%d driven, %d refused, at most %.4f mm off the host's offset\n",
              tally.driven,
              tally.refused,
              tally.farthest);
}

}  // namespace
}  // namespace proof
