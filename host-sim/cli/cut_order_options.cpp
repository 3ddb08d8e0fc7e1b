#include "host-sim/cli/cut_order_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <map>
#include <stdexcept>

#include "firmware/machine/configuration.hpp"
#include "firmware/machine/settings.hpp"
#include "host-sim/cli/value_range.hpp"

namespace sim {
namespace {

/// Greatest coordinate of the start and the end of a job, mm.
constexpr double kFarthestMm = 1.0e5;

/// Reads a position `X,Y`, mm.
cut::Place place_from(const char* option, const std::string& text) {
  if (text.empty()) return {0.0, 0.0};
  const std::size_t comma = text.find(',');
  const auto number = [&](std::size_t begin, std::size_t end) {
    double value = 0.0;
    const auto [rest, error] = std::from_chars(text.data() + begin, text.data() + end, value);
    if (error == std::errc{} && rest == text.data() + end && std::abs(value) <= kFarthestMm) {
      return value;
    }
    throw std::invalid_argument(fmt::format(
        "{} {}: must be X,Y in mm, each at most {:g}, such as 0,300", option, text, kFarthestMm));
  };
  if (comma == std::string::npos) static_cast<void>(number(text.size(), text.size()));
  return {number(0, comma), number(comma + 1, text.size())};
}

template <typename Value>
std::map<std::string, Value> words_of(std::initializer_list<Value> values) {
  std::map<std::string, Value> words;
  for (const Value value : values) {
    if constexpr (std::is_same_v<Value, order::OrderMethod>) {
      words.emplace(order::name_of(value), value);
    } else {
      words.emplace(cut::text_of(value), value);
    }
  }
  return words;
}

cnc::Settings settings_with(const std::vector<SettingChange>& changes) {
  cnc::Settings settings;
  for (const SettingChange& change : changes) {
    if (settings.set(change.number, change.value).ok()) continue;
    throw std::invalid_argument(fmt::format(
        "{}: ${}={:g} is no such setting, or out of its range; `kerfline manual` lists them",
        change.place,
        change.number,
        change.value));
  }
  return settings;
}

}  // namespace

void add_cut_order_options(CLI::App& command, CutOrderOptions& options) {
  using order::OrderMethod;
  command.add_option("--order", options.method, "Method that finds the order of the cuts")
      ->transform(CLI::CheckedTransformer(words_of({OrderMethod::kOurs,
                                                    OrderMethod::kNearest,
                                                    OrderMethod::kFile,
                                                    OrderMethod::kAnneal,
                                                    OrderMethod::kExact})))
      ->option_text("ours|nearest|file|anneal|exact [ours]");
  command.add_option("--cost", options.cost, "Quantity of the rapids that the search minimizes")
      ->transform(
          CLI::CheckedTransformer(words_of({cut::OrderCost::kTime, cut::OrderCost::kLength})))
      ->option_text("time|length [time]");
  command
      .add_option(
          "--group",
          options.grouping,
          "Grouping of contours that are cut one after the other: by layer, by part, or none")
      ->transform(CLI::CheckedTransformer(
          words_of({cut::Grouping::kNone, cut::Grouping::kLayer, cut::Grouping::kPart})))
      ->option_text("none|layer|part [none]");
  command
      .add_option("--from", options.from, "Position of the head before the job, mm; default: 0,0")
      ->type_name("X,Y");
  command
      .add_option("--to",
                  options.to,
                  "Position to which the head goes after the job, mm; default: that of --from")
      ->type_name("X,Y");
  constexpr double kMaxSeconds = 1.0e6;
  command
      .add_option("--seconds",
                  options.seconds,
                  "Time of the search, s; default: a fixed number of steps, with the same order on "
                  "every machine")
      ->check(in_range(0.0, kMaxSeconds, "s"))
      ->type_name("S");
  constexpr std::int64_t kMaxSeed = 9'000'000'000'000'000;
  command.add_option("--seed", options.seed, "Seed of the search's random numbers")
      ->check(in_whole_range(0, kMaxSeed))
      ->capture_default_str();
}

cut::OrderWish order_wish_of(const CutOrderOptions& options,
                             const std::vector<SettingChange>& settings,
                             order::OrderProgress progress) {
  cut::OrderWish wish{.method = options.method, .cost = options.cost};
  wish.grouping = options.grouping;
  wish.from = place_from("--from", options.from);
  wish.to = options.to.empty() ? wish.from : place_from("--to", options.to);
  wish.seconds = options.seconds;
  wish.seed = options.seed;
  wish.progress = std::move(progress);
  const cnc::Settings machine = settings_with(settings);
  const cnc::motion::Limits limits = limits_from(machine);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    wish.limits.rate_mm_s[axis] = static_cast<double>(motor_rate(limits, axis));
    wish.limits.acceleration_mm_s2[axis] = static_cast<double>(limits.acceleration_mm_s2[axis]);
    wish.limits.jerk_mm_s3[axis] = static_cast<double>(limits.jerk_mm_s3[axis]);
    wish.steps_per_mm[axis] = static_cast<double>(limits.scale[axis].steps_per_mm());
  }
  wish.junction_deviation_mm = static_cast<double>(limits.junction_deviation_mm);
  wish.arc_tolerance_mm = static_cast<double>(machine.get(cnc::setting::kArcTolerance));
  return wish;
}

}  // namespace sim
