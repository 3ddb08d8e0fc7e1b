#include "host-sim/cut/refine_beginnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "host-sim/cut/own_costs.hpp"

namespace sim::cut {
namespace {

/// Greatest number of strokes of a path on which the search tries all strokes.
constexpr std::size_t kFewStrokes = 32;
/// Number of strokes on either side of the present beginning that are tried on longer paths.
constexpr std::size_t kStrokesAround = 3;
constexpr double kMarginMm = 0.2;  ///< Least distance between a beginning and an end of its stroke.
/// Upper limit of kMarginMm, as a share of the length of the stroke.
constexpr double kMarginShare = 0.25;
constexpr double kGolden = 0.618033988749895;
constexpr double kEndlessly = std::numeric_limits<double>::infinity();

double cost_between(const RapidCost& cost, const Place& from, const Place& to) {
  return cost(to.x() - from.x(), to.y() - from.y());
}

/// For each beginning of a cut, the cost of the order up to it and the best beginning of the
/// previous cut.
struct Layer {
  std::vector<double> cost;
  std::vector<std::size_t> before;
};

Layer layer_after(const Layer& last,
                  const UnbegunCut& from,
                  const UnbegunCut& to,
                  const RapidCost& cost) {
  Layer layer{std::vector<double>(to.beginnings.size(), kEndlessly),
              std::vector<std::size_t>(to.beginnings.size())};
  for (std::size_t k = 0; k < to.beginnings.size(); ++k) {
    for (std::size_t b = 0; b < from.beginnings.size(); ++b) {
      const double sum =
          last.cost[b] + cost_between(cost, from.beginnings[b].exit, to.beginnings[k].entry);
      if (sum >= layer.cost[k]) continue;
      layer.cost[k] = sum;
      layer.before[k] = b;
    }
    layer.cost[k] += to.own_cost_of(k);
  }
  return layer;
}

/// Finds the best point for the beginning of one cut, whose rapids come from one given point and
/// lead to another.
class Mover {
 public:
  Mover(const UnbegunCut& cut, const RapidCost& cost, const Place& from, const Place& to)
      : cut_{cut}, cost_{cost}, from_{from}, to_{to} {}

  [[nodiscard]] double cost_of(const Beginning& beginning) const {
    return rapids_of(beginning) + own_cost_at(cut_, beginning);
  }
  [[nodiscard]] Beginning at(const Beginning& present, double way_mm) const {
    return moved_to(present, cut_.path, cut_.settings, way_mm);
  }

  /// Returns the best beginning on a stroke. Uses a golden section search on the cost of the
  /// rapids, which has one minimum along a straight stroke. The own cost of the cut hardly changes
  /// there.
  [[nodiscard]] Beginning best_on(std::size_t stroke, const Beginning& present) const {
    constexpr int kSteps = 24;
    const double length = cut_.path.way_to(stroke + 1) - cut_.path.way_to(stroke);
    const double margin = std::min(kMarginMm, kMarginShare * length);
    double low = cut_.path.way_to(stroke) + margin;
    double high = cut_.path.way_to(stroke + 1) - margin;
    double a = high - kGolden * (high - low);
    double b = low + kGolden * (high - low);
    double cost_a = rapids_of(at(present, a));
    double cost_b = rapids_of(at(present, b));
    for (int i = 0; i < kSteps && high - low > 1.0e-4; ++i) {
      if (cost_a <= cost_b) {
        high = b;
        b = a;
        cost_b = cost_a;
        a = high - kGolden * (high - low);
        cost_a = rapids_of(at(present, a));
      } else {
        low = a;
        a = b;
        cost_a = cost_b;
        b = low + kGolden * (high - low);
        cost_b = rapids_of(at(present, b));
      }
    }
    return at(present, cost_a <= cost_b ? a : b);
  }

 private:
  [[nodiscard]] double rapids_of(const Beginning& beginning) const {
    return cost_between(cost_, from_, beginning.entry) + cost_between(cost_, beginning.exit, to_);
  }

  const UnbegunCut& cut_;
  const RapidCost& cost_;
  Place from_;
  Place to_;
};

/// Returns whether a stroke is an arc of half a kerf around a corner of the part.
bool is_round_corner(const Stroke& stroke, double half_kerf_mm) {
  if (stroke.bulge <= 0.0 || half_kerf_mm <= 0.0) return false;
  return length_of(stroke) / (4.0 * std::atan(stroke.bulge)) < half_kerf_mm + 1.0e-6;
}

/// Moves one beginning to the best point.
/// @return the gain; 0 if the beginning does not move
double move_one(Beginning& beginning,
                const UnbegunCut& cut,
                const Mover& mover,
                const Clearance& edges) {
  const LeadRoom room{edges, cut.half_kerf_mm};
  const std::size_t count = cut.path.strokes().size();
  std::size_t present_stroke = 0;
  while (present_stroke + 1 < count && cut.path.way_to(present_stroke + 1) <= beginning.way_mm) {
    ++present_stroke;
  }
  const double present = mover.cost_of(beginning);
  double least = present - 1.0e-6;
  Beginning best = beginning;
  const std::size_t tried = count <= kFewStrokes ? count : 2 * kStrokesAround + 1;
  for (std::size_t k = 0; k < tried; ++k) {
    const std::size_t stroke =
        count <= kFewStrokes ? k : (present_stroke + count + k - kStrokesAround) % count;
    const double from = cut.path.way_to(stroke);
    const double length = cut.path.way_to(stroke + 1) - from;
    if (cut.settings.start == StartAt::kStraight &&
        is_round_corner(cut.path.strokes()[stroke], cut.half_kerf_mm)) {
      continue;
    }
    // Moving the beginning by a distance changes each of its two rapids by at most about this
    // distance.
    if (mover.cost_of(mover.at(beginning, from + 0.5 * length)) - length > least) continue;
    const Beginning wanted = mover.best_on(stroke, beginning);
    if (mover.cost_of(wanted) >= least) continue;
    for (const double share : {1.0, 0.5, 0.25}) {
      const double way = share == 1.0
                             ? wanted.way_mm
                             : beginning.way_mm + share * (wanted.way_mm - beginning.way_mm);
      if (share < 1.0 && stroke != present_stroke) break;
      const Beginning moved = mover.at(beginning, way);
      if (mover.cost_of(moved) >= least) break;
      if (moved.has_leads &&
          !have_room(leads_at(cut.path, way, cut.settings, moved.lead_share), room)) {
        continue;
      }
      least = mover.cost_of(moved);
      best = moved;
      break;
    }
  }
  beginning = best;
  return present - mover.cost_of(best);
}

/// Records that a beginning did not move while its rapids had the ends `from` and `to`. With the
/// same ends, it would not move again.
struct Settled {
  bool has_stayed = false;
  Place from{0.0, 0.0};
  Place to{0.0, 0.0};

  [[nodiscard]] bool is_between(const Place& before, const Place& behind) const {
    return has_stayed && from == before && to == behind;
  }
};

}  // namespace

void choose_beginnings(std::vector<OrderedCut>& order,
                       const std::vector<UnbegunCut>& cuts,
                       const RapidCost& cost,
                       const JobEnds& ends) {
  if (order.empty()) return;
  UnbegunCut home{.path = MeasuredRow{{}}, .settings = {}};
  home.beginnings = {{.entry = ends.to, .exit = ends.from}};
  std::vector<Layer> layers{{{0.0}, {0}}};
  const UnbegunCut* last = &home;
  for (const OrderedCut& ordered : order) {
    layers.push_back(layer_after(layers.back(), *last, cuts[ordered.cut], cost));
    last = &cuts[ordered.cut];
  }
  const Layer end = layer_after(layers.back(), *last, home, cost);
  std::size_t chosen = end.before.front();
  for (std::size_t i = order.size(); i-- > 0;) {
    order[i].beginning = cuts[order[i].cut].beginnings[chosen];
    chosen = layers[i + 1].before[chosen];
  }
}

double cost_along(const std::vector<OrderedCut>& order,
                  const std::vector<UnbegunCut>& cuts,
                  const RapidCost& cost,
                  const JobEnds& ends) {
  const Place* here = &ends.from;
  double sum = 0.0;
  for (const OrderedCut& ordered : order) {
    sum += cost_between(cost, *here, ordered.beginning.entry);
    sum += own_cost_at(cuts[ordered.cut], ordered.beginning);
    here = &ordered.beginning.exit;
  }
  return sum + cost_between(cost, *here, ends.to);
}

double refine_beginnings(std::vector<OrderedCut>& order,
                         const std::vector<UnbegunCut>& cuts,
                         const RapidCost& cost,
                         const JobEnds& ends,
                         const Clearance& edges,
                         int rounds) {
  // Least gain of a pass that continues, as a share of the first gain.
  constexpr double kHardlyAnything = 1.0e-4;
  double sum = 0.0;
  double first = 0.0;
  std::vector<Settled> settled(order.size());
  for (int round = 0; round < rounds; ++round) {
    double gain = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const UnbegunCut& cut = cuts[order[i].cut];
      if (!cut.may_move) continue;
      const Place& from = i == 0 ? ends.from : order[i - 1].beginning.exit;
      const Place& to = i + 1 == order.size() ? ends.to : order[i + 1].beginning.entry;
      if (settled[i].is_between(from, to)) continue;
      const double by = move_one(order[i].beginning, cut, Mover{cut, cost, from, to}, edges);
      settled[i] = {by == 0.0, from, to};
      gain += by;
    }
    if (round == 0) first = gain;
    sum += gain;
    if (gain <= kHardlyAnything * first) break;
  }
  return sum;
}

}  // namespace sim::cut
