#include "tests/support/contour_oracle.hpp"

#include <fmt/format.h>

#include <clipper.hpp>
#include <cmath>

namespace proof {
namespace {

constexpr double kAllowedDeviation_mm = 1.0e-6;
constexpr double kStepAside_mm = 1.0e-5;
constexpr double kClipperUnits_per_mm = 1.0e6;
constexpr double kChordTolerance_mm = 2.0e-4;

ClipperLib::Path flattened(const ExactContour& contour, std::size_t& next, double tolerance_mm) {
  ClipperLib::Path path;
  const std::size_t loop = contour.loop_of(next);
  for (; next < contour.elements().size() && contour.loop_of(next) == loop; ++next) {
    const ExactContour::Element& element = contour.elements()[next];
    int chords = 1;
    if (element.radius > 0.0) {
      const double step = 2.0 * std::sqrt(2.0 * tolerance_mm / element.radius);
      chords = std::max(1, static_cast<int>(std::ceil(std::abs(element.sweep) / step)));
    }
    for (int i = 0; i < chords; ++i) {
      double x = 0, y = 0, right_x = 0, right_y = 0;
      element.at(static_cast<double>(i) / chords, x, y, right_x, right_y);
      path.emplace_back(std::llround(x * kClipperUnits_per_mm),
                        std::llround(y * kClipperUnits_per_mm));
    }
  }
  return path;
}

/// Returns whether another element is so near that a step aside from this element might cross it.
bool crowded(const ExactContour& contour, std::size_t index, double x, double y) {
  for (std::size_t i = 0; i < contour.elements().size(); ++i) {
    if (i != index && contour.elements()[i].distance(x, y) < 4.0 * kStepAside_mm) return true;
  }
  return false;
}

/// Reports the fault at a point of a contour, or nothing. Every element must have material on its
/// left and none on its right, by the winding number of all loops and by that of its own loop.
std::string crossing_at(const ExactContour& contour, std::size_t index, double share) {
  double x = 0, y = 0, right_x = 0, right_y = 0;
  contour.elements()[index].at(share, x, y, right_x, right_y);
  if (crowded(contour, index, x, y)) return {};
  const double dx = kStepAside_mm * right_x;
  const double dy = kStepAside_mm * right_y;
  const int left = contour.winding(x - dx, y - dy);
  const int right = contour.winding(x + dx, y + dy);
  if (left != 1 || right != 0) {
    return fmt::format("({:.9g}, {:.9g}) has {} turns left and {} right of it", x, y, left, right);
  }
  const std::size_t loop = contour.loop_of(index);
  const int own_left = contour.winding_of_loop(loop, x - dx, y - dy);
  const int own_right = contour.winding_of_loop(loop, x + dx, y + dy);
  const bool outline = own_left == 1 && own_right == 0;
  const bool hole = own_left == 0 && own_right == -1;
  if (outline || hole) return {};
  return fmt::format("the loop at ({:.9g}, {:.9g}) crosses itself", x, y);
}

std::string crossing_in(const ExactContour& contour) {
  for (std::size_t i = 0; i < contour.elements().size(); ++i) {
    if (contour.elements()[i].length() < 10.0 * kStepAside_mm) continue;
    for (const double share : {0.07, 0.43, 0.93}) {
      if (std::string why = crossing_at(contour, i, share); !why.empty()) return why;
    }
  }
  return {};
}

class OffsetCheck {
 public:
  OffsetCheck(const OffsetCase& wanted,
              const cnc::contour::ContourView<double>& result,
              std::uint64_t seed)
      : input_{wanted.plain.view()},
        result_{result},
        distance_{wanted.distance_mm},
        random_{seed ^ 0xC0FFEE} {}

  OffsetVerdict run() {
    check_distances();
    check_sides();
    check_places();
    check_area();
    return verdict_;
  }

 private:
  void complain(const std::string& text) {
    if (verdict_.complaint.empty()) verdict_.complaint = text;
  }

  void check_distances() {
    for (const ExactContour::Element& element : result_.elements()) {
      for (const double share : {0.0, 0.02, 0.25, 0.5, 0.75, 0.98, 1.0}) {
        double x = 0, y = 0, right_x = 0, right_y = 0;
        element.at(share, x, y, right_x, right_y);
        const double off = std::abs(input_.distance(x, y) - std::abs(distance_));
        verdict_.worst_deviation = std::max(verdict_.worst_deviation, off);
        if (off <= kAllowedDeviation_mm) continue;
        complain(fmt::format("({:.9g}, {:.9g}) is {:.3g} mm off the distance", x, y, off));
      }
    }
  }

  void check_sides() {
    if (const std::string why = crossing_in(result_); !why.empty()) complain(why);
  }

  /// Checks random points, half of them near the true offset.
  void check_places() {
    constexpr int kPlaces = 48;
    for (int i = 0; i < kPlaces; ++i) {
      const auto& from = input_.elements()[random_.below(input_.elements().size())];
      double x = 0, y = 0, right_x = 0, right_y = 0;
      from.at(random_.unit(), x, y, right_x, right_y);
      const double near = random_.signed_magnitude(1.0e-5, 0.5);
      const double aside = distance_ * (random_.chance(0.5) ? 1.0 + near : random_.between(-3, 3));
      check_place(x + aside * right_x, y + aside * right_y);
    }
  }

  void check_place(double x, double y) {
    const double away = input_.distance(x, y);
    if (std::abs(away - std::abs(distance_)) < 2.0 * kAllowedDeviation_mm) return;
    if (away < 2.0 * kAllowedDeviation_mm) return;
    if (result_.distance(x, y) < kAllowedDeviation_mm) return;
    const bool inside = input_.winding(x, y) == 1;
    const bool wanted = distance_ > 0.0 ? inside || away < distance_ : inside && away > -distance_;
    const int turns = result_.winding(x, y);
    if (turns == (wanted ? 1 : 0)) return;
    complain(fmt::format("({:.9g}, {:.9g}) should be {}, but {} loops are around it",
                         x,
                         y,
                         wanted ? "inside" : "outside",
                         turns));
  }

  void check_area() {
    // Clipper drops areas that are thinner than the error of its chords.
    if (input_.area() < 4.0 * kChordTolerance_mm * input_.length()) return;
    const double clipper = clipper_area(input_, distance_, kChordTolerance_mm);
    const double own = result_.area();
    const double allowed = 2.5 * kChordTolerance_mm * (input_.length() + result_.length()) + 1.0e-3;
    if (std::abs(clipper - own) <= allowed) return;
    complain(fmt::format("area {:.9g}, Clipper has {:.9g}", own, clipper));
  }

  ExactContour input_;
  ExactContour result_;
  double distance_;
  Random random_;
  OffsetVerdict verdict_;
};

}  // namespace

double clipper_area(const ExactContour& contour, double distance_mm, double tolerance_mm) {
  ClipperLib::ClipperOffset offsetter{2.0, tolerance_mm * kClipperUnits_per_mm};
  for (std::size_t next = 0; next < contour.elements().size();) {
    offsetter.AddPath(
        flattened(contour, next, tolerance_mm), ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  }
  ClipperLib::Paths paths;
  offsetter.Execute(paths, distance_mm * kClipperUnits_per_mm);
  double area = 0.0;
  for (const ClipperLib::Path& path : paths) area += ClipperLib::Area(path);
  return area / (kClipperUnits_per_mm * kClipperUnits_per_mm);
}

bool is_simple(const cnc::contour::ContourView<double>& contour) {
  const ExactContour exact{contour};
  return !elements_cross(exact) && crossing_in(exact).empty();
}

OffsetVerdict check_offset(const OffsetCase& wanted,
                           const cnc::contour::ContourView<double>& result,
                           std::uint64_t seed) {
  return OffsetCheck{wanted, result, seed}.run();
}

}  // namespace proof
