#include "host-sim/cut/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/controller_way.hpp"
#include "host-sim/cut/drawn_strokes.hpp"
#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/order.hpp"
#include "host-sim/cut/unfulfilled.hpp"
#include "planner/base/contract.hpp"

namespace sim::cut {
namespace {

using drawing::DrawnContour;
using drawing::FaultKind;

/// A cut may be nearer to a drawn edge by so much before it is told, mm.
constexpr double kGougeSlack = 1.0e-4;
constexpr double kLookForGougesEvery = 0.1;  ///< mm.
constexpr double kLookForRestsEvery = 0.05;  ///< mm.

/// A drawn contour that is cut, as strokes with the part on the left.
struct Outline {
  std::vector<Stroke> strokes;
  bool is_hole = false;
  bool is_beside = false;  ///< Half a kerf beside its line; else on it.
};

void turn_round(std::vector<Stroke>& strokes) {
  std::ranges::reverse(strokes);
  for (Stroke& stroke : strokes) {
    std::swap(stroke.from, stroke.to);
    stroke.bulge = -stroke.bulge;
  }
}

Contour contour_of(const std::vector<Stroke>& strokes) {
  Contour contour;
  for (const Stroke& stroke : strokes) {
    contour.vertices.push_back({stroke.from.x(), stroke.from.y(), stroke.bulge});
  }
  contour.end_loop();
  return contour;
}

std::vector<std::vector<Stroke>> loops_of(const cnc::contour::ContourView<double>& view) {
  std::vector<std::vector<Stroke>> loops;
  for (std::size_t i = 0; i < view.loop_ends.size(); ++i) {
    std::vector<Stroke>& loop = loops.emplace_back();
    const std::uint32_t first = view.loop_begin(i);
    for (std::uint32_t k = first; k < view.loop_ends[i]; ++k) {
      const ContourVertex& from = view.vertices[k];
      const ContourVertex& to = view.vertices[k + 1 < view.loop_ends[i] ? k + 1 : first];
      loop.push_back({{from.x, from.y}, {to.x, to.y}, from.bulge});
    }
  }
  return loops;
}

/// What the strokes of a closed row enclose, positive where they turn left, mm².
double area_of(const std::vector<Stroke>& loop) {
  const Place from = loop.front().from;
  double twice = 0.0;
  for (const Stroke& stroke : loop) {
    twice += drawing::cross(stroke.from - from, stroke.to - from);
    if (stroke.bulge == 0.0) continue;
    const double sweep = 4.0 * std::atan(stroke.bulge);
    const double chord = drawing::distance(stroke.from, stroke.to);
    const double radius = 0.5 * chord / std::sin(0.5 * std::abs(sweep));
    twice += radius * radius * (sweep - std::sin(sweep));
  }
  return 0.5 * twice;
}

void append(std::vector<drawing::Fault>& faults, const std::vector<drawing::Fault>& more) {
  faults.insert(faults.end(), more.begin(), more.end());
}

double widest_kerf(const std::vector<LayerPlan>& layers, const Recipes& recipes) {
  double widest = 1.0e-3;
  for (const LayerPlan& layer : layers) widest = std::max(widest, layer.condition.kerf_mm);
  for (const LayerPlan& plan : recipes.plans) widest = std::max(widest, plan.condition.kerf_mm);
  return widest;
}

/// Makes the plan of one drawing, contour by contour.
class Planner {
 public:
  Planner(const drawing::Drawing& drawn,
          std::vector<LayerPlan> layers,
          const OutlineOptions& curves,
          WayBeside beside,
          Recipes recipes)
      : drawn_{drawn},
        beside_{beside},
        reach_mm_{2.0 * widest_kerf(layers, recipes)},
        edges_{reach_mm_} {
    plan_.layers = std::move(layers);
    plan_.recipes = std::move(recipes);
    plan_.curves = curves;
  }

  CutPlan make() {
    sort_contours();
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      for (const Stroke& stroke : outlines_[i].strokes) {
        if (outlines_[i].is_beside) edges_.add(stroke, i);
      }
    }
    edges_.prepare();
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      if (outlines_[i].is_beside) cut_beside(i);
      if (!outlines_[i].is_beside && !outlines_[i].strokes.empty()) cut_along(i);
    }
    put_parts_last();
    plan_.cuts = in_order(std::move(plan_.cuts));
    return std::move(plan_);
  }

 private:
  [[nodiscard]] const LayerPlan& layer_of(std::size_t contour) const {
    return plan_.recipes.of(contour, plan_.layers[drawn_.contours[contour].entity.layer]);
  }
  [[nodiscard]] double half_kerf(std::size_t contour) const {
    return 0.5 * layer_of(contour).condition.kerf_mm;
  }
  void fault(FaultKind kind,
             std::size_t contour,
             const Place& place,
             const std::string& reason,
             const std::string& remedy) {
    plan_.faults.push_back({kind, drawn_.contours[contour].entity, place, reason, remedy});
  }

  void sort_contours();
  void cut_beside(std::size_t i);
  void cut_along(std::size_t i);
  void look_for_gouges(std::size_t i, const std::vector<Stroke>& loop);
  void look_for_rests(std::size_t i, const std::vector<std::vector<Stroke>>& loops);
  void add_cut(std::size_t i, const std::vector<Stroke>& loop);
  void leave_to_controller(Cut& cut, bool one_loop);
  void put_parts_last();

  const drawing::Drawing& drawn_;
  WayBeside beside_;
  CutPlan plan_;
  std::vector<Outline> outlines_;  ///< One for each contour; empty ones are not cut.
  double reach_mm_;                ///< Twice the widest kerf: nothing farther matters.
  Clearance edges_;
  ContourOffset offset_;
  std::set<std::size_t> told_layers_;  ///< Those with a cut on the line, so far.
};

/// Contours that are not cut beside their line are no parts, and nothing is a hole in them.
void Planner::sort_contours() {
  outlines_.resize(drawn_.contours.size());
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    const DrawnContour& contour = drawn_.contours[i];
    const Side side = layer_of(i).settings.side;
    if (side == Side::kSkip) continue;
    // Open ones are among the drawing's own faults.
    if (!contour.closed && side == Side::kWaste) continue;
    DrawnStrokes drawn = strokes_of(contour, plan_.curves);
    if (drawn.fault) {
      plan_.faults.push_back(std::move(*drawn.fault));
      continue;
    }
    outlines_[i].strokes = std::move(drawn.strokes);
    outlines_[i].is_beside = side == Side::kWaste;
  }
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    if (!outlines_[i].is_beside) continue;
    std::size_t depth = 0;
    for (auto p = drawn_.contours[i].parent; p; p = drawn_.contours[*p].parent) {
      if (outlines_[*p].is_beside) ++depth;
    }
    outlines_[i].is_hole = depth % 2 == 1;
    if ((area_of(outlines_[i].strokes) < 0.0) != outlines_[i].is_hole) {
      turn_round(outlines_[i].strokes);
    }
  }
}

void Planner::cut_beside(std::size_t i) {
  const Contour contour = contour_of(outlines_[i].strokes);
  std::vector<std::vector<Stroke>> loops;
  try {
    loops = loops_of(offset_.offset(contour.view(), half_kerf(i)));
  } catch (const NoOffset& failure) {
    return fault(FaultKind::kTooMuch, i, failure.place(), failure.reason(), failure.remedy());
  }
  if (loops.empty()) {
    return fault(
        FaultKind::kTooSmall,
        i,
        outlines_[i].strokes.front().from,
        fmt::format("is narrower than the kerf of {:.3f} mm and would vanish", 2.0 * half_kerf(i)),
        "make it wider, cut it on the line with side=on, or skip its layer");
  }
  look_for_rests(i, loops);
  for (const std::vector<Stroke>& loop : loops) {
    look_for_gouges(i, loop);
    add_cut(i, loop);
    if (beside_ == WayBeside::kOnController) {
      leave_to_controller(plan_.cuts.back(), loops.size() == 1);
    }
  }
}

void Planner::cut_along(std::size_t i) {
  Cut cut{.contour = i, .layer = drawn_.contours[i].entity.layer};
  cut.strokes = outlines_[i].strokes;
  if (told_layers_.insert(cut.layer).second) {
    append(plan_.warnings,
           unfulfilled_on_line(layer_of(i).settings, drawn_.contours[i].entity, cut.start()));
  }
  plan_.cuts.push_back(std::move(cut));
}

/// Tells where a cut would take most off a part.
void Planner::look_for_gouges(std::size_t i, const std::vector<Stroke>& loop) {
  const double half = half_kerf(i);
  Clearance::Nearest worst{half - kGougeSlack, i};
  Place where{0.0, 0.0};
  for (const Stroke& stroke : loop) {
    const auto looks = static_cast<int>(std::ceil(length_of(stroke) / kLookForGougesEvery));
    for (int k = 1; k <= looks; ++k) {  // The start is the end of the stroke before.
      const Place place = place_at(stroke, static_cast<double>(k) / looks);
      const Clearance::Nearest nearest = edges_.nearest(place);
      if (nearest.distance_mm >= worst.distance_mm) continue;
      worst = nearest;
      where = place;
    }
  }
  if (worst.distance_mm >= half - kGougeSlack) return;
  const std::string& other = drawn_.contours[worst.owner].entity.name;
  fault(FaultKind::kCrossing,
        i,
        where,
        fmt::format("its cut takes {:.3f} mm off {}", half - worst.distance_mm, other),
        fmt::format("put them at least the kerf apart, {:.3f} mm", 2.0 * half));
}

/// Tells where the drawn line is so narrow that the beam does not come near it: farther than a
/// kerf instead of half of one, as in slots and in corners sharper than 60 degrees.
void Planner::look_for_rests(std::size_t i, const std::vector<std::vector<Stroke>>& loops) {
  Clearance paths{reach_mm_};
  for (const auto& loop : loops) {
    for (const Stroke& stroke : loop) paths.add(stroke, 0);
  }
  paths.prepare();
  const double kerf = 2.0 * half_kerf(i);
  std::vector<Place> rest;
  double rest_mm = 0.0;
  const auto tell = [&] {
    if (rest.empty()) return;
    drawing::Fault fault{
        FaultKind::kTooSmall, drawn_.contours[i].entity, rest[rest.size() / 2], {}, {}};
    fault.reason = fmt::format(
        "is too narrow here for the kerf of {:.3f} mm: {:.3f} mm of it stay uncut", kerf, rest_mm);
    fault.remedy = "round the corner or widen the slot";
    plan_.warnings.push_back(fault);
    rest.clear();
    rest_mm = 0.0;
  };
  for (const Stroke& stroke : outlines_[i].strokes) {
    const double length = length_of(stroke);
    const auto looks = static_cast<int>(std::ceil(length / kLookForRestsEvery));
    for (int k = 1; k <= looks; ++k) {
      const Place place = place_at(stroke, static_cast<double>(k) / looks);
      if (paths.nearest(place).distance_mm <= kerf) {
        tell();
      } else {
        rest.push_back(place);
        rest_mm += length / looks;
      }
    }
  }
  tell();
}

void Planner::add_cut(std::size_t i, const std::vector<Stroke>& loop) {
  const LayerSettings& settings = layer_of(i).settings;
  Cut cut{.contour = i,
          .layer = drawn_.contours[i].entity.layer,
          .is_hole = outlines_[i].is_hole,
          .area_mm2 = area_of(loop)};
  // Only what falls out and is wanted is held.
  const unsigned tabs = cut.area_mm2 > 0.0 ? settings.tabs : 0;
  const double least_turn = settings.corner_angle_deg * std::numbers::pi / 180.0;
  for (const Corner& corner : corners_of(loop, least_turn, half_kerf(i))) {
    cut.corners.push_back(corner.place);
  }
  LedCut led = with_leads(MeasuredRow{loop}, settings, tabs, {edges_, half_kerf(i)});
  append(plan_.warnings, unfulfilled(led, drawn_.contours[i].entity, tabs));
  cut.strokes = std::move(led.strokes);
  plan_.cuts.push_back(std::move(cut));
}

/// Where the controller cannot find the way beside the part, it is given the way itself.
void Planner::leave_to_controller(Cut& cut, bool one_loop) {
  const LayerSettings& settings = layer_of(cut.contour).settings;
  ControllerWay way;
  if (!one_loop) {
    way.reason = "the kerf parts it";
  } else if (settings.tabs != 0 && !cut.is_hole) {
    way.reason = "it has tabs";
  } else if (settings.corner_loop_mm > 0.0 || settings.corner_dwell_s > 0.0) {
    way.reason = "it has corner loops or dwells";
  } else {
    way = controller_way(
        outlines_[cut.contour].strokes, cut.strokes, settings, {edges_, half_kerf(cut.contour)});
  }
  cut.programmed = std::move(way.strokes);
  if (way.reason.empty()) return;
  plan_.warnings.push_back({FaultKind::kTooSmall,
                            drawn_.contours[cut.contour].entity,
                            cut.start(),
                            "is not left to the controller: " + way.reason,
                            "its way has the kerf that is planned; it changes with no override"});
}

/// Orders each cut after all cuts that lie inside its outline, of any part, and those on a line: it
/// frees the material around them.
void Planner::put_parts_last() {
  std::vector<std::vector<std::size_t>> cuts_of(outlines_.size());
  for (std::size_t i = 0; i < plan_.cuts.size(); ++i) {
    cuts_of[plan_.cuts[i].contour].push_back(i);
  }
  const auto frees = [this](std::size_t a, std::size_t b) {
    return std::abs(plan_.cuts[a].area_mm2) < std::abs(plan_.cuts[b].area_mm2);
  };
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    if (!outlines_[i].is_beside || cuts_of[i].empty()) continue;
    const std::size_t last = *std::ranges::max_element(cuts_of[i], frees);
    for (const std::size_t other : cuts_of[i]) {
      if (other != last) plan_.cuts[last].after.push_back(other);
    }
  }
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    auto around = drawn_.contours[i].lies_in;
    while (around && !outlines_[*around].is_beside) around = drawn_.contours[*around].lies_in;
    if (!around) continue;
    for (const std::size_t inner : cuts_of[i]) {
      for (const std::size_t outer : cuts_of[*around]) plan_.cuts[outer].after.push_back(inner);
    }
  }
}

}  // namespace

CutPlan plan_cuts(const drawing::Drawing& drawn,
                  std::vector<LayerPlan> layers,
                  const OutlineOptions& curves,
                  WayBeside beside,
                  Recipes recipes) {
  CNC_ASSERT(layers.size() == drawn.layers.size());
  return Planner{drawn, std::move(layers), curves, beside, std::move(recipes)}.make();
}

}  // namespace sim::cut
