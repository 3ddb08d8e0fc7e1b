#include <cmath>
#include <numbers>

#include "tests/support/contour_oracle.hpp"

namespace proof {
namespace {

constexpr double kFarCentre_mm = 1.0e4;

double wrapped(double angle) {
  const double turn = 2.0 * std::numbers::pi;
  return angle - turn * std::floor(angle / turn);
}

ExactContour::Element element_of(const sim::ContourVertex& from, const sim::ContourVertex& to) {
  ExactContour::Element element{from.x, from.y, to.x, to.y, 0, 0, 0, 0, 0};
  if (from.bulge == 0.0) return element;
  const double chord = std::hypot(to.x - from.x, to.y - from.y);
  if (chord == 0.0) return element;
  element.sweep = 4.0 * std::atan(from.bulge);
  element.radius = chord / (2.0 * std::abs(std::sin(element.sweep / 2.0)));
  // Signed distance of the centre from the middle of the chord, to the left.
  const double reach = chord / (2.0 * std::tan(element.sweep / 2.0));
  element.centre_x = 0.5 * (from.x + to.x) - reach * (to.y - from.y) / chord;
  element.centre_y = 0.5 * (from.y + to.y) + reach * (to.x - from.x) / chord;
  element.start_angle = std::atan2(from.y - element.centre_y, from.x - element.centre_x);
  return element;
}

}  // namespace

// Long double: if the centre is far away, the last digits of its coordinates decide the result.
double ExactContour::Element::distance_to_flat_arc(double x, double y) const {
  const long double dx = static_cast<long double>(x1) - x0;
  const long double dy = static_cast<long double>(y1) - y0;
  const long double chord = std::sqrt(dx * dx + dy * dy);
  const long double half = static_cast<long double>(sweep) / 2.0L;
  const long double reach = chord / (2.0L * std::tan(half));
  const long double middle_x = (static_cast<long double>(x0) + x1) / 2.0L - reach * dy / chord;
  const long double middle_y = (static_cast<long double>(y0) + y1) / 2.0L + reach * dx / chord;
  const long double size = chord / (2.0L * std::abs(std::sin(half)));
  const long double away =
      std::sqrt((x - middle_x) * (x - middle_x) + (y - middle_y) * (y - middle_y));
  return static_cast<double>(std::abs(away - size));
}

double ExactContour::Element::distance(double x, double y) const {
  const double ends = std::min(std::hypot(x - x0, y - y0), std::hypot(x - x1, y - y1));
  if (radius == 0.0) {
    const double dx = x1 - x0;
    const double dy = y1 - y0;
    const double square = dx * dx + dy * dy;
    const double along = (x - x0) * dx + (y - y0) * dy;
    if (square == 0.0 || along <= 0.0 || along >= square) return ends;
    return std::abs((x - x0) * dy - (y - y0) * dx) / std::sqrt(square);
  }
  const double angle = std::atan2(y - centre_y, x - centre_x);
  const double turned = wrapped(sweep > 0.0 ? angle - start_angle : start_angle - angle);
  if (turned > std::abs(sweep)) return ends;
  if (radius > kFarCentre_mm) return std::min(ends, distance_to_flat_arc(x, y));
  return std::min(ends, std::abs(std::hypot(x - centre_x, y - centre_y) - radius));
}

void ExactContour::Element::at(
    double share, double& x, double& y, double& right_x, double& right_y) const {
  if (radius == 0.0) {
    const double size = std::hypot(x1 - x0, y1 - y0);
    x = x0 + share * (x1 - x0);
    y = y0 + share * (y1 - y0);
    right_x = (y1 - y0) / size;
    right_y = -(x1 - x0) / size;
    return;
  }
  if (radius > kFarCentre_mm) {
    // Computed from the chord of the first part. That chord is turned against the whole chord by
    // half the sweep of the remaining part.
    const double u = share * sweep / 2.0;
    const double v = (1.0 - share) * sweep / 2.0;
    const double chord = std::hypot(x1 - x0, y1 - y0);
    const double along_x = (x1 - x0) / chord;
    const double along_y = (y1 - y0) / chord;
    const double reach = chord * std::sin(u) / std::sin(sweep / 2.0);
    x = x0 + reach * (along_x * std::cos(v) + along_y * std::sin(v));
    y = y0 + reach * (along_y * std::cos(v) - along_x * std::sin(v));
    right_x = along_y * std::cos(v - u) + along_x * std::sin(u - v);
    right_y = -along_x * std::cos(v - u) + along_y * std::sin(u - v);
    return;
  }
  const double angle = start_angle + share * sweep;
  right_x = sweep > 0.0 ? std::cos(angle) : -std::cos(angle);
  right_y = sweep > 0.0 ? std::sin(angle) : -std::sin(angle);
  x = centre_x + radius * std::cos(angle);
  y = centre_y + radius * std::sin(angle);
}

double ExactContour::Element::length() const {
  return radius == 0.0 ? std::hypot(x1 - x0, y1 - y0) : radius * std::abs(sweep);
}

ExactContour::ExactContour(const cnc::contour::ContourView<double>& contour) {
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    const std::size_t first = contour.loop_begin(loop);
    const std::size_t end = contour.loop_ends[loop];
    for (std::size_t i = first; i < end; ++i) {
      const Element element =
          element_of(contour.vertices[i], contour.vertices[i + 1 < end ? i + 1 : first]);
      if (element.x0 == element.x1 && element.y0 == element.y1) continue;
      elements_.push_back(element);
      loops_.push_back(loop);
    }
    loop_ends_.push_back(elements_.size());
  }
}

double ExactContour::distance(double x, double y) const {
  double least = INFINITY;
  for (const Element& element : elements_) {
    // No point of an element is nearer than the distance of its start less its length.
    const double bound = std::hypot(x - element.x0, y - element.y0) - element.length();
    if (bound < least) least = std::min(least, element.distance(x, y));
  }
  return least;
}

int ExactContour::winding_of_loop(std::size_t loop, double x, double y) const {
  int turns = 0;
  for (std::size_t i = loop == 0 ? 0 : loop_ends_[loop - 1]; i < loop_ends_[loop]; ++i) {
    const Element& e = elements_[i];
    const double side = (e.x1 - e.x0) * (y - e.y0) - (e.y1 - e.y0) * (x - e.x0);
    if (e.y0 <= y && e.y1 > y && side > 0.0) ++turns;
    if (e.y0 > y && e.y1 <= y && side < 0.0) --turns;
    if (e.radius == 0.0) continue;
    // Between the chord and its arc the winding number is greater or less by one. This holds for
    // arcs of up to half a turn.
    const double across = std::hypot(x - e.centre_x, y - e.centre_y);
    const bool beyond_chord = e.sweep > 0.0 ? side <= 0.0 : side >= 0.0;
    if (across < e.radius && beyond_chord) turns += e.sweep > 0.0 ? 1 : -1;
  }
  return turns;
}

int ExactContour::winding(double x, double y) const {
  int turns = 0;
  for (std::size_t loop = 0; loop < loop_ends_.size(); ++loop) {
    turns += winding_of_loop(loop, x, y);
  }
  return turns;
}

double ExactContour::area() const {
  double twice = 0.0;
  for (const Element& e : elements_) {
    twice += e.x0 * e.y1 - e.x1 * e.y0;
    twice += e.radius * e.radius * (e.sweep - std::sin(e.sweep));
  }
  return 0.5 * twice;
}

double ExactContour::length() const {
  double sum = 0.0;
  for (const Element& element : elements_) sum += element.length();
  return sum;
}

}  // namespace proof
