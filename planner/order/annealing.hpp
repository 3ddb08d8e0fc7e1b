#pragma once

#include <array>
#include <utility>

#include "planner/order/decay.hpp"
#include "planner/order/feasibility.hpp"
#include "planner/order/legs.hpp"
#include "planner/order/random.hpp"

namespace cnc::order {

struct AnnealingSizes {
  std::size_t sets;
};

/// Storage of an Annealing.
struct AnnealingSpace {
  TourSpace tour;
  std::span<Index> start;
  std::span<Index> start_chosen;
  std::span<Index> waits_for;
  std::span<Index> outer;
  std::span<Index> inner;

  template <typename Layout>
  void lay_out(Layout& layout, const AnnealingSizes& sizes) {
    tour.lay_out(layout, {sizes.sets, 0});
    layout(start, sizes.sets);
    layout(start_chosen, sizes.sets);
    layout(waits_for, sizes.sets);
    layout(outer, sizes.sets);
    layout(inner, sizes.sets);
  }
};

/// Results of one temperature, with the cost of the path at its end: a point of Fig. 7 of paper 3.
struct AnnealingPoint {
  double temperature;
  double cost;
  std::uint64_t tries;
  std::uint64_t accepted;
};

/// Simulated annealing as Han and Na describe it for torch paths (paper 3). Each try shifts a
/// stretch of the path or, if the shift is not accepted, reverses a stretch. Then it tries another
/// pierce point on an outer contour or, if this point is not accepted, on an inner contour.
///
/// As printed: the search starts from a random path with θ = 1.5, then θ ← 0.9 θ. Each θ has 100 N
/// tries. The run ends after 300 temperatures or below θ = 0.001. This code has the following
/// properties where the paper is silent or wrong:
/// * The sign of ΔC: better paths are accepted, and worse paths with probability e^(−ΔC/θ). As
///   printed, the program would search for the longest path.
/// * nLIMIT, the number of accepted changes that ends a temperature, is 10 N, as in `anneal` of
///   Numerical Recipes, whose scheme the paper uses. N is the number of contours, including home.
/// * Costs are divided by `unit`, the side of the square that contains all points, because θ = 1.5
///   has a meaning only on the unit square.
/// * The path is a tour with a fixed home. Paths that violate precedence are rejected; the paper
///   does not mention precedence.
/// * A contour that must come before another contour is inner; all other contours are outer.
template <LegCost Cost>
class Annealing {
 public:
  static constexpr double kFirstTemperature = 1.5;
  static constexpr double kCooling = 0.9;
  static constexpr double kLastTemperature = 0.001;
  static constexpr std::size_t kMaxTemperatures = 300;
  static constexpr std::uint64_t kTriesPerContour = 100;
  static constexpr std::uint64_t kAcceptedPerContour = 10;

  /// @param unit length of the side of the unit square, in units of cost
  Annealing(const Problem& problem,
            const Cost& cost,
            const AnnealingSpace& space,
            double unit,
            std::uint64_t seed)
      : problem_{&problem},
        space_{space},
        tour_{problem, space.tour},
        legs_{problem, cost, tour_},
        may_{problem.precedence, tour_},
        random_{seed},
        unit_{unit} {
    sort_contours();
    start_at_random();
    cost_ = legs_.tour_cost();
  }
  Annealing(const Annealing&) = delete;
  Annealing& operator=(const Annealing&) = delete;
  ~Annealing() = default;

  /// Continues for a number of tries. @return false if the annealing has ended
  bool run(std::uint64_t tries) {
    for (std::uint64_t i = 0; i < tries && !is_finished(); ++i) try_once();
    return !is_finished();
  }

  [[nodiscard]] bool is_finished() const {
    return count_ == kMaxTemperatures || temperature_ <= kLastTemperature;
  }
  [[nodiscard]] double cost() const { return legs_.tour_cost(); }
  [[nodiscard]] std::span<const Index> order() const { return tour_.order(); }
  [[nodiscard]] std::span<const Index> chosen() const { return tour_.choices(); }
  /// Returns the results of all temperatures that have ended.
  [[nodiscard]] std::span<const AnnealingPoint> course() const {
    return std::span{course_}.first(count_);
  }

 private:
  void sort_contours();
  void start_at_random();
  void try_once();
  void end_temperature();
  bool shift();
  bool reverse();
  bool pierce_anew(std::span<const Index> contours);
  double interior_gain(Index start, Index length) const;

  [[nodiscard]] bool accepts(double gain) {
    if (gain > 0.0) return true;
    return wide_decay(-gain / unit_ / temperature_) > random_.unit();
  }
  [[nodiscard]] Index candidate_at(Index position) const {
    return tour_.chosen(tour_.at(position));
  }

  const Problem* problem_;
  AnnealingSpace space_;
  Tour tour_;
  Legs<Cost> legs_;
  Feasibility may_;
  Random random_;
  double unit_;
  double temperature_ = kFirstTemperature;
  double cost_ = 0.0;
  std::uint64_t tries_ = 0;
  std::uint64_t accepted_ = 0;
  std::size_t count_ = 0;
  std::size_t outer_count_ = 0;
  std::size_t inner_count_ = 0;
  std::array<AnnealingPoint, kMaxTemperatures> course_{};
};

template <LegCost Cost>
void Annealing<Cost>::sort_contours() {
  for (Index set = 1; set < problem_->sets(); ++set) {
    if (problem_->precedence.after(set).empty()) {
      space_.outer[outer_count_++] = set;
    } else {
      space_.inner[inner_count_++] = set;
    }
  }
}

/// Makes a random start: repeatedly takes, at random, one of the contours that may come next and
/// one of its pierce points.
template <LegCost Cost>
void Annealing<Cost>::start_at_random() {
  const Index sets = problem_->sets();
  // `ready` contains first the order so far, then all contours that may come next.
  const std::span<Index> ready = space_.start;
  const auto& precedence = problem_->precedence;
  Index end = 1;
  ready[0] = 0;
  for (Index set = 1; set < sets; ++set) {
    Index count = 0;
    for (const Index before : precedence.before(set)) count += before != 0 ? 1 : 0;
    space_.waits_for[set] = count;
    if (count == 0) ready[end++] = set;
  }
  const std::span<Index> chosen = space_.start_chosen;
  for (Index i = 0; i < sets; ++i) {
    if (i > 0) std::swap(ready[i], ready[i + random_.below(end - i)]);
    const Index set = ready[i];
    chosen[set] = problem_->first_candidate[set] + random_.below(problem_->candidates_of(set));
    if (i == 0) continue;
    for (const Index after : precedence.after(set)) {
      if (--space_.waits_for[after] == 0) ready[end++] = after;
    }
  }
  tour_.assign(ready, chosen);
}

/// Makes one pass of the inner loop of Fig. 4 of paper 3.
template <LegCost Cost>
void Annealing<Cost>::try_once() {
  if (tour_.size() > 2 && (shift() || reverse())) ++accepted_;
  if (pierce_anew(space_.outer.first(outer_count_)) ||
      pierce_anew(space_.inner.first(inner_count_))) {
    ++accepted_;
  }
  tour_.forget_changes();
  ++tries_;
  const std::uint64_t contours = tour_.size();
  if (tries_ >= kTriesPerContour * contours || accepted_ >= kAcceptedPerContour * contours) {
    end_temperature();
  }
}

template <LegCost Cost>
void Annealing<Cost>::end_temperature() {
  course_[count_++] = {temperature_, legs_.tour_cost(), tries_, accepted_};
  temperature_ *= kCooling;
  tries_ = 0;
  accepted_ = 0;
}

/// Moves a random stretch to another position, by an exchange of two neighbouring stretches.
template <LegCost Cost>
bool Annealing<Cost>::shift() {
  const Index sets = tour_.size();
  std::array<Index, 3> cuts{random_.below(sets), random_.below(sets), random_.below(sets)};
  if (cuts[0] > cuts[1]) std::swap(cuts[0], cuts[1]);
  if (cuts[1] > cuts[2]) std::swap(cuts[1], cuts[2]);
  if (cuts[0] > cuts[1]) std::swap(cuts[0], cuts[1]);
  const auto [p, q, r] = cuts;
  if (p == q || q == r) return false;
  const Index behind_p = candidate_at(p + 1);
  const Index behind_q = candidate_at(q + 1);
  const Index behind_r = candidate_at(tour_.position_after(r));
  const double gain =
      legs_.after(p) + legs_.after(q) + legs_.after(r) - legs_.between(candidate_at(p), behind_q) -
      legs_.between(candidate_at(r), behind_p) - legs_.between(candidate_at(q), behind_r);
  if (!accepts(gain) || !may_.may_swap(p + 1, q + 1, r + 1)) return false;
  tour_.swap(p + 1, q - p, r - q);
  return true;
}

/// Reverses a random stretch.
template <LegCost Cost>
bool Annealing<Cost>::reverse() {
  const Index sets = tour_.size();
  Index first = 1 + random_.below(sets - 1);
  Index last = 1 + random_.below(sets - 1);
  if (first > last) std::swap(first, last);
  const Index new_first = problem_->reversal_of(candidate_at(last));
  const Index new_last = problem_->reversal_of(candidate_at(first));
  const double gain = legs_.after(first - 1) + legs_.after(last) -
                      legs_.between(candidate_at(first - 1), new_first) -
                      legs_.between(new_last, candidate_at(tour_.position_after(last))) +
                      interior_gain(first, last - first + 1);
  if (first == last || !accepts(gain) || !may_.may_reverse(first, last + 1)) return false;
  tour_.reverse(first, last - first + 1);
  return true;
}

/// Returns the decrease of the cost of the legs within a stretch when the stretch is reversed.
template <LegCost Cost>
double Annealing<Cost>::interior_gain(Index start, Index length) const {
  if (problem_->is_symmetric) return 0.0;
  double gain = 0.0;
  for (Index i = start; i + 1 < start + length; ++i) {
    gain += legs_.after(i) - legs_.between(problem_->reversal_of(candidate_at(i + 1)),
                                           problem_->reversal_of(candidate_at(i)));
  }
  return gain;
}

template <LegCost Cost>
bool Annealing<Cost>::pierce_anew(std::span<const Index> contours) {
  if (contours.empty()) return false;
  const Index set = contours[random_.below(static_cast<Index>(contours.size()))];
  const Index count = problem_->candidates_of(set);
  if (count < 2) return false;
  const Index candidate = problem_->first_candidate[set] + random_.below(count);
  if (candidate == tour_.chosen(set)) return false;
  const Index before = tour_.chosen(tour_.before(set));
  const Index after = tour_.chosen(tour_.after(set));
  const double gain = legs_.between(before, tour_.chosen(set)) +
                      legs_.between(tour_.chosen(set), after) - legs_.between(before, candidate) -
                      legs_.between(candidate, after);
  if (!accepts(gain)) return false;
  tour_.choose(set, candidate);
  return true;
}

}  // namespace cnc::order
