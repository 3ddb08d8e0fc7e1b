#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/planner/contour/ellipse_curve.hpp"
#include "tests/planner/contour/nurbs_curve.hpp"
#include "tests/support/random_source.hpp"

namespace cnc::contour::exact {

/// A curve by a formula, with a parameter that increases evenly over equal spans.
class FunctionCurve final : public PlaneCurve {
 public:
  using Function = std::function<CurveJet(double)>;
  FunctionCurve(Function function, double from, double to, std::size_t spans)
      : function_{std::move(function)},
        from_{from},
        width_{(to - from) / static_cast<double>(spans)},
        spans_{spans} {}

  [[nodiscard]] std::size_t span_count() const override { return spans_; }
  [[nodiscard]] CurveJet at(std::size_t span, double share) const override {
    CurveJet jet = function_(from_ + width_ * (static_cast<double>(span) + share));
    jet.first *= width_;
    jet.second *= width_ * width_;
    return jet;
  }

 private:
  Function function_;
  double from_;
  double width_;
  std::size_t spans_;
};

/// A NURBS curve that owns its control points and knots.
class OwnedNurbs {
 public:
  OwnedNurbs(std::size_t degree, std::vector<WeightedPlace> points, std::vector<double> knots)
      : points_{std::move(points)},
        knots_{std::move(knots)},
        curve_{NurbsCurve::make(degree, points_, knots_).value()} {}
  /// Creates uniform knots, clamped at both ends.
  OwnedNurbs(std::size_t degree, const std::vector<WideVec2>& points)
      : OwnedNurbs{degree, with_weights(points), uniform(degree, points.size())} {}
  OwnedNurbs(const OwnedNurbs&) = delete;
  OwnedNurbs& operator=(const OwnedNurbs&) = delete;

  [[nodiscard]] const NurbsCurve& curve() const { return curve_; }

  static std::vector<double> uniform(std::size_t degree, std::size_t count) {
    std::vector<double> knots(degree + 1, 0.0);
    for (std::size_t i = 1; i < count - degree; ++i) knots.push_back(static_cast<double>(i));
    knots.resize(count + degree + 1, static_cast<double>(count - degree));
    return knots;
  }
  static std::vector<WeightedPlace> with_weights(const std::vector<WideVec2>& points) {
    std::vector<WeightedPlace> weighted;
    for (const WideVec2& point : points) weighted.push_back({point, 1.0});
    return weighted;
  }

 private:
  std::vector<WeightedPlace> points_;
  std::vector<double> knots_;
  NurbsCurve curve_;
};

inline WideVec2 polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// A curve of the comparison with other fits, with its name and its offset distance.
struct NamedCurve {
  const char* name;
  const PlaneCurve* curve;
  double offset_mm;
};

/// Eight classes of curves for comparing fits: smooth ones of 40…200 mm, always the same. Control
/// points come from SplitMix64 with the seed 2026.
class EightCurves {
 public:
  EightCurves() {
    proof::Random random{2026};
    open15_ = std::make_unique<OwnedNurbs>(3, wave(random, 15, 100.0, 40.0, 2.0));
    closed12_ = std::make_unique<OwnedNurbs>(3, ring(random, 12));
    open40_ = std::make_unique<OwnedNurbs>(3, wave(random, 40, 200.0, 30.0, 1.0));
  }

  [[nodiscard]] std::vector<NamedCurve> all() const {
    return {{"B-spline, 15 points", &open15_->curve(), 0.0},
            {"B-spline, 12 points, closed", &closed12_->curve(), 0.0},
            {"B-spline, 40 points", &open40_->curve(), 0.0},
            {"the closed one, 1 mm inwards", &closed12_->curve(), -1.0},
            {"ellipse 80 x 30", &ellipse_, 0.0},
            {"Lissajous 3:2, 80 x 60", &lissajous_, 0.0},
            {"logarithmic spiral", &spiral_, 0.0},
            {"sine, 3 periods", &sine_, 0.0}};
  }

 private:
  static std::vector<WideVec2> wave(
      proof::Random& random, int count, double width, double height, double jitter) {
    std::vector<WideVec2> points;
    for (int i = 0; i < count; ++i) {
      const double x = width * i / (count - 1) + random.between(-jitter, jitter);
      points.push_back(WideVec2{x, height * random.unit()});
    }
    return points;
  }
  static std::vector<WideVec2> ring(proof::Random& random, int count) {
    std::vector<WideVec2> points;
    for (int i = 0; i < count; ++i) {
      const double radius = 20.0 * (1.0 + random.between(-0.35, 0.35));
      points.push_back(polar(radius, 2.0 * std::numbers::pi * i / count));
    }
    points.push_back(points.front());
    return points;
  }
  static CurveJet lissajous(double t) {
    return {.place = {40.0 * std::sin(3.0 * t), 30.0 * std::sin(2.0 * t)},
            .first = {120.0 * std::cos(3.0 * t), 60.0 * std::cos(2.0 * t)},
            .second = {-360.0 * std::sin(3.0 * t), -120.0 * std::sin(2.0 * t)}};
  }
  static CurveJet spiral(double t) {
    constexpr double kGrowth = 0.15;
    const WideVec2 place = polar(2.0 * std::exp(kGrowth * t), t);
    const WideVec2 first = kGrowth * place + left_normal(place);
    return {.place = place, .first = first, .second = kGrowth * first + left_normal(first)};
  }
  static CurveJet sine(double t) {
    return {.place = {t, 10.0 * std::sin(t / 5.0)},
            .first = {1.0, 2.0 * std::cos(t / 5.0)},
            .second = {0.0, -0.4 * std::sin(t / 5.0)}};
  }

  std::unique_ptr<OwnedNurbs> open15_;
  std::unique_ptr<OwnedNurbs> closed12_;
  std::unique_ptr<OwnedNurbs> open40_;
  EllipseCurve ellipse_{{.major = {40.0, 0.0}, .minor = {0.0, 15.0}}};
  FunctionCurve lissajous_{lissajous, 0.0, 2.0 * std::numbers::pi, 24};
  FunctionCurve spiral_{spiral, 0.0, 6.0 * std::numbers::pi, 24};
  FunctionCurve sine_{sine, 0.0, 100.0, 20};
};

/// Generates B-splines of any degree and knots, Bézier curves, rational curves and arcs of
/// ellipses.
class RandomCurve {
 public:
  explicit RandomCurve(proof::Random& random) {
    if (random.chance(0.2)) {
      const double start = random.between(-7.0, 7.0);
      const WideVec2 major = polar(random.between(2.0, 50.0), random.between(-4.0, 4.0));
      ellipse_ = std::make_unique<EllipseCurve>(
          Ellipse{.centre = {random.between(-99.0, 99.0), 0.0},
                  .major = major,
                  .minor = random.between(0.05, 1.0) * left_normal(major),
                  .start = start,
                  .end = start + random.signed_magnitude(0.1, 6.28)});
      return;
    }
    const std::size_t degree = 2 + random.below(4);
    const std::size_t count = degree + 1 + random.below(8);
    const bool rational = random.chance(0.3);
    const double size = random.magnitude(2.0, 100.0);
    const WideVec2 centre{random.between(-99.0, 99.0), random.between(-99.0, 99.0)};
    std::vector<WeightedPlace> points;
    for (std::size_t i = 0; i < count; ++i) {
      const WideVec2 place{random.between(-size, size), random.between(-size, size)};
      points.push_back({centre + place, rational ? random.magnitude(0.2, 5.0) : 1.0});
    }
    std::vector<double> knots = OwnedNurbs::uniform(degree, count);
    if (random.chance(0.5)) {
      for (std::size_t i = degree + 1; i < count; ++i) knots[i] += random.between(-0.4, 0.4);
    }
    nurbs_ = std::make_unique<OwnedNurbs>(degree, std::move(points), std::move(knots));
  }

  [[nodiscard]] const PlaneCurve& curve() const {
    if (ellipse_) return *ellipse_;
    return nurbs_->curve();
  }

 private:
  std::unique_ptr<EllipseCurve> ellipse_;
  std::unique_ptr<OwnedNurbs> nurbs_;
};

}  // namespace cnc::contour::exact
