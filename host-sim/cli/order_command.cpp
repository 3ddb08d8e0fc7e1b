#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/order/order_file.hpp"
#include "host-sim/order/order_solver.hpp"
#include "host-sim/report/progress_bar.hpp"
#include "host-sim/report/report_json.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/input_file.hpp"
#include "planner/order/problem.hpp"

namespace sim {
namespace {

using order::OrderMethod;
using order::OrderProblem;
using order::OrderResult;

constexpr const char* kOrderFooter =
    "Solves published problems by the solver that orders cuts. FILE is of TSPLIB (TYPE TSP or "
    "ATSP;\n"
    "EDGE_WEIGHT_TYPE EUC_2D, CEIL_2D or EXPLICIT as FULL_MATRIX), or of the library of cutting\n"
    "problems with precedence (TYPE PCGLNS or GTSP): a matrix with -1 for a forbidden leg, groups "
    "of\n"
    "vertices of which exactly one is visited, and lines `a b -1`: group a comes before group b. "
    "The\n"
    "tour is closed and begins at the start group, or at the first node.\n"
    "\n"
    "  ours     local search with random trials; proves the optimum if --seconds suffice\n"
    "  anneal   simulated annealing as in Han and Na's paper on torch paths; ignores --seconds\n"
    "  nearest  always the nearest vertex of the groups that may come next\n"
    "  file     the order of the file, with the first vertex of each group\n"
    "  exact    the proven optimum, for up to 65 groups if --memory suffices\n"
    "\n"
    "Examples:\n"
    "  kerfline order r1000.tsp --seconds 5\n"
    "  kerfline order e1x_6.pcglns --order exact --json\n"
    "  kerfline order r1000.tsp --steps 100000 --seed 7\n"
    "\n"
    "Exit status: 0 fine, 1 the problem has faults or no tour, 2 the call is wrong.";

struct OrderCommandOptions {
  std::string file;
  order::OrderOptions solve;
  std::uint64_t memory_mb = 1000;
  bool json = false;
};

nlohmann::ordered_json cost_json(double cost) {
  const auto whole = static_cast<std::int64_t>(cost);
  if (static_cast<double>(whole) == cost) return whole;
  return cost;
}

nlohmann::ordered_json to_json(const OrderCommandOptions& options,
                               const OrderProblem& problem,
                               const OrderResult& result,
                               double seconds) {
  nlohmann::ordered_json all;
  all["file"] = name_of_input(options.file);
  all["name"] = problem.name;
  all["order"] = name_of(options.solve.method);
  all["groups_in_file"] = problem.sets();
  all["vertices_in_file"] = problem.candidates();
  all["precedence_pairs"] = problem.pairs.size();
  all["cost"] = cost_json(result.cost);
  all["proven"] = result.is_proven;
  all["seed"] = options.solve.seed;
  all["steps"] = result.steps;
  all["time_s"] = seconds;
  all["vertices"] = nlohmann::ordered_json::array();
  for (const auto candidate : result.candidates) {
    all["vertices"].push_back(problem.vertex_numbers[candidate]);
  }
  all["groups"] = nlohmann::ordered_json::array();
  for (const auto set : result.order) all["groups"].push_back(problem.group_numbers[set]);
  if (options.solve.method != OrderMethod::kAnneal) return all;
  all["course"] = nlohmann::ordered_json::array();
  for (const auto& point : result.course) {
    all["course"].push_back({{"temperature", point.temperature},
                             {"cost", cost_json(point.cost)},
                             {"tries", point.tries},
                             {"accepted", point.accepted}});
  }
  return all;
}

void print(const OrderCommandOptions& options,
           const OrderProblem& problem,
           const OrderResult& result,
           double seconds) {
  terminal::print("{}: {} groups, {} vertices; {}, seed {}, {} steps, {:.2f} s\n",
                  name_of_input(options.file),
                  problem.sets(),
                  problem.candidates(),
                  name_of(options.solve.method),
                  options.solve.seed,
                  result.steps,
                  seconds);
  terminal::print("cost {}{}\n",
                  cost_json(result.cost).dump(),
                  result.is_proven                              ? ", proven to be the least"
                  : options.solve.method == OrderMethod::kExact ? ", not proven in that time"
                                                                : "");
  std::string vertices;
  for (const auto candidate : result.candidates) {
    vertices += fmt::format("{}{}", vertices.empty() ? "" : " ", problem.vertex_numbers[candidate]);
  }
  terminal::print("{}\n", vertices);
}

ExitStatus solve(const OrderCommandOptions& options) {
  const OrderProblem problem =
      order::read_order_problem(read_text(options.file), name_of_input(options.file));
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  ProgressBar bar{stderr, is_terminal(stderr), start};
  order::OrderProgress progress;
  if (is_terminal(stderr)) {
    progress = [&bar](double share, double cost) {
      bar.update(share, fmt::format("cost {:.6g}", cost), Clock::now());
    };
  }
  const OrderResult result = order::solve_order(problem, options.solve, progress);
  bar.clear();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (!cnc::order::is_allowed(result.cost)) {
    terminal::print(stderr,
                    "{}: no tour without a forbidden leg was found; {}\n",
                    name_of_input(options.file),
                    result.is_proven ? "there is none" : "give more --seconds, or --order exact");
    return ExitStatus::kFaults;
  }
  if (options.json) {
    terminal::write_data(dumped(to_json(options, problem, result, seconds), 1) + "\n");
  } else {
    print(options, problem, result, seconds);
  }
  return ExitStatus::kFine;
}

ExitStatus solve_or_tell(OrderCommandOptions& options) {
  options.solve.memory_bytes = options.memory_mb * 1'000'000;
  try {
    return solve(options);
  } catch (const order::OrderFileError& error) {
    terminal::print(stderr, "{}\n", error.what());
  } catch (const order::NoOrder& error) {
    terminal::print(stderr, "{}: {}\n", name_of_input(options.file), error.what());
  }
  return ExitStatus::kFaults;
}

}  // namespace

void add_order_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command = app.add_subcommand(
      "order", "Find the cheapest order of a published problem, by the solver that orders cuts.");
  command->footer(kOrderFooter);
  const auto options = std::make_shared<OrderCommandOptions>();
  mark_file(
      command->add_option("FILE", options->file, "Problem as TSPLIB or PCGLNS; - is standard input")
          ->required(),
      FileRole::kInput);
  std::map<std::string, OrderMethod> methods;
  for (const auto method : {OrderMethod::kOurs,
                            OrderMethod::kAnneal,
                            OrderMethod::kNearest,
                            OrderMethod::kFile,
                            OrderMethod::kExact}) {
    methods.emplace(name_of(method), method);
  }
  command->add_option("--order", options->solve.method, "Method that finds the order, as below")
      ->transform(CLI::CheckedTransformer(methods))
      ->option_text("ours|anneal|nearest|file|exact [ours]");
  constexpr double kMaxSeconds = 1.0e6;
  CLI::Option* const seconds =
      command
          ->add_option("--seconds",
                       options->solve.seconds,
                       "Greatest time of the search, s; default: 1 for ours, no limit for exact")
          ->check(in_range(0.0, kMaxSeconds, "s"));
  constexpr std::int64_t kMaxSteps = 1'000'000'000'000;
  command
      ->add_option("--steps",
                   options->solve.steps,
                   "Number of steps of the search, in place of --seconds; gives the same result on "
                   "every machine")
      ->check(in_whole_range(1, kMaxSteps))
      ->excludes(seconds);
  constexpr std::int64_t kMaxSeed = 9'000'000'000'000'000;
  command->add_option("--seed", options->solve.seed, "Seed of the random numbers")
      ->check(in_whole_range(0, kMaxSeed))
      ->capture_default_str();
  constexpr std::int64_t kMaxMemory = 1'000'000;
  command->add_option("--memory", options->memory_mb, "Memory for the proof of exact, MB")
      ->check(in_whole_range(1, kMaxMemory, "MB"))
      ->capture_default_str();
  command->add_flag(
      "--json", options->json, "Print the result as JSON, with the course of annealing");
  command->callback([options, &status] { status = solve_or_tell(*options); });
}

}  // namespace sim
