#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "planner/compensation/compensator.hpp"
#include "tests/support/lead_programs.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::compensation::Compensator;
using cnc::compensation::Fault;

constexpr double kGouge = 1.0e-4;  ///< mm.

/// A line or arc in double precision, by its ends and bulge, for distances.
struct Piece {
  double x0, y0, x1, y1, bulge;

  [[nodiscard]] std::array<double, 2> at(double share) const {
    const double x = x1 - x0;
    const double y = y1 - y0;
    if (bulge == 0.0) return {x0 + share * x, y0 + share * y};
    const double half = 2.0 * std::atan(bulge);
    const double part = std::sin(share * half) / std::sin(half);
    const double turn = (share - 1.0) * half;
    return {x0 + part * (x * std::cos(turn) - y * std::sin(turn)),
            y0 + part * (x * std::sin(turn) + y * std::cos(turn))};
  }
  [[nodiscard]] double length() const {
    const double half = 2.0 * std::atan(std::abs(bulge));
    const double chord = std::hypot(x1 - x0, y1 - y0);
    return half > 0.0 ? chord * half / std::sin(half) : chord;
  }
  [[nodiscard]] double distance(double x, double y) const {
    const double ends = std::min(std::hypot(x - x0, y - y0), std::hypot(x - x1, y - y1));
    const double dx = x1 - x0;
    const double dy = y1 - y0;
    if (bulge == 0.0) {
      const double along = ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy);
      if (along <= 0.0 || along >= 1.0) return ends;
      return std::abs((x - x0) * dy - (y - y0) * dx) / std::hypot(dx, dy);
    }
    const double aside = (1.0 - bulge * bulge) / (4.0 * bulge);
    const double cx = x0 + 0.5 * dx - aside * dy;
    const double cy = y0 + 0.5 * dy + aside * dx;
    // By the angle from the start in the direction of travel.
    const double turn = bulge > 0.0 ? 1.0 : -1.0;
    const double cross = (x0 - cx) * (y - cy) - (y0 - cy) * (x - cx);
    const double dot = (x0 - cx) * (x - cx) + (y0 - cy) * (y - cy);
    double angle = std::atan2(turn * cross, dot);
    if (angle < 0.0) angle += 8.0 * std::atan(1.0);
    if (angle > 4.0 * std::atan(std::abs(bulge))) return ends;
    return std::abs(std::hypot(x - cx, y - cy) - std::hypot(x0 - cx, y0 - cy));
  }
};

double nearest(const std::vector<Piece>& pieces, double x, double y) {
  double least = 1.0e9;
  for (const Piece& piece : pieces) least = std::min(least, piece.distance(x, y));
  return least;
}

/// How near a part of a way comes to a piece: by the golden section.
double nearest_between(const Piece& way, const Piece& piece, double low, double high) {
  constexpr double kGolden = 0.618033988749895;
  const auto off = [&](double share) {
    const auto [x, y] = way.at(share);
    return piece.distance(x, y);
  };
  double lower = high - kGolden * (high - low);
  double upper = low + kGolden * (high - low);
  double off_lower = off(lower);
  double off_upper = off(upper);
  for (int round = 0; round < 20; ++round) {
    if (off_lower < off_upper) {
      high = std::exchange(upper, lower);
      off_upper = off_lower;
      lower = high - kGolden * (high - low);
      off_lower = off(lower);
    } else {
      low = std::exchange(lower, upper);
      off_lower = off_upper;
      upper = low + kGolden * (high - low);
      off_upper = off(upper);
    }
  }
  return std::min(off_lower, off_upper);
}

/// How near a part of a way comes to a piece where that is nearer than `radius`: halves it until it
/// is far enough, or short enough for a search.
double clearance_between(
    const Piece& way, const Piece& piece, double radius, double low, double high) {
  const double half = 0.5 * (high - low) * way.length();
  const double middle = 0.5 * (low + high);
  const auto [x, y] = way.at(middle);
  const double here = piece.distance(x, y);
  // Nothing on this part can be nearer than this.
  if (here - half >= radius) return radius;
  if (half > 0.125 * radius + 0.125) {
    return std::min(clearance_between(way, piece, radius, low, middle),
                    clearance_between(way, piece, radius, middle, high));
  }
  double least = std::min(here, nearest_between(way, piece, low, high));
  for (const double end : {low, high}) {
    const auto [end_x, end_y] = way.at(end);
    least = std::min(least, piece.distance(end_x, end_y));
  }
  return least;
}

double clearance(const Piece& way, const std::vector<Piece>& outline, double radius) {
  double least = radius;
  for (const Piece& piece : outline) {
    least = std::min(least, clearance_between(way, piece, radius, 0.0, 1.0));
  }
  return least;
}

cnc::Coordinate coordinate(double mm) {
  return cnc::Coordinate{static_cast<std::int64_t>(std::llround(mm * 1.0e6))};
}
double mm(cnc::Coordinate coordinate) {
  return static_cast<double>(coordinate.nanometres()) * 1.0e-6;
}
void move_to(cnc::Position& position, const LeadStep& step) {
  position[0] = coordinate(step.x);
  position[1] = coordinate(step.y);
  position[2] = coordinate(step.z);
}

/// Drives a program as the machine does.
class Drive {
 public:
  explicit Drive(const LeadProgram& program) : program_{program} {
    move_to(here_, program.start);
    compensator_.begin(here_, cnc::Plane::kXY, static_cast<float>(program.offset_mm));
    for (const auto* steps :
         {&program.lead_in, &program.outline, &program.overlap, &program.lead_out}) {
      for (const LeadStep& step : *steps) put(step);
    }
    given_before_end = way.size();
    if (!fault) fault = compensator_.end();
    take();
    if (!fault && !program.exit.empty()) leave();
  }

  std::vector<cnc::PathElement> way;
  std::optional<Fault> fault;
  std::size_t elements = 0;
  std::size_t given_before_end = 0;

 private:
  void put(const LeadStep& step) {
    if (fault) return;
    ++elements;
    cnc::PathElement element{.start = here_, .bulge = static_cast<float>(step.bulge)};
    move_to(here_, step);
    element.end = here_;
    fault = compensator_.put({.request = {.element = element, .feed_mm_s = 10.0F}});
    take();
  }
  void take() {
    cnc::path::PathItem item;
    while (!fault && compensator_.take(item)) {
      const cnc::PathElement& element = item.request.element;
      EXPECT_TRUE(way.empty() || way.back().end == element.start);
      way.push_back(element);
    }
  }
  void leave() {
    move_to(here_, program_.exit[0]);
    fault = compensator_.leave(here_, false);
    take();
    if (fault) return;
    way.push_back({.start = way.back().end, .end = here_});
  }

  const LeadProgram& program_;
  Compensator compensator_{};
  cnc::Position here_{};
};

struct Tally {
  std::uint64_t driven = 0;
  std::uint64_t refused = 0;
  std::array<std::uint64_t, kLeads> in{};
  std::array<std::uint64_t, kLeads> out{};
  double deepest = -1.0;
};

std::vector<Piece> outline_of(const LeadProgram& program) {
  std::vector<Piece> outline;
  LeadStep at = program.lead_in.back();
  for (const LeadStep& step : program.outline) {
    outline.push_back(
        {at.x, at.y, step.x, step.y, static_cast<double>(static_cast<float>(step.bulge))});
    at = step;
  }
  return outline;
}

/// Nothing of a convex outline is left out, but beside the joint with a lead that is no tangent.
void expect_all_is_reached(const LeadProgram& program,
                           const std::vector<Piece>& outline,
                           const std::vector<Piece>& way) {
  const double r = std::abs(program.offset_mm);
  const LeadStep& joint = program.lead_in.back();
  for (const Piece& piece : outline) {
    for (const double share : {0.2, 0.5, 0.8}) {
      const auto [x, y] = piece.at(share);
      const auto [ahead_x, ahead_y] = piece.at(share + 1.0e-6);
      const double step = std::hypot(ahead_x - x, ahead_y - y);
      const double beside_x = x + program.offset_mm * (ahead_y - y) / step;
      const double beside_y = y - program.offset_mm * (ahead_x - x) / step;
      if (std::hypot(x - joint.x, y - joint.y) < 3.0 * r) continue;
      if (nearest(outline, beside_x, beside_y) < r - kGouge) continue;
      EXPECT_LE(nearest(way, beside_x, beside_y), 1.0e-3) << x << ", " << y;
    }
  }
}

void judge(Random& random, Tally& tally) {
  const LeadProgram program = random_lead_program(random);
  const double r = std::abs(program.offset_mm);
  const Drive drive{program};
  if (drive.fault) {
    ++tally.refused;
    const Fault& fault = *drive.fault;
    EXPECT_FALSE(program.roomy) << "reason " << static_cast<int>(fault.reason) << ", element "
                                << fault.element << ", other " << fault.other << ", leads "
                                << static_cast<int>(program.in) << " and "
                                << static_cast<int>(program.out) << " of " << program.lead_in.size()
                                << " and " << program.lead_out.size() << " beside "
                                << program.outline.size() << ", offset " << program.offset_mm;
    if (drive.elements <= Compensator::kLookAhead) {
      EXPECT_EQ(drive.given_before_end, 0U) << "refused after motion";
    }
  }
  const std::vector<Piece> outline = outline_of(program);
  std::vector<Piece> way;
  for (const cnc::PathElement& element : drive.way) {
    const Piece piece{mm(element.start[0]),
                      mm(element.start[1]),
                      mm(element.end[0]),
                      mm(element.end[1]),
                      static_cast<double>(element.bulge)};
    if (piece.length() > 0.0) way.push_back(piece);
  }
  double least = r;
  for (const Piece& piece : way) least = std::min(least, clearance(piece, outline, r));
  // Four decimals let an overlap end beside the outline.
  const double rounded =
      program.overlap.empty() ? 0.0 : nearest(outline, program.overlap[0].x, program.overlap[0].y);
  EXPECT_LE(rounded, 2.0e-4);
  EXPECT_GE(least, r - kGouge - rounded)
      << "offset " << program.offset_mm << ", leads " << static_cast<int>(program.in) << " and "
      << static_cast<int>(program.out);
  if (!way.empty()) tally.deepest = std::max(tally.deepest, r - least - rounded);
  if (drive.fault) return;
  ++tally.driven;
  ++tally.in[static_cast<std::size_t>(program.in)];
  ++tally.out[static_cast<std::size_t>(program.out)];
  const cnc::Position& end = drive.way.back().end;
  EXPECT_EQ(end[2], coordinate(program.outline.back().z)) << "all of the other axes is driven";
  if (program.roomy) expect_all_is_reached(program, outline, way);
}

// 100,000: KERFLINE_TRIALS=100000.
TEST(CompensatedLeads, CutNothingOfTheOutlineAndAreDrivenWhereThereIsRoom) {
  const Trials trials{2000};
  Tally tally;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    judge(random, tally);
  }
  std::printf("%llu driven, %llu refused, at most %.2g mm too near\n",
              static_cast<unsigned long long>(tally.driven),
              static_cast<unsigned long long>(tally.refused),
              tally.deepest);
  for (std::size_t lead = 0; lead < kLeads; ++lead) {
    std::printf("  lead %zu: %llu driven in, %llu out\n",
                lead,
                static_cast<unsigned long long>(tally.in[lead]),
                static_cast<unsigned long long>(tally.out[lead]));
    if (!trials.judges_shares()) continue;
    EXPECT_GT(tally.in[lead] * 50, trials.count()) << "lead " << lead;
    EXPECT_GT(tally.out[lead] * 50, trials.count()) << "lead " << lead;
  }
}

}  // namespace
}  // namespace proof
