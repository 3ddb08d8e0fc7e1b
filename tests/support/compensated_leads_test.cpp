#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "planner/compensation/compensator.hpp"
#include "tests/support/exact_piece.hpp"
#include "tests/support/lead_programs.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::compensation::Compensator;
using cnc::compensation::Fault;
using Piece = ExactPiece;

/// Depth of a cut into the outline from which on it counts as a gouge.
constexpr double kDeepestMm = 1.0e-4;

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

/// Runs a program through the compensation as the machine does.
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

struct LeadTally {
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

/// Expects that the path reaches the offset of every piece of a convex outline, except near the
/// joint with the lead, which may meet the outline at an angle.
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
      if (nearest(outline, beside_x, beside_y) < r - kDeepestMm) continue;
      EXPECT_LE(nearest(way, beside_x, beside_y), 1.0e-3) << x << ", " << y;
    }
  }
}

/// Returns the distance by which straight edges extend beyond a programmed line that runs along
/// them, on the side of the tool, mm. Only the part of the line along which the tool is driven
/// counts. Rounding to four decimals turns edge and line a little.
double reach_beyond(const LeadStep& from,
                    const LeadStep& to,
                    const std::vector<Piece>& outline,
                    const std::vector<Piece>& way,
                    double offset_mm) {
  constexpr double kAlong = 1.0e-3;  // Greatest angle between edge and line, radians.
  constexpr double kBesideMm = 2.0e-3;
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double x = (to.x - from.x) / length;
  const double y = (to.y - from.y) / length;
  const double side = offset_mm < 0.0 ? 1.0 : -1.0;
  const auto ahead_of = [&](double px, double py) { return x * (px - from.x) + y * (py - from.y); };
  const auto across_of = [&](double px, double py) {
    return side * (x * (py - from.y) - y * (px - from.x));
  };
  double begin = length;
  double end = 0.0;
  for (const Piece& piece : way) {
    if (std::abs(across_of(piece.x0, piece.y0) - std::abs(offset_mm)) > kBesideMm) continue;
    begin = std::min(begin, std::max(0.0, ahead_of(piece.x0, piece.y0)));
    end = std::max(end, std::min(length, ahead_of(piece.x0, piece.y0)));
  }
  double most = 0.0;
  for (const Piece& edge : outline) {
    const double first = ahead_of(edge.x0, edge.y0);
    const double last = ahead_of(edge.x1, edge.y1);
    const double beside = across_of(edge.x0, edge.y0);
    const double turn = across_of(edge.x1, edge.y1) - beside;
    if (edge.bulge != 0.0 || std::abs(turn) > kAlong * std::abs(last - first)) continue;
    const double low = std::max(std::min(first, last), begin);
    const double high = std::min(std::max(first, last), end);
    if (low > high) continue;  // The edge does not overlap the line.
    for (const double place : {low, high}) {
      const double across = beside + turn * (place - first) / (last - first);
      if (across < kBesideMm) most = std::max(most, across);
    }
  }
  return most;
}

/// Returns the distance by which an overlap or a tangent line may leave the outline along which it
/// runs, since coordinates are rounded to four decimals; mm.
double rounding_of(const LeadProgram& program,
                   const std::vector<Piece>& outline,
                   const std::vector<Piece>& way) {
  constexpr double kRounded = 1.5e-4;
  double most = program.overlap.empty() ? 0.0 : kRounded;
  if (program.in == Lead::kLineTangent) {
    const auto& lead = program.lead_in;
    const double beyond =
        reach_beyond(lead[lead.size() - 2], lead.back(), outline, way, program.offset_mm);
    most = std::max({most, kRounded, beyond});
  }
  if (program.out == Lead::kLineTangent) {
    const LeadStep& end = program.overlap.empty() ? program.outline.back() : program.overlap.back();
    const double beyond = reach_beyond(end, program.lead_out[0], outline, way, program.offset_mm);
    most = std::max({most, kRounded, beyond});
  }
  return most;
}

void judge(Random& random, LeadTally& tally) {
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
  const double rounded = rounding_of(program, outline, way);
  EXPECT_GE(least, r - kDeepestMm - rounded)
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

// KERFLINE_TRIALS=100000 runs 100,000 trials.
TEST(CompensatedLeads, CutNothingOfTheOutlineAndAreDrivenWhereThereIsRoom) {
  const Trials trials{2000};
  LeadTally tally;
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
