#include "tests/support/lead_programs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/contour_corpus.hpp"

namespace proof {
namespace {

constexpr double kPi = std::numbers::pi;
const double kBulgeOfAQuarter = std::tan(kPi / 8.0);

/// A point on the path with the direction of travel and the side of the waste.
struct Frame {
  double x, y;    ///< The point.
  double tx, ty;  ///< Unit tangent in the direction of travel.
  double side;    ///< 1 if the waste is on the left, −1 if it is on the right.

  /// Returns the point that lies `a` mm along the tangent and `b` mm into the waste.
  [[nodiscard]] LeadStep at(double a, double b, double bulge = 0.0) const {
    return {x + a * tx - side * b * ty, y + a * ty + side * b * tx, side * bulge};
  }
};

/// A convex outline that begins where its inscribed circle touches it, or a star.
struct Shape {
  std::vector<LeadStep> steps;
  double inradius = 0.0;   ///< Radius of the inscribed circle, mm; 0 for a star.
  double half_edge = 0.0;  ///< Length of the first element, which is half of an edge, mm.
  bool counter_clockwise = true;
  LeadStep start{};
};

Shape polygon(Random& random) {
  Shape shape;
  const auto corners = static_cast<int>(3 + random.below(4));
  shape.inradius = random.between(5.0, 30.0);
  shape.half_edge = shape.inradius * std::tan(kPi / corners);
  shape.start = {0.0, -shape.inradius};
  for (int i = 0; i < corners; ++i) {
    const double angle = -kPi / 2.0 + kPi * (2 * i + 1) / corners;
    const double radius = shape.inradius / std::cos(kPi / corners);
    shape.steps.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  shape.steps.push_back(shape.start);
  return shape;
}

/// Returns a rectangle with fillets, or a slot if the fillets are half as wide as the rectangle.
Shape rounded(Random& random) {
  Shape shape;
  const double h = random.between(5.0, 20.0);
  const bool slot = random.chance(0.4);
  const double f = slot ? h : random.between(0.2, 0.9) * h;
  const double w = h + random.between(1.0, 30.0);
  shape.inradius = h;
  shape.half_edge = w - f;
  shape.start = {0.0, -h};
  auto& steps = shape.steps;
  for (int turn = 0; turn < 4; ++turn) {
    const double c = std::cos(turn * kPi / 2.0);
    const double s = std::sin(turn * kPi / 2.0);
    const double along = turn % 2 == 0 ? w : h;
    const double aside = turn % 2 == 0 ? h : w;
    const auto put = [&](double a, double b, double bulge) {
      steps.push_back({a * c - b * s, a * s + b * c, bulge});
    };
    if (along > f) put(along - f, -aside, 0.0);
    if (slot && turn % 2 == 0) {
      put(along - f, aside, 1.0);
    } else if (!slot) {
      put(along, -aside + f, kBulgeOfAQuarter);
    }
  }
  steps.push_back(shape.start);
  return shape;
}

Shape circle(Random& random) {
  Shape shape;
  const double radius = random.between(3.0, 30.0);
  shape.inradius = radius;
  shape.half_edge = radius;
  shape.start = {0.0, -radius};
  const std::size_t turns = random.chance(0.5) ? 1 : 1 + random.below(4);
  const double pitch = random.chance(0.5) ? 0.0 : random.between(-1.0, 1.0);
  for (std::size_t i = 0; i < 2 * turns; ++i) {
    const double z = pitch * static_cast<double>(i + 1);
    shape.steps.push_back({0.0, i % 2 == 0 ? radius : -radius, 1.0, z});
  }
  return shape;
}

Shape star(Random& random) {
  Shape shape;
  const sim::Contour contour = programmed_star(random, 14);
  const auto& vertices = contour.vertices;
  shape.start = {vertices[0].x, vertices[0].y};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto& to = vertices[(i + 1) % vertices.size()];
    shape.steps.push_back({to.x, to.y, vertices[i].bulge});
  }
  return shape;
}

/// Reverses the direction of a shape.
void reverse(Shape& shape) {
  std::vector<LeadStep> points{shape.start};
  points.insert(points.end(), shape.steps.begin(), shape.steps.end());
  const double top = points.back().z;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const LeadStep& to = points[points.size() - 2 - i];
    const double bulge = points[points.size() - 1 - i].bulge;
    shape.steps[i] = {to.x, to.y, -bulge, top - to.z};
  }
  shape.counter_clockwise = !shape.counter_clockwise;
}

/// Returns point and tangent at a share of an element.
Frame along(const LeadStep& from, const LeadStep& to, double share, double side) {
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  const double chord = std::hypot(x, y);
  const double half = 2.0 * std::atan(to.bulge);
  const double angle = std::atan2(y, x) + (2.0 * share - 1.0) * half;
  Frame frame{from.x + share * x, from.y + share * y, std::cos(angle), std::sin(angle), side};
  if (to.bulge == 0.0) return frame;
  // The point lies along the chord of the first part of the arc.
  const double radius = chord / (2.0 * std::sin(half));
  const double part = 2.0 * radius * std::sin(share * half);
  const double direction = std::atan2(y, x) - (1.0 - share) * half;
  frame.x = from.x + part * std::cos(direction);
  frame.y = from.y + part * std::sin(direction);
  return frame;
}

/// Dimensions of a lead, mm and radians.
struct LeadSize {
  double radius;  ///< Radius of the tool.
  double line, second, arc;
  double slant;  ///< Angle of a line to or from the outline, from the normal.
  double turn;   ///< Angle at the joint of the entry or exit motion with an arc.
};

LeadSize random_size(Random& random, double radius) {
  return {.radius = radius,
          .line = radius * random.between(1.1, 4.0),
          .second = radius * random.between(1.1, 3.0),
          .arc = radius * random.between(1.15, 3.0),
          .slant = random.between(-0.75, 1.0),
          .turn = random.chance(0.5) ? 0.0 : random.between(-0.75, 0.75)};
}

/// Returns the points of a lead from the outline outwards, in coordinates (along, into the waste).
/// For a lead-in they are mirrored. The first point is on the outline; the lead begins or ends at
/// the last one.
std::vector<LeadStep> lead_points(Lead lead, const LeadSize& size) {
  const auto [radius, line, second, arc, slant, turn] = size;
  const auto beyond = [line = line, turn = turn](double a, double b, double direction) {
    return LeadStep{a + line * std::cos(direction + turn), b + line * std::sin(direction + turn)};
  };
  switch (lead) {
    case Lead::kLinePerpendicular:
      return {{}, {0.0, line}};
    case Lead::kLineSlanted:
      return {{}, {line * std::sin(slant), line * std::cos(slant)}};
    case Lead::kLineTangent:
      return {{}, {line, 0.0}, {line, second}};
    case Lead::kQuarterArc:
      return {{}, {arc, arc, kBulgeOfAQuarter}, beyond(arc, arc, kPi / 2.0)};
    case Lead::kHalfArc:
      return {{}, {0.0, 2.0 * arc, 1.0}, beyond(0.0, 2.0 * arc, kPi)};
    case Lead::kLineAndArc:
      return {{},
              {arc, arc, kBulgeOfAQuarter},
              {arc, arc + second},
              beyond(arc, arc + second, kPi / 2.0)};
    case Lead::kArcAlone:
      return {{}, {arc, arc, kBulgeOfAQuarter}};
    case Lead::kNone:
      return {{}, {0.0, 1.05 * radius}};
  }
  return {};
}

/// Returns whether the tool has space for a lead at a convex outline, `along` mm after the
/// outline's start.
bool has_room(const std::vector<LeadStep>& points,
              const LeadSize& size,
              const Shape& shape,
              bool inside,
              double along) {
  if (shape.inradius <= 0.0 || shape.half_edge < 3.0 * size.radius) return false;
  // From a short entry the tool goes to the corner of both offsets, which is not beside the start.
  // On the way it would cut into an outline that bends away from the entry.
  const bool brief = points.size() == 2 && points[1].y < 1.3 * size.radius;
  if (brief && shape.steps[0].bulge != 0.0) return false;
  // A tangent line that extends beyond the corner obstructs the edge there.
  const bool tangent = points.size() == 3 && points[1].y == 0.0;
  if (tangent && points[1].x > shape.half_edge) return false;
  const double margin = size.radius * (size.turn == 0.0 ? 1.05 : 2.1);
  const auto reaches = [&](double x, double y) {
    return std::hypot(x + along, y - shape.inradius);
  };
  // Half a circle extends beyond its end points.
  const double half_way = 0.5 * points[1].y;
  const double most = shape.inradius - 1.05 * size.radius;
  if (inside && points[1].bulge == 1.0 && reaches(half_way, half_way) > most) return false;
  return std::all_of(points.begin() + 1, points.end(), [&](const LeadStep& point) {
    if (!inside) return point.y == 0.0 || point.y >= margin * 0.99;
    return reaches(point.x, point.y) <= shape.inradius - margin;
  });
}

void round_off(std::vector<LeadStep>& steps) {
  for (LeadStep& step : steps) {
    step.x = programmed(step.x);
    step.y = programmed(step.y);
    step.z = programmed(step.z);
  }
}

Shape random_shape(Random& random) {
  const double kind = random.unit();
  Shape shape = kind < 0.25   ? polygon(random)
                : kind < 0.5  ? rounded(random)
                : kind < 0.75 ? circle(random)
                              : star(random);
  if (random.chance(0.5)) reverse(shape);
  const double angle = random.between(0.0, 2.0 * kPi);
  const double cosine = shape.inradius > 0.0 ? std::cos(angle) : 1.0;
  const double sine = shape.inradius > 0.0 ? std::sin(angle) : 0.0;
  const auto turned = [&](const LeadStep& step) {
    return LeadStep{
        cosine * step.x - sine * step.y, sine * step.x + cosine * step.y, step.bulge, step.z};
  };
  shape.start = turned(shape.start);
  for (LeadStep& step : shape.steps) step = turned(step);
  return shape;
}

void append_lead_in(LeadProgram& program, const std::vector<LeadStep>& points, const Frame& at) {
  const LeadStep& first = points.back();
  program.start = at.at(-first.x, first.y);
  for (std::size_t i = points.size() - 1; i-- > 0;) {
    program.lead_in.push_back(at.at(-points[i].x, points[i].y, points[i + 1].bulge));
  }
}

void append_lead_out(LeadProgram& program, const std::vector<LeadStep>& points, const Frame& at) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool last = i + 1 == points.size();
    auto& into = last ? program.exit : program.lead_out;
    into.push_back(at.at(points[i].x, points[i].y, points[i].bulge));
  }
}

}  // namespace

LeadProgram random_lead_program(Random& random) {
  LeadProgram program;
  const Shape shape = random_shape(random);
  const double least = shape.inradius > 0.0 ? shape.inradius : 8.0;
  const double radius = random.magnitude(0.05, random.chance(0.7) ? 0.3 * least : 10.0);
  program.offset_mm = random.chance(0.5) ? radius : -radius;
  const double side = program.offset_mm < 0.0 ? 1.0 : -1.0;
  const bool inside = (side > 0.0) == shape.counter_clockwise;
  program.outline = shape.steps;

  program.in = static_cast<Lead>(random.below(kLeads));
  const LeadSize in = random_size(random, radius);
  const auto in_points = lead_points(program.in, in);
  append_lead_in(program, in_points, along(shape.start, shape.steps[0], 0.0, side));

  const double share = random.chance(0.4) ? random.between(0.05, 0.4) : 0.0;
  const Frame end = along(shape.start, shape.steps[0], share, side);
  const double top = program.outline.back().z;
  if (share > 0.0) {
    const double bulge = std::tan(share * std::atan(shape.steps[0].bulge));
    program.overlap.push_back({end.x, end.y, bulge});
  }
  program.out = static_cast<Lead>(random.below(kLeads));
  LeadSize out = random_size(random, radius);
  if (program.out == Lead::kArcAlone) out.slant = random.between(0.8, 1.0);
  const bool slanted = program.out == Lead::kArcAlone;
  const auto out_points = lead_points(slanted ? Lead::kLineSlanted : program.out, out);
  append_lead_out(program, out_points, end);
  if (program.out == Lead::kNone) program.exit.clear();

  const bool straight = shape.steps[0].bulge == 0.0;
  const double after = straight ? std::hypot(end.x - shape.start.x, end.y - shape.start.y) : 0.0;
  program.roomy = has_room(in_points, in, shape, inside, 0.0) &&
                  has_room(out_points, out, shape, inside, after);
  program.start.x = programmed(program.start.x);
  program.start.y = programmed(program.start.y);
  for (auto* steps : {&program.overlap, &program.lead_out, &program.exit}) {
    for (LeadStep& step : *steps) step.z = top;
  }
  for (auto* steps :
       {&program.lead_in, &program.outline, &program.overlap, &program.lead_out, &program.exit}) {
    round_off(*steps);
  }
  return program;
}

}  // namespace proof
