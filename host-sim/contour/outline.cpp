#include "host-sim/contour/outline.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

#include "host-sim/contour/free_form_row.hpp"
#include "host-sim/contour/known_rows.hpp"
#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/sketch.hpp"
#include "planner/base/contract.hpp"

namespace sim {
namespace {

using cnc::contour::CurvePiece;
using cnc::contour::FitEnd;
using cnc::contour::FitError;
using cnc::contour::SplitError;
using drawing::Place;
using drawing::Shape;

constexpr std::size_t kFirstFitSamples = 4'096;
// Greatest number of samples for one fit. This many take half a gigabyte.
constexpr std::size_t kMaxFitSamples = std::size_t{1} << 22;
constexpr std::size_t kMaxPieces = std::size_t{1} << 16;

/// Returns the direction of travel at the start or the end of a shape; the null vector if the shape
/// has none.
Place direction_at(const Shape& shape, bool at_end) {
  const std::size_t span = at_end ? span_count(shape) - 1 : 0;
  const drawing::Jet found = jet(shape, span, at_end ? 1.0 : 0.0);
  constexpr double kVanishing = 1.0e-9;
  if (found.first.norm() > kVanishing * found.second.norm()) return found.first.normalized();
  if (!(found.second.norm() > 0.0)) return {0.0, 0.0};
  return (at_end ? -1.0 : 1.0) * found.second.normalized();
}

bool goes_on_smoothly(const Shape& before, const Shape& after) {
  const Place from = direction_at(before, true);
  const Place to = direction_at(after, false);
  return from.dot(to) > 0.0 && std::abs(cnc::cross(from, to)) <= kDrawnSmooth;
}

/// Returns whether two consecutive shapes belong to one row, so that a single fit covers both.
bool is_one_row(const Shape& before, const Shape& after) {
  return is_free_form(before) && is_free_form(after) && goes_on_smoothly(before, after);
}

/// Returns whether a free-form curve is a speck: so short that each of its points is within the
/// tolerance of its start.
bool is_speck(const Shape& shape, double tolerance_mm) {
  constexpr double kLongestHull = 8.0;
  if (!is_free_form(shape) || drawing::length_of_hull(shape) > kLongestHull * tolerance_mm) {
    return false;
  }
  const Place start = start_of(shape);
  const auto is_near = [&](const Place& place) {
    return drawing::distance(start, place) <= 0.75 * tolerance_mm;
  };
  return std::ranges::all_of(drawing::outline_of(std::span{&shape, 1}, 0.25 * tolerance_mm),
                             is_near);
}

/// Returns shapes without specks. A speck is replaced by a line, or dropped if it ends at its
/// start.
std::vector<Shape> without_specks(const std::vector<Shape>& shapes, double tolerance_mm) {
  std::vector<Shape> kept;
  kept.reserve(shapes.size());
  for (const Shape& shape : shapes) {
    if (!is_speck(shape, tolerance_mm)) {
      kept.push_back(shape);
    } else if (start_of(shape) != end_of(shape)) {
      kept.emplace_back(drawing::Line{start_of(shape), end_of(shape)});
    }
  }
  return kept.empty() ? shapes : kept;
}

/// The conditions on the arcs of a row at its ends.
struct RowEnds {
  FitEnd start = FitEnd::kPlace;
  FitEnd end = FitEnd::kPlace;
};

/// Fits arcs to a row of curves.
class RowFitter {
 public:
  explicit RowFitter(const OutlineOptions& options) : options_{options} {}

  [[nodiscard]] FittedRow fit(std::span<const Shape> shapes, const RowEnds& ends) {
    row_ = {};
    const FreeFormRow row{shapes};
    std::vector<CurvePiece> pieces(16);
    auto count = split_offset(row, 0.0, pieces, kDrawnSmooth);
    while (!count.ok() && count.error() == SplitError::kTooManyPieces &&
           pieces.size() < kMaxPieces) {
      pieces.resize(2 * pieces.size());
      count = split_offset(row, 0.0, pieces, kDrawnSmooth);
    }
    if (!count.ok()) {
      fail(start_of(shapes.front()), "a part of the curve that begins here is a single point");
      return std::move(row_);
    }
    for (std::size_t i = 0; i < count.value() && row_.fault == nullptr; ++i) {
      const bool last = i + 1 == count.value();
      fit_piece(pieces[i], i == 0 ? ends.start : FitEnd::kPlace, last ? ends.end : FitEnd::kPlace);
    }
    return std::move(row_);
  }

 private:
  void fit_piece(const CurvePiece& piece, FitEnd start, FitEnd end) {
    const cnc::contour::FitOptions options{.tolerance_mm = options_.tolerance_mm,
                                           .method = options_.method,
                                           .start = start,
                                           .end = end};
    for (std::size_t size = kFirstFitSamples; size <= kMaxFitSamples; size *= 4) {
      samples_.resize(std::max(samples_.size(), size));
      links_.resize(samples_.size() / 8);
      fitted_.resize(samples_.size() / 4);
      const auto made = fit_arcs(piece, options, {samples_, links_}, fitted_);
      if (made.ok()) {
        const auto arcs = std::span{fitted_}.first(made.value());
        row_.vertices.insert(row_.vertices.end(), arcs.begin(), arcs.end());
        return;
      }
      if (made.error() == FitError::kNoFit) break;
    }
    fail(piece.at(piece.from).place,
         "no arcs within the tolerance were found for the curves that begin here");
  }

  void fail(const Place& place, const char* reason) { row_ = {{}, reason, place}; }

  const OutlineOptions& options_;
  std::vector<cnc::contour::CurveSample> samples_;
  std::vector<cnc::contour::FitLink> links_;
  std::vector<ContourVertex> fitted_;
  FittedRow row_;
};

/// Converts the shapes of one contour to vertices of lines and arcs.
class ContourFitter {
 public:
  ContourFitter(const drawing::DrawnContour& contour,
                const OutlineOptions& options,
                KnownRows& known)
      : contour_{contour},
        options_{options},
        known_{known},
        shapes_{without_specks(contour.shapes, options.tolerance_mm)},
        fitter_{options} {}

  [[nodiscard]] FittedContour run() {
    if (contour_.closed) begin_between_rows();
    std::size_t index = 0;
    while (index < shapes_.size() && !fault_) {
      if (const auto* const line = std::get_if<drawing::Line>(&shapes_[index])) {
        add(line->start, 0.0);
        ++index;
      } else if (const auto* const arc = std::get_if<drawing::Arc>(&shapes_[index])) {
        add_arc(*arc);
        ++index;
      } else {
        index = fit_row(index);
      }
    }
    if (fault_) return {{}, std::move(fault_)};
    if (!contour_.closed) add(end_of(shapes_.back()), 0.0);
    return {std::move(vertices_), {}};
  }

 private:
  void begin_between_rows() {
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const Shape& before = shapes_[i == 0 ? shapes_.size() - 1 : i - 1];
      if (is_one_row(before, shapes_[i])) continue;
      // Uses std::rotate, because Clang 14 does not compile the range that std::ranges::rotate
      // returns.
      std::rotate(shapes_.begin(), shapes_.begin() + static_cast<std::ptrdiff_t>(i), shapes_.end());
      return;
    }
  }

  void add(const Place& place, double bulge) { vertices_.push_back({place.x(), place.y(), bulge}); }

  void add_arc(const drawing::Arc& arc) {
    if (std::abs(arc.sweep) <= 0.5 * drawing::kFullTurn) {
      add(arc.start, std::tan(0.25 * arc.sweep));
      return;
    }
    const Place radius = arc.start - arc.centre;
    const Place turn = drawing::direction(0.5 * arc.sweep);
    const Place left{-radius.y(), radius.x()};
    add(arc.start, std::tan(0.125 * arc.sweep));
    add(arc.centre + turn.x() * radius + turn.y() * left, std::tan(0.125 * arc.sweep));
  }

  /// Returns whether the contour has no corner at the start of a shape. For the first shape of a
  /// closed contour, checks the transition from the last shape.
  [[nodiscard]] bool arrives_smoothly(std::size_t index) const {
    if (index > 0) return goes_on_smoothly(shapes_[index - 1], shapes_[index % shapes_.size()]);
    return contour_.closed && goes_on_smoothly(shapes_.back(), shapes_.front());
  }
  [[nodiscard]] bool leaves_smoothly(std::size_t end) const {
    if (end < shapes_.size()) return arrives_smoothly(end);
    return arrives_smoothly(0);
  }

  /// Fits arcs to the row that begins at a shape.
  /// @return the index of the shape after the row
  [[nodiscard]] std::size_t fit_row(std::size_t from) {
    std::size_t end = from + 1;
    while (end < shapes_.size() && is_one_row(shapes_[end - 1], shapes_[end])) ++end;
    const std::span<const Shape> row = std::span{shapes_}.subspan(from, end - from);
    const RowEnds ends{arrives_smoothly(from) ? FitEnd::kTangent : FitEnd::kPlace,
                       leaves_smoothly(end) ? FitEnd::kTangent : FitEnd::kPlace};
    if (auto shape = RowShape::of(row)) {
      shape->add(std::bit_cast<std::int64_t>(options_.tolerance_mm));
      shape->add(static_cast<std::int64_t>(options_.method));
      shape->add(static_cast<std::int64_t>(ends.start));
      shape->add(static_cast<std::int64_t>(ends.end));
      const auto fit = [&] { return fitter_.fit(shape->curves(), ends); };
      add_row(known_.find_or_fit(*shape, fit), start_of(row.front()));
    } else {
      add_row(fitter_.fit(row, ends), {0.0, 0.0});
    }
    return end;
  }

  void add_row(const FittedRow& row, const Place& origin) {
    if (row.fault != nullptr) return fail(origin + row.fault_place, row.fault);
    for (const ContourVertex& vertex : row.vertices) add(origin + vertex.point(), vertex.bulge);
  }

  void fail(const Place& place, const char* reason) {
    fault_ = drawing::Fault{drawing::FaultKind::kNoArcs,
                            contour_.entity,
                            place,
                            reason,
                            "draw it again, or set another tolerance"};
  }

  const drawing::DrawnContour& contour_;
  const OutlineOptions& options_;
  KnownRows& known_;
  std::vector<Shape> shapes_;
  RowFitter fitter_;
  std::vector<ContourVertex> vertices_;
  std::optional<drawing::Fault> fault_;
};

}  // namespace

std::string_view name_of(cnc::contour::FitMethod method) {
  return method == cnc::contour::FitMethod::kFewest ? "fewest" : "paper";
}

bool is_free_form(const Shape& shape) {
  return !std::holds_alternative<drawing::Line>(shape) &&
         !std::holds_alternative<drawing::Arc>(shape);
}

FittedContour arcs_of(const drawing::DrawnContour& contour,
                      const OutlineOptions& options,
                      KnownRows& known) {
  CNC_ASSERT(options.tolerance_mm >= kMinToleranceMm &&
             options.tolerance_mm <= kGreatestToleranceMm);
  return ContourFitter{contour, options, known}.run();
}

FittedContour arcs_of(const drawing::DrawnContour& contour, const OutlineOptions& options) {
  KnownRows known;
  return arcs_of(contour, options, known);
}

Outline outline_of(const drawing::Drawing& drawing, const OutlineOptions& options) {
  Outline outline;
  KnownRows known;
  for (std::size_t i = 0; i < drawing.contours.size(); ++i) {
    if (!drawing.contours[i].closed) continue;
    FittedContour fitted = arcs_of(drawing.contours[i], options, known);
    if (fitted.fault) {
      outline.faults.push_back(std::move(*fitted.fault));
      continue;
    }
    auto& vertices = outline.contour.vertices;
    vertices.insert(vertices.end(), fitted.vertices.begin(), fitted.vertices.end());
    outline.contour.end_loop();
    outline.drawn.push_back(i);
  }
  return outline;
}

}  // namespace sim
