#include "host-sim/cli/outline_options.hpp"

#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "host-sim/cli/value_range.hpp"

namespace sim {

void add_outline_options(CLI::App& command, OutlineOptions& outline) {
  std::map<std::string, cnc::contour::FitMethod> methods;
  for (const auto method :
       {cnc::contour::FitMethod::kFewest, cnc::contour::FitMethod::kBisecting}) {
    methods.emplace(name_of(method), method);
  }
  command
      .add_option("--tolerance",
                  outline.tolerance_mm,
                  "Greatest distance between the drawing's curves and their arcs, mm")
      ->check(in_range(kMinToleranceMm, kGreatestToleranceMm, "mm"))
      ->capture_default_str();
  command
      .add_option("--fit",
                  outline.method,
                  "Method that turns curves into arcs: fewest arcs, or as in the paper, by halving "
                  "until biarcs fit")
      ->transform(CLI::CheckedTransformer(methods))
      ->option_text("fewest|paper [fewest]");
}

void add_text_option(CLI::App& command, drawing::TextMode& text) {
  const std::map<std::string, drawing::TextMode> modes{{"skip", drawing::TextMode::kSkip},
                                                       {"outline", drawing::TextMode::kOutline},
                                                       {"stroke", drawing::TextMode::kStroke}};
  command
      .add_option("--text",
                  text,
                  "Treatment of letters: skip; outline, in the font of the drawing; or stroke, "
                  "single lines that are engraved as colour `text`")
      ->transform(CLI::CheckedTransformer(modes))
      ->option_text("skip|outline|stroke [skip]");
}

}  // namespace sim
