#include "host-sim/cut/route_rapids.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "host-sim/cut/rapid_way.hpp"
#include "host-sim/import/curve_measure.hpp"
#include "tests/host-sim/cut/nesting.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

constexpr double kMargin = 0.1;
constexpr double kSampleEvery = 0.05;
/// Upper bound of the distance between chords of the oracle's polygons and their arcs, mm.
constexpr double kPolygonSlack = 0.01;

/// A drawn outline as a polygon, tested point by point.
struct PolygonArea {
  Outline outline{};
  Place least{0.0, 0.0};
  Place most{0.0, 0.0};

  explicit PolygonArea(const drawing::DrawnContour& contour)
      : outline{outline_of(contour.shapes, 1.0e-3)}, least{outline[0]}, most{outline[0]} {
    for (const Place& place : outline) {
      least = least.cwiseMin(place);
      most = most.cwiseMax(place);
    }
  }

  [[nodiscard]] bool has_inside(const Place& place) const {
    if (place.x() < least.x() || place.x() > most.x()) return false;
    if (place.y() < least.y() || place.y() > most.y()) return false;
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Place& a = outline[i];
      const Place& b = outline[(i + 1) % outline.size()];
      if ((a.y() > place.y()) == (b.y() > place.y())) continue;
      const double x = a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      if (place.x() < x) inside = !inside;
    }
    return inside && distance_to_all({outline}, place) > kPolygonSlack;
  }
};

/// Checks every point of every rapid against the drawn outlines of all parts that are free at that
/// time.
class RapidOracle {
 public:
  RapidOracle(const drawing::Drawing& drawn, const CutPlan& plan) : plan_{plan} {
    for (const auto& contour : drawn.contours) polygons_.emplace_back(contour);
    loops_left_.resize(polygons_.size());
    for (const Cut& cut : plan.cuts) ++loops_left_[cut.contour];
  }

  /// Expects that no rapid is in a freed area. Returns the number of rapids that would be in one if
  /// they were straight.
  std::size_t judge() {
    std::size_t straight_ones = 0;
    for (std::size_t i = 0; i <= plan_.cuts.size(); ++i) {
      if (i != 0) note(plan_.cuts[i - 1]);
      const double lift = i < plan_.cuts.size() ? plan_.cuts[i].lift_mm : plan_.lift_home_mm;
      const std::vector<Place> way = rapid_before(plan_, i);
      if (lift == 0.0) {
        EXPECT_EQ(places_inside(i, way), 0U) << "rapid before cut " << i;
      }
      if (places_inside(i, {way.front(), way.back()}) != 0) ++straight_ones;
    }
    return straight_ones;
  }

 private:
  void note(const Cut& cut) {
    for (const Stroke& stroke : cut.strokes) {
      if (stroke.purpose == Purpose::kTab) return;
    }
    if (--loops_left_[cut.contour] == 0) free_.push_back(cut.contour);
  }

  /// Returns how many points are in a freed area. In the area that cut `i` - 1 has freed, points
  /// count only after the beam has left it.
  std::size_t places_inside(std::size_t i, const std::vector<Place>& way) const {
    std::size_t inside = 0;
    bool has_left = false;
    double prefix_mm = 0.0;
    for (std::size_t k = 1; k < way.size(); ++k) {
      for (const Place& place : places_along({way[k - 1], way[k]}, kSampleEvery)) {
        bool in_just_cut = false;
        for (const std::size_t contour : free_) {
          if (!polygons_[contour].has_inside(place)) continue;
          const bool just_cut = i != 0 && plan_.cuts[i - 1].contour == contour;
          in_just_cut = in_just_cut || just_cut;
          if (!just_cut || has_left) ++inside;
        }
        has_left = has_left || !in_just_cut;
        if (!has_left) prefix_mm += kSampleEvery;
      }
    }
    if (i == 0) return inside;
    const Outline& outline = polygons_[plan_.cuts[i - 1].contour].outline;
    const double shortest = distance_to_all({outline}, way.front());
    if (prefix_mm > 1.5 * (shortest + kTestKerf + kMargin) + 2.0 * kSampleEvery) ++inside;
    return inside;
  }

  const CutPlan& plan_;
  std::vector<PolygonArea> polygons_;
  std::vector<std::size_t> loops_left_;
  std::vector<std::size_t> free_;
};

TEST(RouteRapids, NeverCrossWhatIsFreeButThePieceJustCut) {
  const proof::Trials trials{40};
  std::size_t straight = 0;
  std::size_t led_round = 0;
  std::size_t rapids = 0;
  double longer_mm = 0.0;
  double rapids_mm = 0.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const NestingSize size{.pitch_mm = random.between(25.0, 60.0),
                           .min_gap_mm = random.between(0.75, 4.0)};
    const auto drawn = drawing::read(nested_sheet(random, size));
    LayerSettings settings{.overcut_mm = random.chance(0.3) ? 1.0 : 0.0,
                           .tabs = random.chance(0.2) ? 2U : 0U,
                           .pierce_s = random.chance(0.3) ? 0.2 : 0.0};
    if (random.chance(0.3)) settings.lead_in = {};
    if (random.chance(0.5)) settings.lead_out = {LeadKind::kArc, random.between(0.5, 3.0)};
    if (random.chance(0.3)) settings.corner_loop_mm = random.between(0.2, 1.0);
    CutPlan plan = foreseen_plan_of(drawn, settings);
    const double before_mm = rapid_length(plan);
    route_rapids(plan, drawn, {.margin_mm = kMargin});
    EXPECT_EQ(plan.safety.no_way, 0U);
    EXPECT_NEAR(rapid_length(plan), before_mm + plan.safety.longer_mm, 1.0e-6);
    straight += RapidOracle{drawn, plan}.judge();
    led_round += plan.safety.led_round;
    rapids += plan.cuts.size() + 1;
    longer_mm += plan.safety.longer_mm;
    rapids_mm += before_mm;
    // The shortest order may end a cut at a point from which no way leads on. This is reported.
    CutPlan searched = plan_of(drawn, settings);
    const std::size_t faults = searched.faults.size();
    route_rapids(searched, drawn, {.margin_mm = kMargin});
    EXPECT_EQ(searched.faults.size(), faults + searched.safety.no_way);
    if (searched.safety.no_way == 0) RapidOracle{drawn, searched}.judge();
  }
  std::printf("%zu rapids, %zu would cross, %zu led round: %.1f %% longer\n",
              rapids,
              straight,
              led_round,
              100.0 * longer_mm / rapids_mm);
  if (!trials.judges_shares()) return;
  EXPECT_GT(straight, rapids / 20);
  EXPECT_LT(longer_mm, 0.5 * rapids_mm);
}

/// The parts are in rows a kerf apart, and their common lines are cut once. A part is free when its
/// last open cut is done.
TEST(RouteRapids, NeverCrossWhatSharedLinesHaveFreed) {
  const proof::Trials trials{40};
  std::size_t straight = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    std::string content;
    double y = 5.0;
    while (y < 80.0) {
      const double height = random.between(8.0, 15.0);
      for (double x = random.between(5.0, 10.0); x < 80.0;) {
        const double width = random.between(8.0, 15.0);
        content += fmt::format(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", x, y, width, height);
        x += width + (random.chance(0.7) ? kTestKerf : 4.0);
      }
      y += height + (random.chance(0.7) ? kTestKerf : 4.0);
    }
    const auto drawn = drawing::read(drawing::svg_of(content));
    CutPlan plan = foreseen_plan_of(drawn, {.common_line_mm = 0.01});
    ASSERT_GT(plan.shared.lines, 0U);
    ASSERT_TRUE(plan.faults.empty());
    route_rapids(plan, drawn, {.margin_mm = kMargin, .lift_mm = 5.0});
    straight += RapidOracle{drawn, plan}.judge();
  }
  if (!trials.judges_shares()) return;
  EXPECT_GT(straight, 0U);
}

/// In a row of parts, the middle ones lie between the last one and the origin.
constexpr const char* kRow =
    "<rect x=\"5\" y=\"40\" width=\"20\" height=\"20\"/>"
    "<rect x=\"30\" y=\"40\" width=\"20\" height=\"20\"/>"
    "<rect x=\"55\" y=\"40\" width=\"20\" height=\"20\"/>";

TEST(RouteRapids, GoHomeRoundTheParts) {
  const auto drawn = drawing::read(drawing::svg_of(kRow));
  CutPlan plan = foreseen_plan_of(drawn);
  route_rapids(plan, drawn, {});
  EXPECT_TRUE(plan.faults.empty());
  EXPECT_EQ(RapidOracle(drawn, plan).judge(), plan.safety.led_round);
  EXPECT_FALSE(plan.way_home.empty());
}

TEST(RouteRapids, LeaveWhatTabsHold) {
  const auto drawn = drawing::read(drawing::svg_of(kRow));
  CutPlan plan = plan_of(drawn, {.tabs = 2});
  route_rapids(plan, drawn, {});
  EXPECT_EQ(plan.safety.led_round, 0U);
  EXPECT_TRUE(plan.way_home.empty());
}

/// Four parts, a kerf apart, enclose a fifth one. When they are cut, no way leads to the fifth one.
constexpr const char* kRing =
    "<rect x=\"10\" y=\"10\" width=\"39.4\" height=\"20\"/>"
    "<rect x=\"50\" y=\"10\" width=\"20\" height=\"39.4\"/>"
    "<rect x=\"30.6\" y=\"50\" width=\"39.4\" height=\"20\"/>"
    "<rect x=\"10\" y=\"30.6\" width=\"20\" height=\"39.4\"/>"
    "<rect id=\"core\" x=\"35\" y=\"35\" width=\"10\" height=\"10\"/>";

/// Returns the plan of the ring in which the core is cut last.
CutPlan ring_plan(const drawing::Drawing& drawn) {
  CutPlan plan = foreseen_plan_of(drawn);
  const auto is_core = [&](const Cut& cut) {
    return drawn.contours[cut.contour].entity.name == "rect \"core\"";
  };
  std::stable_partition(
      plan.cuts.begin(), plan.cuts.end(), [&](const Cut& cut) { return !is_core(cut); });
  return plan;
}

TEST(RouteRapids, NameBothCutsWhereThereIsNoWay) {
  const auto drawn = drawing::read(drawing::svg_of(kRing));
  CutPlan plan = ring_plan(drawn);
  ASSERT_TRUE(plan.faults.empty());
  route_rapids(plan, drawn, {});
  ASSERT_EQ(plan.safety.no_way, 2U);
  const std::string text = to_string(plan.faults[0], "ring.svg");
  EXPECT_THAT(text, testing::HasSubstr("no rapid leads here from cut 4, rect"));
  EXPECT_THAT(text, testing::HasSubstr("to cut 5, rect \"core\" around the freed areas"));
  EXPECT_THAT(text, testing::HasSubstr("--lift"));
  EXPECT_THAT(to_string(plan.faults[1], "ring.svg"), testing::HasSubstr("\"core\" to zero"));
}

TEST(RouteRapids, LiftTheHeadWhereThereIsNoWay) {
  const auto drawn = drawing::read(drawing::svg_of(kRing));
  CutPlan plan = ring_plan(drawn);
  route_rapids(plan, drawn, {.lift_mm = 7.5});
  EXPECT_TRUE(plan.faults.empty());
  EXPECT_EQ(plan.safety.lifted, 2U);
  const Beam beam{.full_power_w = 2000.0};
  const std::string program = program_of(plan, drawn, beam, cnc::gcode::PrintGrid{4}, {});
  EXPECT_THAT(program, testing::ContainsRegex("G0 Z7.5\nG0X[0-9.]*Y[0-9.]*\nZ0\nG2"));
  EXPECT_THAT(program, testing::HasSubstr("G0 Z7.5\nG0X0Y0\nZ0\nM2"));
  plan.cuts.back().lift_mm = 0.0;
  plan.lift_home_mm = 0.0;
  EXPECT_THAT(program_of(plan, drawn, beam, cnc::gcode::PrintGrid{4}, {}),
              testing::Not(testing::HasSubstr("Z")));
}

/// A frame that is cut on its line does not fall before all contours inside of it are cut.
TEST(RouteRapids, KeepClosedCutsOnTheLineUntilTheirInsideIsCut) {
  const auto drawn =
      drawing::read(drawing::svg_of("<rect x=\"5\" y=\"5\" width=\"90\" height=\"90\"/>"
                                    "<rect x=\"40\" y=\"40\" width=\"9\" height=\"9\"/>"
                                    "<rect x=\"60\" y=\"40\" width=\"9\" height=\"9\"/>"));
  CutPlan plan = plan_of(drawn, {.side = Side::kOn});
  std::ranges::stable_sort(
      plan.cuts, std::greater{}, [](const Cut& cut) { return length_of(cut.strokes); });
  route_rapids(plan, drawn, {});
  EXPECT_TRUE(plan.faults.empty());
  EXPECT_TRUE(plan.cuts[1].approach.empty()) << "into the frame";
}

TEST(RouteRapids, GoOverWhatIsEngraved) {
  const auto drawn = drawing::read(
      drawing::svg_of("<rect x=\"5\" y=\"40\" width=\"9\" height=\"9\"/>"
                      "<rect x=\"30\" y=\"30\" width=\"30\" height=\"30\" stroke=\"red\"/>"
                      "<rect x=\"75\" y=\"40\" width=\"9\" height=\"9\"/>"));
  for (const Side side : {Side::kOn, Side::kMark}) {
    std::vector<LayerPlan> layers = layers_with(drawn, {});
    for (std::size_t i = 0; i < layers.size(); ++i) {
      if (drawn.layers[i].colour == "red") layers[i].settings.side = side;
    }
    CutPlan plan =
        plan_cuts(drawn, layers, {}, WayBeside::kHere, {}, {.method = order::OrderMethod::kFile});
    std::ranges::stable_sort(plan.cuts, {}, [&](const Cut& cut) {
      return plan.plan_of(cut).settings.side == side ? 0 : 1;
    });
    route_rapids(plan, drawn, {});
    EXPECT_TRUE(plan.faults.empty());
    EXPECT_EQ(plan.cuts[2].approach.empty(), side == Side::kMark);
  }
}

TEST(RouteRapids, AreTheSameEachTime) {
  proof::Random random{7};
  const auto drawn = drawing::read(nested_sheet(random, {}));
  std::string programs[2];
  for (std::string& program : programs) {
    CutPlan plan = plan_of(drawn);
    route_rapids(plan, drawn, {});
    program = program_of(plan, drawn, {.full_power_w = 2000.0}, cnc::gcode::PrintGrid{4}, {});
  }
  EXPECT_EQ(programs[0], programs[1]);
}

}  // namespace
}  // namespace sim::cut
