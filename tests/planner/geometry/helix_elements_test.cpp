#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <ostream>

#include "planner/geometry/arc_elements.hpp"
#include "tests/planner/geometry/exact_circle.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

struct Helix {
  Plane plane = Plane::kXY;
  std::int64_t radius_nm = 20'000'000;
  std::int64_t rise_nm = 1'000'000;
  std::uint16_t turns = 1;
  bool clockwise = false;

  friend void PrintTo(const Helix& helix, std::ostream* out) {
    *out << helix.turns << " turns of radius " << helix.radius_nm << " nm";
  }
};

/// Returns full turns around the origin, from the first axis back to it.
CentreArc whole_turns(const Helix& helix) {
  CentreArc arc{.plane = helix.plane, .clockwise = helix.clockwise, .turns = helix.turns};
  const PlaneAxes axes = axes_of(helix.plane);
  arc.start[axes.first] = arc.end[axes.first] = Coordinate{helix.radius_nm};
  arc.end[axes.normal] = Coordinate{helix.rise_nm};
  return arc;
}

/// Returns the difference between the angle of a point in the plane and `turned`, in turns, −½…½.
Real angle_error(const Position& place, const CentreArc& arc, Real turned) {
  const Real angle = from_centre(place, arc).angle();
  return std::remainder((arc.clockwise ? -angle : angle) - turned, 2.0L * kExactPi);
}

TEST(HelixElements, RiseInProportionToTheAngle) {
  const Helix helix{.rise_nm = 12'000'001, .turns = 6};
  const ArcElements elements{whole_turns(helix)};
  ASSERT_EQ(elements.count(), 12U);
  for (std::uint32_t index = 0; index < 12; ++index) {
    const auto wanted = static_cast<std::int64_t>(helix.rise_nm * (index + 1) / 12);
    EXPECT_NEAR(
        static_cast<double>(elements.element(index).end[2].nanometres() - wanted), 0.0, 1.0);
  }
}

TEST(HelixElements, CarryEveryOtherAxisAlong) {
  CentreArc arc = whole_turns({.turns = 2});
  arc.end[index_of(Axis::kB)] = Coordinate{-4'000'000};
  const ArcElements elements{arc};
  EXPECT_EQ(elements.element(0).end[index_of(Axis::kB)], Coordinate{-1'000'000});
  EXPECT_EQ(elements.element(3).end[index_of(Axis::kB)], Coordinate{-4'000'000});
}

class HelixOfManyTurns : public testing::TestWithParam<Helix> {
 protected:
  CentreArc arc = whole_turns(GetParam());
  ArcElements elements{arc};
};

TEST_P(HelixOfManyTurns, HasTwoElementsForEachTurn) {
  EXPECT_NEAR(static_cast<double>(elements.count()), 2.0 * GetParam().turns, 1.0);
}

TEST_P(HelixOfManyTurns, LosesNoDigitsOfItsPlace) {
  const std::uint32_t count = elements.count();
  const Real total = 2.0L * kExactPi * GetParam().turns;
  const Real radius = static_cast<Real>(GetParam().radius_nm) * 1.0e-6L;
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 2'000; ++trial) {
    const auto index = static_cast<std::uint32_t>(random.below(count - 1));
    const Position end = elements.element(index).end;
    const Real turned = total * (index + 1) / count;
    ASSERT_NEAR(static_cast<double>(angle_error(end, arc, turned)), 0.0, 3.0e-6) << index;
    ASSERT_NEAR(static_cast<double>(from_centre(end, arc).radius() - radius), 0.0, 3.0e-4) << index;
  }
}

TEST_P(HelixOfManyTurns, StaysWithinHalfAMicrometreOfItsCylinder) {
  const Real radius = static_cast<Real>(GetParam().radius_nm) * 1.0e-6L;
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 2'000; ++trial) {
    const auto index = static_cast<std::uint32_t>(random.below(elements.count()));
    const ExactCircle own{elements.element(index), arc};
    for (int part = 0; part <= 8; ++part) {
      const Real off = own.at(static_cast<Real>(part) / 8.0L).radius() - radius;
      ASSERT_LE(std::abs(off), 0.5e-3L) << "element " << index << ", part " << part;
    }
  }
}

TEST_P(HelixOfManyTurns, EndsExactlyWhereItShould) {
  EXPECT_EQ(elements.element(0).start, arc.start);
  EXPECT_EQ(elements.element(elements.count() - 1).end, arc.end);
}

INSTANTIATE_TEST_SUITE_P(
    Planes,
    HelixOfManyTurns,
    testing::Values(Helix{.plane = Plane::kXY, .turns = 2, .clockwise = true},
                    Helix{.plane = Plane::kZX, .turns = 7},
                    Helix{.plane = Plane::kYZ, .turns = 100, .clockwise = true},
                    Helix{.plane = Plane::kXY, .rise_nm = 999'999'937, .turns = 1000},
                    Helix{.plane = Plane::kZX, .radius_nm = 2'000'000'000, .turns = 999},
                    Helix{.plane = Plane::kYZ, .radius_nm = 50'000, .turns = 65'535},
                    Helix{.plane = Plane::kXY, .radius_nm = 2'000'000'000, .turns = 65'535},
                    Helix{.radius_nm = 2'000'000'000, .turns = 65'534, .clockwise = true}));

// For 65535 turns and a part, the float sweep retains only a rough value of the part.
TEST(HelixElements, StayNearTheCylinderWhateverPartOfATurnIsAdded) {
  const std::uint64_t seed = proof::test_seed();
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  proof::Random random{seed};
  for (int trial = 0; trial < 2'000; ++trial) {
    CentreArc arc = whole_turns({.radius_nm = 2'000'000'000, .turns = 1});
    arc.turns = static_cast<std::uint16_t>(random.magnitude(2.0, 65'535.0));
    const Real angle = random.between(0.01, 6.27);
    arc.end[0] = Coordinate{std::llround(2.0e9L * std::cos(angle))};
    arc.end[1] = Coordinate{std::llround(2.0e9L * std::sin(angle))};
    const ArcElements elements{arc};
    const auto index = static_cast<std::uint32_t>(random.below(elements.count()));
    const ExactCircle own{elements.element(index), arc};
    const Real off = own.at(0.5L).radius() - 2000.0L;
    ASSERT_LE(std::abs(off), 0.5e-3L) << arc.turns << " turns, element " << index;
  }
}

}  // namespace
}  // namespace cnc
