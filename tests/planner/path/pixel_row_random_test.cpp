#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "tests/planner/path/row_drive.hpp"
#include "tests/support/trials.hpp"

namespace cnc::path {
namespace {

/// Returns rows in random directions, with random powers, feeds and lengths, and corners between
/// them.
std::vector<PathItem> random_rows(proof::Random& random) {
  Tolerance tolerance{.corner_mm = static_cast<float>(random.magnitude(0.001, 0.2))};
  if (random.chance(0.2)) tolerance.weld_mm = 0.01F;
  PowerPen pen{tolerance};
  pen.grid_nm = random.chance(0.5) ? 1000 : 1;
  double angle = random.chance(0.3) ? 0.0 : random.between(0.0, 6.3);
  for (int row = 0; row < 6; ++row) {
    // Rows do not reverse, because a point would then belong to two rows.
    angle += random.chance(0.3) ? 0.5 * std::numbers::pi : random.signed_magnitude(0.2, 2.4);
    const double step = random.magnitude(0.02, 0.5);
    const std::size_t count = random.below(150);
    if (random.chance(0.3)) pen.request().beam.follows_speed = random.chance(0.5);
    for (std::size_t i = 0; i < count; ++i) {
      const double length = random.chance(0.1) ? random.magnitude(0.001, 5.0) : step;
      const double power = random.chance(0.3) ? pen.request().beam.duty : random.unit();
      pen.pixel({length * std::cos(angle), length * std::sin(angle)}, power);
    }
    if (random.chance(0.3)) pen.request().feed_mm_s = 100.0F;
  }
  return pen.items;
}

constexpr double kOnALine = 0.002;  ///< Distance within which a point is on a line, mm.

/// The lines of the program near a point, from `from` on: their powers, the distance of the
/// nearest, and the first line on which the point is. As rows cross each other, a later row may be
/// the nearest.
struct Demand {
  double nearest = 1.0e9;
  std::optional<std::size_t> line{};
  std::vector<double> powers{};
};

Demand demand_at(const std::vector<PathItem>& items,
                 const std::vector<ExactElement>& exact,
                 std::size_t from,
                 const Place& place,
                 double slack) {
  constexpr std::size_t kAhead = 100;  // A blend may pass dozens of short lines.
  constexpr std::size_t kBehind = 10;
  const std::size_t begin = from - std::min(from, kBehind);
  const std::size_t end = std::min(items.size(), from + kAhead);
  Demand demand;
  for (std::size_t i = begin; i < end; ++i) {
    const double away = exact[i].distance_to(place);
    if (away < kOnALine && i >= from && !demand.line) demand.line = i;
    demand.nearest = std::min(demand.nearest, away);
  }
  for (std::size_t i = begin; i < end; ++i) {
    if (exact[i].distance_to(place) > demand.nearest + slack) continue;
    demand.powers.push_back(static_cast<double>(items[i].request.beam.duty));
  }
  return demand;
}

// At each point of the driven path, the power must be that of the program's line at this point.
TEST(RandomRows, HaveAtEachPlaceThePowerThatTheProgramHasThere) {
  const proof::Trials trials{30};
  std::size_t lines = 0;
  std::size_t pieces = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const std::vector<PathItem> items = random_rows(random);
    if (items.empty()) continue;
    const auto elements = exact(items);
    RowDrive drive;
    drive.run(items);
    expect_sound(items, drive.pieces());
    lines += items.size();
    pieces += drive.driven.size();
    const double corner = static_cast<double>(items[0].tolerance.corner_mm);
    std::size_t at = 0;
    for (const RowDrive::Driven& one : drive.driven) {
      const ExactElement element{one.piece.request.element};
      const bool blend = one.piece.request.element.bulge != 0.0F;
      for (int i = 0; i < RowDrive::kPlaces; i += 3) {
        const Place place = element.at((i + 0.5) / RowDrive::kPlaces);
        const double slack = 0.004 + (blend ? 1.2 * corner : 0.0);
        const Demand demand = demand_at(items, elements, at, place, slack);
        // A blend passes its own lines, and also crosses lines that come later.
        if (!blend) at = demand.line.value_or(at);
        const double power = one.powers[static_cast<std::size_t>(i)];
        const bool found = std::ranges::find(demand.powers, power) != demand.powers.end();
        ASSERT_TRUE(found) << power << " near line " << at << ", " << demand.nearest << " mm off";
      }
    }
  }
  std::printf("rows at random: %zu lines, %zu pieces\n", lines, pieces);
}

}  // namespace
}  // namespace cnc::path
