#include "host-sim/cut/share_lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/shared_stretch.hpp"
#include "planner/base/contract.hpp"

namespace sim::cut {
namespace {

/// Least length of a shared line, in kerfs.
constexpr double kShortestKerfs = 2.0;
/// Distance beyond half a kerf at which the beam still reaches an edge, mm.
constexpr double kReaches = 1.0e-3;

/// Returns whether the beam at both ends of a rest reaches the whole edge of the part along the
/// rest.
bool is_reached_from_ends(const std::vector<Stroke>& rest, double half_kerf_mm) {
  constexpr int kLooks = 8;
  if (length_of(rest) > 4.0 * half_kerf_mm) return false;
  for (const Stroke& stroke : rest) {
    for (int k = 0; k <= kLooks; ++k) {
      const double share = static_cast<double>(k) / kLooks;
      const Place edge =
          place_at(stroke, share) - half_kerf_mm * right_of(tangent_at(stroke, share));
      const double from_ends = std::min(drawing::distance(rest.front().from, edge),
                                        drawing::distance(rest.back().to, edge));
      if (from_ends > half_kerf_mm + kReaches) return false;
    }
  }
  return true;
}

/// The stretches of a path that earlier cuts make, so that the cut of the path loses them.
struct Loss {
  std::vector<SharedStretch> stretches{};
  std::vector<std::size_t> owners{};  ///< Numbers of the earlier cuts that make a stretch.
};

/// Finds the lines that cuts share, and replaces the lists of cuts by lists with shared lines.
class Sharing {
 public:
  Sharing(CutPlan& plan, std::vector<UnbegunCut>& unbegun, const std::vector<std::size_t>& ranks)
      : plan_{plan}, unbegun_{unbegun}, ranks_{ranks}, strokes_{widest()} {}

  void run() {
    for (std::size_t i = 0; i < unbegun_.size(); ++i) {
      if (!may_share(i)) continue;
      for (const Stroke& stroke : unbegun_[i].path.strokes()) {
        strokes_.add(stroke, owner_of_stroke_.size());
        owner_of_stroke_.push_back({i, stroke});
      }
    }
    strokes_.prepare();
    leave_each_a_line();
    rests_.resize(unbegun_.size());
    owners_.resize(unbegun_.size());
    for (std::size_t i = 0; i < unbegun_.size(); ++i) {
      if (may_share(i)) take(i, loss_of(i));
    }
    split();
  }

 private:
  struct OwnedStroke {
    std::size_t cut = 0;
    Stroke stroke{};
  };

  [[nodiscard]] double widest() const {
    double widest_mm = 1.0e-3;
    for (const UnbegunCut& cut : unbegun_) {
      widest_mm = std::max(widest_mm, cut.settings.common_line_mm);
    }
    return widest_mm;
  }
  [[nodiscard]] bool may_share(std::size_t i) const {
    return unbegun_[i].settings.common_line_mm > 0.0 && plan_.cuts[i].area_mm2 != 0.0;
  }
  [[nodiscard]] bool are_cut_alike(std::size_t a, std::size_t b) const {
    return &plan_.plan_of(plan_.cuts[a]) == &plan_.plan_of(plan_.cuts[b]);
  }

  /// Returns the stretches of the path of cut `i` that are made by cuts of lower rank, as distances
  /// along this path.
  [[nodiscard]] Loss loss_of(std::size_t i) const {
    const UnbegunCut& cut = unbegun_[i];
    const double tolerance = cut.settings.common_line_mm;
    Loss loss;
    for (std::size_t k = 0; k < cut.path.strokes().size(); ++k) {
      const Stroke& stroke = cut.path.strokes()[k];
      for (const std::size_t number : strokes_.owners_near(stroke, tolerance)) {
        const OwnedStroke& other = owner_of_stroke_[number];
        if (ranks_[other.cut] >= ranks_[i] || !are_cut_alike(i, other.cut)) continue;
        auto shared = shared_stretch(stroke, other.stroke, tolerance);
        if (!shared) continue;
        shared->from_mm += cut.path.way_to(k);
        shared->to_mm += cut.path.way_to(k);
        loss.stretches.push_back(*shared);
        loss.owners.push_back(other.cut);
      }
    }
    join_stretches(loss.stretches);
    // Cuts along a shared edge have the whole edge in common, so a stretch of it may be of any
    // length.
    const double shortest_mm = cut.is_on_edge ? 0.0 : kShortestKerfs * 2.0 * cut.half_kerf_mm;
    std::erase_if(loss.stretches, [shortest_mm](const SharedStretch& stretch) {
      return stretch.to_mm - stretch.from_mm < shortest_mm;
    });
    std::ranges::sort(loss.owners);
    loss.owners.erase(std::unique(loss.owners.begin(), loss.owners.end()), loss.owners.end());
    return loss;
  }

  /// Returns the rests of a cut, except the rests that the beam covers completely from their ends.
  [[nodiscard]] std::vector<std::vector<Stroke>> needed_rests(std::size_t i,
                                                              const Loss& loss) const {
    const UnbegunCut& cut = unbegun_[i];
    std::vector<std::vector<Stroke>> rests = rests_between(cut.path, loss.stretches);
    std::erase_if(rests, [&cut](const std::vector<Stroke>& rest) {
      return is_reached_from_ends(rest, cut.half_kerf_mm);
    });
    return rests;
  }

  /// Moves a cut forward in the order if earlier cuts would leave nothing of it, as far as the
  /// precedence permits.
  void leave_each_a_line() {
    constexpr int kMaxRounds = 8;
    bool is_changed = true;
    for (int round = 0; is_changed && round < kMaxRounds; ++round) {
      is_changed = false;
      for (std::size_t i = 0; i < unbegun_.size(); ++i) {
        if (!may_share(i)) continue;
        const Loss loss = loss_of(i);
        if (loss.stretches.empty() || !needed_rests(i, loss).empty()) continue;
        is_changed = comes_before_an_owner(i, loss) || is_changed;
      }
    }
  }

  /// Moves a cut forward, before one of the owners of its lines. If several owners permit this,
  /// chooses the owner with the greatest length that it does not itself leave to earlier cuts.
  /// Returns false if no owner permits it.
  bool comes_before_an_owner(std::size_t i, const Loss& loss) {
    std::vector<bool> is_before(unbegun_.size());
    std::vector<std::size_t> open{i};
    while (!open.empty()) {
      const std::size_t here = open.back();
      open.pop_back();
      if (is_before[here]) continue;
      is_before[here] = true;
      open.insert(open.end(), plan_.cuts[here].after.begin(), plan_.cuts[here].after.end());
    }
    std::optional<std::size_t> owner;
    double max_mm = 0.0;
    for (const std::size_t other : loss.owners) {
      const double left_mm = length_left(other);
      if (is_before[other] || left_mm <= max_mm) continue;
      max_mm = left_mm;
      owner = other;
    }
    if (!owner) return false;
    std::vector<std::size_t> order(unbegun_.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[ranks_[k]] = k;
    const auto from = order.begin() + static_cast<std::ptrdiff_t>(ranks_[*owner]);
    const auto to = order.begin() + static_cast<std::ptrdiff_t>(ranks_[i]) + 1;
    std::stable_partition(from, to, [&](std::size_t cut) { return is_before[cut]; });
    for (std::size_t k = 0; k < order.size(); ++k) ranks_[order[k]] = k;
    return true;
  }

  [[nodiscard]] double length_left(std::size_t i) const {
    double left_mm = unbegun_[i].path.length();
    for (const SharedStretch& stretch : loss_of(i).stretches) {
      left_mm -= stretch.to_mm - stretch.from_mm;
    }
    return left_mm;
  }

  void take(std::size_t i, Loss loss) {
    if (loss.stretches.empty()) return;
    std::vector<std::vector<Stroke>> rests = needed_rests(i, loss);
    if (rests.empty()) {
      loss.stretches.erase(
          std::ranges::min_element(loss.stretches, {}, [](const SharedStretch& stretch) {
            return stretch.to_mm - stretch.from_mm;
          }));
      if (loss.stretches.empty()) return;
      rests = needed_rests(i, loss);
    }
    for (const SharedStretch& stretch : loss.stretches) {
      ++plan_.shared.lines;
      plan_.shared.length_mm += stretch.to_mm - stretch.from_mm;
      plan_.shared.max_off_mm = std::max(plan_.shared.max_off_mm, stretch.off_mm);
    }
    rests_[i] = std::move(rests);
    owners_[i] = std::move(loss.owners);
  }

  /// Replaces each cut that has rests by these rests, and renumbers all cuts.
  void split() {
    std::vector<std::size_t> first(unbegun_.size() + 1);
    for (std::size_t i = 0; i < unbegun_.size(); ++i) {
      first[i + 1] = first[i] + std::max<std::size_t>(rests_[i].size(), 1);
    }
    std::vector<Cut> cuts;
    std::vector<UnbegunCut> unbegun;
    for (std::size_t i = 0; i < unbegun_.size(); ++i) {
      std::vector<std::size_t> after;
      const auto add_after = [&](std::size_t before) {
        for (std::size_t k = first[before]; k < first[before + 1]; ++k) after.push_back(k);
      };
      for (const std::size_t before : plan_.cuts[i].after) add_after(before);
      for (const std::size_t owner : owners_[i]) add_after(owner);
      plan_.cuts[i].after = after;
      unbegun_[i].after = after;
      if (rests_[i].empty()) {
        cuts.push_back(std::move(plan_.cuts[i]));
        unbegun.push_back(std::move(unbegun_[i]));
        continue;
      }
      add_rests(i, cuts, unbegun);
    }
    plan_.cuts = std::move(cuts);
    unbegun_ = std::move(unbegun);
  }

  void add_rests(std::size_t i, std::vector<Cut>& cuts, std::vector<UnbegunCut>& unbegun) const {
    Cut cut = plan_.cuts[i];
    cut.loop = std::make_shared<const std::vector<Stroke>>(unbegun_[i].path.strokes());
    const auto longest = std::ranges::max_element(
        rests_[i], {}, [](const std::vector<Stroke>& rest) { return length_of(rest); });
    for (auto rest = rests_[i].begin(); rest != rests_[i].end(); ++rest) {
      UnbegunCut open = unbegun_[i];
      open.path = MeasuredRow{*rest};
      open.is_open = true;
      LayerSettings& settings = open.settings;
      settings.lead_in = settings.lead_out = {};
      settings.overcut_mm = 0.0;
      settings.start = StartAt::kUsual;
      if (rest != longest) settings.tabs = 0;
      // The cut requires no pierce, because it begins in the kerf of the other part. If the parts
      // have tabs, the pierce stays, because a tab of the other part may be at this point.
      if (unbegun_[i].settings.tabs == 0) settings.pierce_s = 0.0;
      unbegun.push_back(std::move(open));
      cuts.push_back(cut);
    }
  }

  CutPlan& plan_;
  std::vector<UnbegunCut>& unbegun_;
  std::vector<std::size_t> ranks_;
  Clearance strokes_;
  std::vector<OwnedStroke> owner_of_stroke_;
  /// For each cut, the rests that replace it. A cut without rests stays as it is.
  std::vector<std::vector<std::vector<Stroke>>> rests_;
  /// For each cut, the numbers of the earlier cuts that make lines of this cut.
  std::vector<std::vector<std::size_t>> owners_;
};

}  // namespace

void share_lines(CutPlan& plan,
                 std::vector<UnbegunCut>& unbegun,
                 const std::vector<std::size_t>& ranks) {
  CNC_ASSERT(ranks.size() == unbegun.size() && unbegun.size() == plan.cuts.size());
  plan.shared.is_asked = true;
  Sharing{plan, unbegun, ranks}.run();
}

std::vector<SharedLoop> loops_closed_by(const std::vector<Cut>& cuts) {
  std::map<SharedLoop, std::size_t> last;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    if (cuts[i].loop) last[cuts[i].loop] = i;
  }
  std::vector<SharedLoop> closed(cuts.size());
  for (const auto& [loop, cut] : last) closed[cut] = loop;
  return closed;
}

}  // namespace sim::cut
