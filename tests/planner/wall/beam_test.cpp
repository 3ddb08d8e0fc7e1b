#include "planner/wall/beam.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/planner/wall/beam_oracle.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::wall {
namespace {

using Eigen::Matrix3i;
using Eigen::Vector3d;
using Vector3l = Eigen::Matrix<std::int64_t, 3, 1>;
using proof::WholeCone;

/// Length of a unit of the exact cones, mm.
constexpr double kUnitMm = 0x1.0p-16;

/// A cone and a triangle in integers, in the cone's own directions before they are rotated.
struct ExactCase {
  std::array<Vector3l, 3> corners{};
  std::int64_t length = 0;
  std::int64_t sine = 0;
  std::int64_t cosine = 0;
  std::int64_t whole = 0;
};

std::int64_t integer(proof::Random& random, std::int64_t low, std::int64_t high) {
  return low + static_cast<std::int64_t>(random.below(static_cast<std::size_t>(high - low + 1)));
}

/// A point on the side of the cone, and the directions there.
struct SidePoint {
  Vector3l place;
  Vector3l level;   ///< Direction along the side, across the axis.
  Vector3l normal;  ///< Outward direction.
};

SidePoint random_side_point(proof::Random& random, const ExactCase& cone) {
  const std::int64_t c = integer(random, -6, 6);
  const std::int64_t d = integer(random, 1, 6);
  const std::int64_t scale = integer(random, 1, 24);
  const std::int64_t sum = c * c + d * d;
  const std::int64_t x = c * c - d * d;
  const std::int64_t y = 2 * c * d;
  return {
      {scale * cone.sine * x, scale * cone.sine * y, scale * cone.cosine * sum},
      {-y, x, 0},
      {cone.cosine * x, cone.cosine * y, -cone.sine * sum},
  };
}

Vector3l random_corner(proof::Random& random, std::int64_t reach, std::int64_t up) {
  return {integer(random, -reach, reach), integer(random, -reach, reach), integer(random, -up, up)};
}

/// Sets corners so that the triangle touches the side with one point or an edge, or nearly does.
void set_touching(proof::Random& random, ExactCase& made) {
  const SidePoint side = random_side_point(random, made);
  const std::int64_t in_or_out = random.chance(0.5) ? 0 : integer(random, -1, 1);
  const Vector3l place = side.place + in_or_out * side.normal;
  // The points are in the tangent plane: along the side's line, which passes through the tip, and
  // level.
  const auto in_plane = [&](std::int64_t reach) -> Vector3l {
    const Vector3l up{side.place / std::max<std::int64_t>(1, side.place.z() / 64)};
    return random.chance(0.5) ? Vector3l{integer(random, -reach, reach) * side.level}
                              : Vector3l{integer(random, 0, 3) * up};
  };
  made.corners[0] = place + in_plane(200);
  made.corners[1] = random.chance(0.3) ? place : Vector3l{place - in_plane(200)};
  made.corners[2] =
      place + integer(random, 0, 40) * side.normal + integer(random, -90, 90) * side.level;
}

ExactCase random_case(proof::Random& random) {
  ExactCase made;
  const std::int64_t a = integer(random, 2, 12);
  const std::int64_t b = integer(random, 1, a - 1);
  made.sine = 2 * a * b;
  made.cosine = a * a - b * b;
  made.whole = a * a + b * b;
  made.length = integer(random, 1, 40'000);
  const std::int64_t reach = integer(random, 1, 60'000);
  if (random.chance(0.4)) {
    set_touching(random, made);
  } else {
    const Vector3l place = random_corner(random, 30'000, 50'000);
    for (Vector3l& corner : made.corners) corner = place + random_corner(random, reach, reach);
  }
  if (random.chance(0.05)) made.corners[1] = made.corners[0];
  if (random.chance(0.05)) made.corners[2] = 2 * made.corners[1] - made.corners[0];
  if (random.chance(0.05)) made.corners[integer(random, 0, 2)].setZero();
  if (random.chance(0.1)) {  // The point is on a plane of the ends, or a unit away from it.
    const std::int64_t plane = random.chance(0.5) ? made.length : 0;
    for (Vector3l& corner : made.corners) corner.z() = plane + integer(random, -1, 1);
  }
  if (random.chance(0.05)) made.corners[0].head<2>().setZero();
  return made;
}

/// Returns a rotation in integers, whose columns have the squared length of the quaternion.
Matrix3i random_turn(proof::Random& random, int& length) {
  int w = 0;
  int x = 0;
  int y = 0;
  int z = 0;
  do {
    w = static_cast<int>(integer(random, -4, 4));
    x = static_cast<int>(integer(random, -4, 4));
    y = static_cast<int>(integer(random, -4, 4));
    z = static_cast<int>(integer(random, -4, 4));
    length = w * w + x * x + y * y + z * z;
  } while (length == 0);
  Matrix3i turn;
  turn << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),      //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return turn;
}

proof::WholeVector whole_of(const Vector3l& v) { return {v.x(), v.y(), v.z()}; }

/// Returns whether the exact cone intersects the triangle when its side is moved outwards by the
/// margin. For this, the tip is moved down, in a unit that is small enough.
bool meets_within_margin(const WholeCone& cone,
                         const std::array<proof::WholeVector, 3>& corners,
                         double sine) {
  constexpr std::int64_t kFiner = std::int64_t{1} << 30;
  const double down = kBeamMarginMm / sine / kUnitMm * static_cast<double>(kFiner);
  const proof::Whole steps{static_cast<std::int64_t>(std::ceil(down))};
  WholeCone larger = cone;
  // The axis has the length of its rotation, and no step is longer than requested by more than this
  // length.
  const proof::WholeVector way =
      proof::scaled(cone.axis, proof::Whole{steps / cone.axis_length + 1});
  larger.tip = proof::difference(proof::scaled(cone.tip, kFiner), way);
  larger.length = cone.length * kFiner + 2 * steps + 2 * cone.axis_length;
  return larger.meets({proof::scaled(corners[0], kFiner),
                       proof::scaled(corners[1], kFiner),
                       proof::scaled(corners[2], kFiner)});
}

TEST(Beam, MissesNoTriangleAndMeetsNoneBesideIt) {
  std::size_t met = 0;
  std::size_t touched = 0;
  std::size_t beside = 0;
  const proof::Trials trials{400'000};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const ExactCase made = random_case(random);
    int turn_length = 0;
    const Eigen::Matrix<std::int64_t, 3, 3> turn =
        random_turn(random, turn_length).cast<std::int64_t>();
    const Vector3l tip = random_corner(random, 1'000'000, 1'000'000);
    const WholeCone exact{.tip = whole_of(tip),
                          .axis = whole_of(turn.col(2)),
                          .axis_length = turn_length,
                          .cosine = made.cosine,
                          .whole = made.whole,
                          .length = proof::Whole{made.length} * turn_length};
    std::array<proof::WholeVector, 3> corners;
    std::array<Vector3d, 3> places;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3l corner = tip + turn * made.corners[i];
      corners[i] = whole_of(corner);
      places[i] = kUnitMm * corner.cast<double>();
    }
    const Beam beam{.tip = kUnitMm * tip.cast<double>(),
                    .axis = turn.col(2).cast<double>() / turn_length,
                    .sine = static_cast<double>(made.sine) / static_cast<double>(made.whole),
                    .cosine = static_cast<double>(made.cosine) / static_cast<double>(made.whole),
                    .length_mm = kUnitMm * static_cast<double>(made.length * turn_length)};
    const Triangle triangle{places[0], places[1], places[2]};
    const double distance = clearance(beam, triangle);
    const bool wanted = exact.meets(corners);
    const bool found = meets(beam, triangle);
    EXPECT_EQ(distance <= kBeamMarginMm, found) << "KERFLINE_SEED=" << seed << " " << distance;
    if (found != wanted) {
      EXPECT_TRUE(found) << "missed; KERFLINE_SEED=" << seed << " " << distance;
      EXPECT_TRUE(meets_within_margin(exact, corners, beam.sine)) << "KERFLINE_SEED=" << seed;
      ++beside;
    }
    met += wanted ? 1U : 0U;
    touched += wanted && distance > -kBeamMarginMm ? 1U : 0U;
  }
  std::printf("%zu met, %zu touched, %zu beside by less than the margin\n", met, touched, beside);
  if (!trials.judges_shares()) return;
  EXPECT_GT(met, trials.count() / 10);
  EXPECT_GT(touched, trials.count() / 100);
}

/// Returns the least value of a convex function on [0, 1].
template <typename Function>
double min_of(const Function& value) {
  const double share = 1.0 / std::numbers::phi;
  double low = 0.0;
  double high = 1.0;
  double first = value(high - share);
  double second = value(low + share);
  for (int i = 0; i < 70; ++i) {
    if (first > second) {
      low = high - share * (high - low);
      first = second;
      second = value(low + share * (high - low));
    } else {
      high = low + share * (high - low);
      second = first;
      first = value(high - share * (high - low));
    }
  }
  return std::min({first, second, value(0.0), value(1.0)});
}

/// Returns the signed distance of a triangle, found by a search, as it is convex over the triangle.
/// The distance of points beyond the planes of the ends is increased steeply with their excess.
double searched_clearance(const Beam& beam, const Triangle& triangle) {
  const auto distance = [&beam](const Vector3d& point) {
    const Vector3d way = point - beam.tip;
    const double along = way.dot(beam.axis);
    const double beyond = std::max({0.0, -along, along - beam.length_mm});
    const double out = (way - along * beam.axis).norm() - beam.waist_mm;
    return beam.cosine * out - beam.sine * along + 1.0e5 * beyond;
  };
  return min_of([&](double share) {
    const Vector3d from = triangle.a + share * (triangle.b - triangle.a);
    const Vector3d to = triangle.a + share * (triangle.c - triangle.a);
    return min_of([&](double on) { return distance(from + on * (to - from)); });
  });
}

bool is_between_planes(const Beam& beam, const Triangle& triangle) {
  double low = beam.length_mm;
  double high = 0.0;
  for (const Vector3d& corner : {triangle.a, triangle.b, triangle.c}) {
    low = std::min(low, beam.axis.dot(corner - beam.tip));
    high = std::max(high, beam.axis.dot(corner - beam.tip));
  }
  return high > 0.0 && low < beam.length_mm;
}

TEST(Beam, IsAsFarFromATriangleAsASearchFinds) {
  const proof::Trials trials{3'000};
  std::size_t compared = 0;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const auto place = [&random](double reach) {
      return Vector3d{random.between(-reach, reach),
                      random.between(-reach, reach),
                      random.between(-reach, reach)};
    };
    Beam beam =
        Beam::along(place(5.0), place(1.0), random.between(0.02, 1.4), random.magnitude(1.0, 60.0));
    if (random.chance(0.5)) beam.waist_mm = random.magnitude(0.005, 1.0);
    const Vector3d middle = beam.tip + random.between(-0.2, 1.2) * beam.length_mm * beam.axis;
    const double size = random.magnitude(0.05, 30.0);
    const Triangle triangle{middle + place(size), middle + place(size), middle + place(size)};
    const double found = clearance(beam, triangle);
    if (std::isinf(found)) {
      EXPECT_FALSE(is_between_planes(beam, triangle)) << "KERFLINE_SEED=" << seed;
      continue;
    }
    const double wanted = searched_clearance(beam, triangle);
    if (wanted > 1.0e3) continue;  // Hardly any part of the triangle is between the planes.
    ++compared;
    EXPECT_NEAR(found, wanted, 1.0e-5 * (size + beam.length_mm)) << "KERFLINE_SEED=" << seed;
  }
  EXPECT_GT(compared, 0U);
}

TEST(Beam, HasNoDistanceFromWhatIsAboveTheLensOrBelowTheTip) {
  const Beam beam = Beam::along({0, 0, 0}, {0, 0, 1}, 0.1, 10.0);
  EXPECT_TRUE(std::isinf(clearance(beam, {{-1, -1, 11}, {1, -1, 11}, {0, 1, 11}})));
  EXPECT_TRUE(std::isinf(clearance(beam, {{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}})));
  EXPECT_NEAR(clearance(beam, {{-9, -9, 5}, {9, -9, 5}, {0, 9, 5}}), -5.0 * std::sin(0.1), 1e-12);
}

}  // namespace
}  // namespace cnc::wall
