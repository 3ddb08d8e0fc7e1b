#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/outline_options.hpp"
#include "host-sim/contour/contour_dxf.hpp"
#include "host-sim/contour/contour_file.hpp"
#include "host-sim/contour/contour_text.hpp"
#include "host-sim/plot/contour_picture.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

constexpr const char* kOffsetFooter =
    "FILE is a drawing, SVG, DXF or JSON, as `kerfline drawing` reads it, or text: a vertex to\n"
    "a line, `x y` or `x y bulge`, in mm; bulge = tan(sweep / 4) of the arc to the next vertex,\n"
    "positive to the left. `closed` or a blank line ends a loop, `#` begins a comment. Loops\n"
    "inside others are holes, loops in those islands, whichever way they run; parts of a file of\n"
    "parts have nothing to do with each other. Lines and arcs stay what they are, other curves\n"
    "become smooth arcs within the tolerance. The result is written as text.\n"
    "\n"
    "Examples:\n"
    "  kerfline offset part.svg --distance 0.28 --tolerance 0.1 --dxf cut.dxf -o cut.txt\n"
    "  kerfline offset part.txt --distance -1 -2 -3 --svg pocket.svg -o pocket.txt";

struct OffsetOptions {
  std::string file;
  std::vector<double> distances_mm;
  OutlineOptions outline;
  std::string output;
  std::string svg;
  std::string dxf;
};

void append(Contour& contour, const cnc::contour::ContourView<double>& more) {
  const auto before = static_cast<std::uint32_t>(contour.vertices.size());
  contour.vertices.insert(contour.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const std::uint32_t end : more.loop_ends) contour.loop_ends.push_back(before + end);
}

ExitStatus offset_file(const OffsetOptions& options) {
  const std::vector<Contour> parts = read_contour_file(options.file, options.outline);
  Contour input;
  for (const Contour& part : parts) append(input, part.view());
  ContourOffset offsetter;
  std::vector<Contour> offsets;
  std::string text;
  for (const double distance_mm : options.distances_mm) {
    Contour& result = offsets.emplace_back();
    for (const Contour& part : parts) append(result, offsetter.offset(part.view(), distance_mm));
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
  if (!options.dxf.empty()) write_file(options.dxf, dxf_of_contours(offsets));
  return ExitStatus::kFine;
}

ExitStatus offset_or_tell(const OffsetOptions& options) {
  try {
    return offset_file(options);
  } catch (const ContourTextError& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const FaultyDrawing& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const NoOffset& error) {
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
  command->add_option("FILE", options->file, "A drawing, or contours as text; - is standard input")
      ->required();
  command
      ->add_option("-d,--distance",
                   options->distances_mm,
                   "mm; positive lets material grow, negative lets it shrink; several at once")
      ->required()
      ->expected(1, -1)
      // CLI::Range lets through what is no number.
      ->check([](const std::string& text) {
        double value = 0.0;
        if (CLI::detail::lexical_cast(text, value) && std::abs(value) <= drawing::kFarthestMm) {
          return std::string{};
        }
        return fmt::format("{} is no distance within {:g} mm", text, drawing::kFarthestMm);
      });
  add_outline_options(*command, options->outline);
  command->add_option("-o,--output", options->output, "Where to write; else standard output")
      ->type_name("FILE");
  command->add_option("--svg", options->svg, "Draw the contours and their offsets")
      ->type_name("FILE");
  command->add_option("--dxf", options->dxf, "Write the offsets as polylines with bulges")
      ->type_name("FILE");
  command->callback([options, &status] { status = offset_or_tell(*options); });
}

}  // namespace sim
