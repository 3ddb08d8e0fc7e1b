#include "host-sim/cli/cut_output_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string_view>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/report/utf8.hpp"

namespace sim {
namespace {

constexpr double kMaxAnimationS = 3600.0;
constexpr double kMaxMoney = 1.0e9;
constexpr std::size_t kMaxCurrencyBytes = 12;

/// Returns the reason why a text is no currency that can be printed after amounts; empty if it is
/// one.
std::string refusal_of_currency(const std::string& text) {
  bool is_sound = !text.empty() && text.size() <= kMaxCurrencyBytes;
  for (std::string_view rest = text; is_sound && !rest.empty();) {
    const Utf8Character next = first_character(rest);
    is_sound = next.is_valid && next.code_point >= U' ' && next.code_point != U'\x7f';
    rest.remove_prefix(next.bytes);
  }
  if (is_sound) return {};
  return fmt::format("a currency is a text of 1 to {} bytes, such as EUR", kMaxCurrencyBytes);
}

void add_price_options(CLI::App& command, cut::PriceList& prices) {
  command
      .add_option(
          "--rate", prices.per_hour, "Cost of an hour of the machine; with it the job is priced")
      ->check(in_range(0.0, kMaxMoney, ""))
      ->type_name("MONEY");
  command.add_option("--sheet-cost", prices.per_sheet, "Cost of the sheet")
      ->check(in_range(0.0, kMaxMoney, ""))
      ->type_name("MONEY");
  command.add_option("--currency", prices.currency, "Currency that is printed after amounts")
      ->check(CLI::Validator{refusal_of_currency, ""})
      ->type_name("TEXT");
}

}  // namespace

void add_cut_output_options(CLI::App& command, CutOutputOptions& options) {
  const auto add_file = [&](const char* name, std::string& file, const char* help) {
    mark_file(command.add_option(name, file, help)->type_name("FILE"), FileRole::kOutput);
  };
  add_file("--svg", options.svg, "Draw parts, path, kerf, order and rapids as SVG");
  add_file("--png", options.png, "Draw the picture of --svg as PNG");
  add_file("--animation", options.animation, "Write an SVG without scripts that plays the job");
  command
      .add_option("--animation-time",
                  options.animation_s,
                  "Greatest duration of the animation, s; a longer job is shown faster")
      ->check(in_range(1.0, kMaxAnimationS, "s"))
      ->type_name("S")
      ->capture_default_str();
  add_file(
      "--job-sheet", options.job_sheet, "Write a PDF with picture, conditions, parts and costs");
  add_price_options(command, options.prices);
}

}  // namespace sim
