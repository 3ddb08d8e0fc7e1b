#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "host-sim/cli/commands.hpp"
#include "host-sim/contour/contour_file.hpp"
#include "host-sim/contour/contour_text.hpp"
#include "host-sim/contour/material_side.hpp"
#include "host-sim/plot/contour_picture.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

constexpr const char* kOffsetFooter =
    "FILE has a vertex to a line, `x y` or `x y bulge`, in mm; bulge = tan(sweep / 4) of\n"
    "the arc to the next vertex, positive to the left. `closed` or a blank line ends a\n"
    "loop, `#` begins a comment. Loops inside others are holes, loops in those islands,\n"
    "whichever way they run. The result is written the same way.\n"
    "\n"
    "Examples:\n"
    "  kerfline offset part.txt --distance 0.28 -o cut.txt\n"
    "  kerfline offset part.txt --distance -1 -2 -3 --svg pocket.svg -o pocket.txt";

struct OffsetOptions {
  std::string file;
  std::vector<double> distances_mm;
  std::string output;
  std::string svg;
};

Contour copied(const cnc::contour::ContourView<double>& view) {
  return {{view.vertices.begin(), view.vertices.end()},
          {view.loop_ends.begin(), view.loop_ends.end()}};
}

ExitStatus offset_file(const OffsetOptions& options) {
  Contour input = read_contour_file(options.file);
  put_material_left(input);
  ContourOffset offsetter;
  std::vector<Contour> offsets;
  std::string text;
  for (const double distance_mm : options.distances_mm) {
    offsets.push_back(copied(offsetter.offset(input.view(), distance_mm)));
    const Contour& result = offsets.back();
    text += fmt::format("# distance {} mm: {} vertices, loops: {}\n{}",
                        distance_mm,
                        result.vertices.size(),
                        result.loop_ends.size(),
                        text_of_contour(result.view()));
  }
  if (options.output.empty()) {
    fmt::print("{}", text);
  } else {
    write_file(options.output, text);
  }
  if (!options.svg.empty()) write_file(options.svg, draw_contours(input, offsets, options.file));
  return ExitStatus::kFine;
}

ExitStatus offset_or_tell(const OffsetOptions& options) {
  try {
    return offset_file(options);
  } catch (const ContourTextError& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const OpenContour& error) {
    fmt::print(stderr, "{}: {}\n", options.file, error.what());
  }
  return ExitStatus::kFaults;
}

}  // namespace

void add_offset_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command = app.add_subcommand(
      "offset", "Offset closed contours of lines and arcs: half a kerf outwards, pockets inwards.");
  command->footer(kOffsetFooter);
  const auto options = std::make_shared<OffsetOptions>();
  command->add_option("FILE", options->file, "Contours as text; - is standard input")->required();
  command
      ->add_option("-d,--distance",
                   options->distances_mm,
                   "mm; positive lets material grow, negative lets it shrink; several at once")
      ->required()
      ->expected(1, -1);
  command->add_option("-o,--output", options->output, "Where to write; else standard output");
  command->add_option("--svg", options->svg, "Draw the contours and their offsets");
  command->callback([options, &status] { status = offset_or_tell(*options); });
}

}  // namespace sim
