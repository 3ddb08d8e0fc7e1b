#pragma once

#include <fmt/format.h>

#include <algorithm>

#include "host-sim/order/file_order.hpp"
#include "host-sim/order/order_solver.hpp"
#include "host-sim/order/owned_space.hpp"
#include "host-sim/order/run_budget.hpp"
#include "planner/order/costs.hpp"
#include "planner/order/exact.hpp"
#include "planner/order/nearest_order.hpp"
#include "planner/order/search.hpp"

namespace sim::order {

/// Solves one problem with one kind of cost, by the method of the options.
template <cnc::order::LegCost Cost>
class OrderRun {
 public:
  using Index = cnc::order::Index;

  OrderRun(const OrderProblem& input,
           const cnc::order::Problem& problem,
           const Cost& cost,
           const OrderOptions& options,
           const OrderProgress& progress)
      : input_{&input},
        problem_{&problem},
        cost_{&cost},
        options_{&options},
        progress_{&progress},
        budget_{options.seconds.value_or(kUsualSeconds), options.steps},
        set_of_(problem.candidates()),
        start_{cnc::order::NearestOrderSizes{problem.sets()}} {
    for (Index set = 0; set < problem.sets(); ++set) {
      std::fill(set_of_.begin() + problem.first_candidate[set],
                set_of_.begin() + problem.first_candidate[set + 1],
                set);
    }
    all_places_ = input.entry;
    all_places_.insert(all_places_.end(), input.exit.begin(), input.exit.end());
  }

  OrderResult solve() {
    switch (options_->method) {
      case OrderMethod::kOurs:
        search_and_prove();
        break;
      case OrderMethod::kAnneal:
        anneal();
        break;
      case OrderMethod::kNearest:
        find_nearest();
        offer(start_->order, start_->chosen);
        break;
      case OrderMethod::kFile:
        offer(file_order(*problem_),
              std::vector<Index>(problem_->first_candidate.begin(),
                                 problem_->first_candidate.end() - 1));
        break;
      case OrderMethod::kExact:
        prove_only();
        break;
    }
    result_.steps = budget_.steps();
    return std::move(result_);
  }

 private:
  static constexpr double kUsualSeconds = 1.0;
  static constexpr double kEndless = 1.0e12;  ///< Time limit that stands for unlimited time, s.
  // Shares of the run at which the first search ends and at which the search for a proof ends. A
  // second search uses the rest of the run.
  static constexpr double kFirstShare = 0.3;
  static constexpr double kProofShare = 0.7;
  static constexpr std::uint64_t kChunk = 16;
  /// Number of neighbours of each set that the search considers. With more neighbours, the search
  /// takes more time than the better order is worth.
  static constexpr Index kWidth = 8;
  static constexpr std::uint64_t kStepsBeforeProof = 600;
  /// Greatest memory of a proof that is part of a search, bytes.
  static constexpr std::size_t kProofBytes = 300'000'000;

  void find_nearest();
  void find_neighbours();
  void search_until(double share, std::uint64_t seed);
  void search_and_prove();
  /// Searches for a proof until `share` of the run is done.
  /// @return false if the proof does not fit into `bytes` of memory
  bool prove_until(double share, std::size_t bytes);
  void prove_only();
  void anneal();

  [[nodiscard]] bool may_be_proven() const {
    return problem_->sets() > 1 && problem_->sets() - 1 <= cnc::order::kMaxMaskedSets;
  }
  /// Keeps a tour as the result if it is the cheapest one so far.
  void offer(std::span<const Index> order, std::span<const Index> chosen_by_set);
  void report() const {
    if (*progress_) (*progress_)(budget_.share(), result_.cost);
  }
  [[nodiscard]] cnc::order::CandidatePlaces places() const {
    return {input_->entry, input_->exit.empty() ? input_->entry : input_->exit};
  }

  const OrderProblem* input_;
  const cnc::order::Problem* problem_;
  const Cost* cost_;
  const OrderOptions* options_;
  const OrderProgress* progress_;
  RunBudget budget_;
  std::vector<Index> set_of_;
  std::vector<cnc::order::Place> all_places_;
  OwnedSpace<cnc::order::NearestOrderSpace> start_;
  std::vector<Index> neighbour_lists_;
  std::vector<double> neighbour_costs_;
  cnc::order::Neighbours neighbours_;
  OrderResult result_;
  std::vector<Index> best_chosen_;  ///< Candidate of each set in the cheapest tour so far.
};

template <cnc::order::LegCost Cost>
void OrderRun<Cost>::offer(std::span<const Index> order, std::span<const Index> chosen_by_set) {
  double cost = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Index next = order[i + 1 == order.size() ? 0 : i + 1];
    if (order.size() > 1) cost += (*cost_)(chosen_by_set[order[i]], chosen_by_set[next]);
  }
  if (!result_.order.empty() && cost >= result_.cost) return;
  result_.cost = cost;
  result_.order.assign(order.begin(), order.end());
  best_chosen_.assign(chosen_by_set.begin(), chosen_by_set.end());
  result_.candidates.clear();
  for (const Index set : order) result_.candidates.push_back(chosen_by_set[set]);
}

template <cnc::order::LegCost Cost>
void OrderRun<Cost>::find_nearest() {
  if (input_->metric == Metric::kMatrix) {
    std::vector<std::uint8_t> is_open(problem_->candidates());
    cnc::order::nearest_order(
        *problem_, cnc::order::NearestByCost{*problem_, *cost_, set_of_, is_open}, *start_);
    return;
  }
  const OwnedSpace<cnc::order::PlaceTreeSpace> space{
      cnc::order::PlaceTreeSizes{input_->entry.size()}};
  cnc::order::PlaceTree tree{input_->entry, *space, false};
  cnc::order::nearest_order(
      *problem_, cnc::order::NearestPlace{*problem_, places(), set_of_, tree}, *start_);
}

template <cnc::order::LegCost Cost>
void OrderRun<Cost>::find_neighbours() {
  neighbour_lists_.resize(std::size_t{problem_->sets()} * kWidth);
  if (input_->metric == Metric::kMatrix) {
    neighbours_ = cnc::order::find_neighbours(*problem_, *cost_, set_of_, kWidth, neighbour_lists_);
  } else {
    const OwnedSpace<cnc::order::PlaceTreeSpace> space{
        cnc::order::PlaceTreeSizes{all_places_.size()}};
    const cnc::order::PlaceTree tree{all_places_, *space, true};
    neighbours_ =
        cnc::order::find_neighbours(*problem_, places(), tree, set_of_, kWidth, neighbour_lists_);
  }
  if (problem_->candidates() != problem_->sets() || !problem_->is_symmetric) return;
  neighbour_costs_.resize(neighbour_lists_.size());
  for (std::size_t i = 0; i < neighbour_lists_.size(); ++i) {
    if (neighbour_lists_[i] == cnc::order::kNone) continue;
    neighbour_costs_[i] = (*cost_)(static_cast<Index>(i / kWidth), neighbour_lists_[i]);
  }
  neighbours_ = {neighbour_lists_, kWidth, neighbour_costs_};
}

template <cnc::order::LegCost Cost>
void OrderRun<Cost>::search_until(double share, std::uint64_t seed) {
  const OwnedSpace<cnc::order::SearchSpace> space{
      cnc::order::SearchSizes{problem_->sets(), problem_->candidates()}};
  cnc::order::Search<Cost> search{
      *problem_, *cost_, neighbours_, *space, {result_.order, best_chosen_}, seed};
  const double begin = budget_.share();
  double done = begin;
  while (done < share) {
    const std::uint64_t steps = budget_.next_steps(kChunk);
    search.run(steps, 1.0 - (done - begin) / (share - begin));
    budget_.count(steps);
    done = budget_.share();
    if (*progress_) (*progress_)(done, search.best_cost());
  }
  offer(search.best_order(), search.best_chosen());
}

template <cnc::order::LegCost Cost>
void OrderRun<Cost>::search_and_prove() {
  find_nearest();
  offer(start_->order, start_->chosen);
  if (!options_->start_order.empty()) offer(options_->start_order, options_->start_chosen);
  if (problem_->sets() < 3) return;
  find_neighbours();
  if (options_->may_prove && may_be_proven()) {
    search_until(kFirstShare, options_->seed);
    static_cast<void>(prove_until(kProofShare, std::min(kProofBytes, options_->memory_bytes)));
  }
  if (!result_.is_proven) search_until(1.0, options_->seed + 1);
}

template <cnc::order::LegCost Cost>
bool OrderRun<Cost>::prove_until(double share, std::size_t bytes) {
  using State = cnc::order::ExactSpace::State;
  const std::size_t candidates_of_set = problem_->candidates() / problem_->sets() + 1;
  const std::size_t states = bytes / (sizeof(State) + candidates_of_set * sizeof(double));
  const OwnedSpace<cnc::order::ExactSpace> space{cnc::order::ExactSizes{
      problem_->sets(), problem_->candidates(), states, states * candidates_of_set}};
  cnc::order::Exact exact{*problem_, *cost_, set_of_, *space, result_.cost};
  while (exact.state() == cnc::order::ExactState::kRunning && budget_.share() < share) {
    const std::uint64_t steps = budget_.next_steps(1);
    exact.run(steps);
    budget_.count(steps);
    report();
  }
  if (exact.has_tour()) offer(exact.order(), exact.chosen());
  result_.is_proven = exact.state() == cnc::order::ExactState::kProven;
  return exact.state() != cnc::order::ExactState::kDoesNotFit;
}

template <cnc::order::LegCost Cost>
void OrderRun<Cost>::prove_only() {
  if (!may_be_proven() && problem_->sets() > 1) {
    throw NoOrder{fmt::format("{} groups are too many for a proof, at most {}; use --order ours",
                              problem_->sets(),
                              cnc::order::kMaxMaskedSets + 1)};
  }
  find_nearest();
  offer(start_->order, start_->chosen);
  if (problem_->sets() < 3) {
    // One or two sets have only one order. For two sets, the proof below chooses the candidates.
    if (problem_->sets() == 1) result_.is_proven = true;
  } else {
    find_neighbours();
    budget_ = RunBudget{0.0, kStepsBeforeProof};
    search_until(1.0, options_->seed);
  }
  budget_ = RunBudget{options_->seconds.value_or(kEndless), options_->steps};
  if (result_.is_proven) return;
  if (!prove_until(1.0, options_->memory_bytes)) {
    throw NoOrder{
        fmt::format("the proof does not fit into {} MB; raise --memory, or use --order "
                    "ours, which finds {:g} without a proof",
                    options_->memory_bytes / 1'000'000,
                    result_.cost)};
  }
}

template <cnc::order::LegCost Cost>
void OrderRun<Cost>::anneal() {
  const OwnedSpace<cnc::order::AnnealingSpace> space{cnc::order::AnnealingSizes{problem_->sets()}};
  cnc::order::Annealing annealing{*problem_, *cost_, *space, unit_of(*input_), options_->seed};
  while (annealing.run(kChunk)) {
    budget_.count(kChunk);
    if (!*progress_) continue;
    constexpr double kUsualTemperatures = 70.0;
    (*progress_)(static_cast<double>(annealing.course().size()) / kUsualTemperatures,
                 annealing.cost());
  }
  offer(annealing.order(), annealing.chosen());
  result_.course.assign(annealing.course().begin(), annealing.course().end());
}

}  // namespace sim::order
