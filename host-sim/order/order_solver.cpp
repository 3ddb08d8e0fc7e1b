#include "host-sim/order/order_solver.hpp"

#include <fmt/format.h>

#include <string>

#include "host-sim/order/order_run.hpp"

namespace sim::order {
namespace {

using cnc::order::PrecedenceFault;

[[noreturn]] void refuse(const OrderProblem& problem,
                         const cnc::order::PrecedenceError& error,
                         const cnc::order::PrecedenceSpace& space) {
  CNC_ASSERT(error.fault == PrecedenceFault::kCycle);
  constexpr std::size_t kMaxNamed = 12;
  std::string ring;
  for (std::size_t i = 0; i < std::min(error.count, kMaxNamed); ++i) {
    ring += fmt::format("{} before ", problem.group_numbers[space.ready[i]]);
  }
  if (error.count > kMaxNamed) ring += fmt::format("… ({} groups) before ", error.count);
  ring += fmt::format("{}", problem.group_numbers[space.ready[0]]);
  throw NoOrder{fmt::format("the precedence is a cycle: {}; leave one of these pairs out", ring)};
}

template <typename Cost>
OrderResult run(const OrderProblem& input,
                const cnc::order::Problem& problem,
                const Cost& cost,
                const OrderOptions& options,
                const OrderProgress& progress) {
  return OrderRun<Cost>{input, problem, cost, options, progress}.solve();
}

}  // namespace

std::string_view name_of(OrderMethod method) {
  switch (method) {
    case OrderMethod::kOurs:
      return "ours";
    case OrderMethod::kAnneal:
      return "anneal";
    case OrderMethod::kNearest:
      return "nearest";
    case OrderMethod::kFile:
      return "file";
    case OrderMethod::kExact:
      return "exact";
  }
  return "";
}

OrderResult solve_order(const OrderProblem& input,
                        const OrderOptions& options,
                        const OrderProgress& progress) {
  const OwnedSpace<cnc::order::PrecedenceSpace> space{
      cnc::order::PrecedenceSizes{input.sets(), input.pairs.size()}};
  const auto precedence = cnc::order::sort_precedence(input.sets(), input.pairs, *space);
  if (!precedence.ok()) refuse(input, precedence.error(), *space);
  const cnc::order::Problem problem{input.first_candidate,
                                    input.reversed,
                                    precedence.value(),
                                    input.is_symmetric,
                                    input.is_home_closed};
  const cnc::order::CandidatePlaces places{input.entry,
                                           input.exit.empty() ? input.entry : input.exit};
  switch (input.metric) {
    case Metric::kMatrix:
      return run(input,
                 problem,
                 cnc::order::MatrixCost{input.matrix, problem.candidates()},
                 options,
                 progress);
    case Metric::kPlane:
      return run(input, problem, cnc::order::PlaneCost{places}, options, progress);
    case Metric::kRoundedPlane:
      return run(input, problem, cnc::order::RoundedPlaneCost{places}, options, progress);
    case Metric::kCeiledPlane:
      return run(input, problem, cnc::order::CeiledPlaneCost{places}, options, progress);
  }
  return {};
}

}  // namespace sim::order
