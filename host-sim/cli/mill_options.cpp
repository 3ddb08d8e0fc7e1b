#include "host-sim/cli/mill_options.hpp"

#include <CLI/CLI.hpp>
#include <map>

#include "host-sim/cli/value_range.hpp"

namespace sim {
namespace {

constexpr double kGreatestFeed = 1.0e6;   // Greatest feed, mm/min.
constexpr double kGreatestSpeed = 1.0e6;  // Greatest spindle speed, rpm.

}  // namespace

void add_mill_options(CLI::App& command, pocket::MillSettings& mill, const std::string& otherwise) {
  command.add_option("--feed", mill.feed_mm_min, "Feed along the path, mm/min" + otherwise)
      ->check(in_range(0.1, kGreatestFeed, "mm/min"))
      ->type_name("MM/MIN");
  command
      .add_option(
          "--plunge-feed", mill.plunge_mm_min, "Greatest feed downwards, mm/min" + otherwise)
      ->check(in_range(0.1, kGreatestFeed, "mm/min"))
      ->type_name("MM/MIN");
  const std::string off = otherwise.empty() ? "; default: off" : ", or off";
  command.add_option("--spindle", mill.spindle_rpm, "Speed of the spindle, rpm" + otherwise + off)
      ->check(in_range(0.0, kGreatestSpeed, "rpm"))
      ->type_name("RPM");
  command
      .add_option(
          "--spin-up", mill.spin_up_s, "Time for which the program waits for the spindle, s")
      ->check(in_range(0.0, 600.0, "s"))
      ->type_name("S");
  const std::map<std::string, pocket::Coolant> coolants{{"off", pocket::Coolant::kOff},
                                                        {"mist", pocket::Coolant::kMist},
                                                        {"flood", pocket::Coolant::kFlood}};
  command.add_option("--coolant", mill.coolant, "Coolant: mist is M7, flood M8")
      ->transform(CLI::CheckedTransformer(coolants))
      ->option_text("off|mist|flood [off]");
}

}  // namespace sim
