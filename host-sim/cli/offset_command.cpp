#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/outline_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/contour/contour_dxf.hpp"
#include "host-sim/contour/contour_file.hpp"
#include "host-sim/contour/contour_text.hpp"
#include "host-sim/contour/vanished.hpp"
#include "host-sim/plot/contour_picture.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

constexpr const char* kOffsetFooter =
    "FILE is a drawing, SVG, DXF or JSON, as `kerfline drawing` reads it, or text: a vertex to\n"
    "a line, `x y` or `x y bulge`, in mm; bulge = tan(sweep / 4) of the arc to the next vertex,\n"
    "positive to the left. `closed` or a blank line ends a loop, `#` begins a comment. Loops\n"
    "within other loops are holes, and loops within holes are islands, in whichever direction "
    "they\n"
    "run. In a file of several parts, each part is offset by itself. Lines and arcs are kept. "
    "Other\n"
    "curves become smooth arcs within the tolerance. The result is written as text.\n"
    "\n"
    "Examples:\n"
    "  kerfline offset part.svg --distance 0.28 --tolerance 0.1 --dxf cut.dxf -o cut.txt\n"
    "  kerfline offset part.txt --distance -1 -2 -3 --svg pocket.svg -o pocket.txt\n"
    "\n"
    "Exit status: 0 fine, 1 the contours have faults or a part of them vanishes, 2 the call is "
    "wrong.";

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

/// Prints the parts that vanish at an offset of `distance_mm`. Returns whether there are any.
bool report_vanished(const std::string& file,
                     const std::vector<Vanished>& found,
                     double distance_mm) {
  constexpr std::size_t kMaxListed = 20;
  for (std::size_t i = 0; i < std::min(found.size(), kMaxListed); ++i) {
    terminal::print(stderr,
                    "{}: {} at distance {:g} mm; choose a smaller one\n",
                    file,
                    found[i].text(),
                    distance_mm);
  }
  if (found.size() > kMaxListed) {
    terminal::print(stderr,
                    "{}: and {} more vanish at distance {:g} mm\n",
                    file,
                    found.size() - kMaxListed,
                    distance_mm);
  }
  return !found.empty();
}

ExitStatus offset_file(const OffsetOptions& options) {
  const ContourFile read =
      contours_of(read_text(options.file), options.file, options.outline, Crossing::kFilled);
  for (const std::string& note : read.notes) terminal::print(stderr, "{}\n", note);
  Contour input;
  for (const ContourPart& part : read.parts) append(input, part.contour.view());
  ContourOffset offsetter;
  std::vector<Contour> offsets;
  std::string text;
  bool has_vanished = false;
  for (const double distance_mm : options.distances_mm) {
    Contour& result = offsets.emplace_back();
    std::vector<Vanished> gone;
    for (const ContourPart& part : read.parts) {
      Contour offset;
      append(offset, offsetter.offset(part.contour.view(), distance_mm));
      append(result, offset.view());
      const std::vector<Vanished> more = vanished(part.contour, offset, distance_mm, offsetter);
      gone.insert(gone.end(), more.begin(), more.end());
    }
    has_vanished = report_vanished(options.file, gone, distance_mm) || has_vanished;
    text += fmt::format("# distance {} mm: {} vertices, loops: {}\n{}",
                        distance_mm,
                        result.vertices.size(),
                        result.loop_ends.size(),
                        text_of_contour(result.view()));
  }
  if (options.output.empty()) {
    terminal::write_data(text);
  } else {
    write_file(options.output, text);
  }
  if (!options.svg.empty()) write_file(options.svg, draw_contours(input, offsets, options.file));
  if (!options.dxf.empty()) write_file(options.dxf, dxf_of_contours(offsets));
  return has_vanished ? ExitStatus::kFaults : ExitStatus::kFine;
}

ExitStatus offset_or_tell(const OffsetOptions& options) {
  try {
    return offset_file(options);
  } catch (const ContourTextError& error) {
    terminal::print(stderr, "{}\n", error.what());
  } catch (const FaultyDrawing& error) {
    terminal::print_lines(stderr, std::string{error.what()} + "\n");
  } catch (const NoOffset& error) {
    terminal::print(stderr, "{}: {}\n", options.file, error.what());
  }
  for (const std::string& output : {options.output, options.svg, options.dxf}) {
    const std::string stale = stale_note(output);
    if (!stale.empty()) terminal::print(stderr, "kerfline: nothing is written{}\n", stale);
  }
  return ExitStatus::kFaults;
}

}  // namespace

void add_offset_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command = app.add_subcommand(
      "offset", "Offset closed contours of lines and arcs: half a kerf outwards, pockets inwards.");
  command->footer(kOffsetFooter);
  const auto options = std::make_shared<OffsetOptions>();
  mark_file(
      command
          ->add_option("FILE", options->file, "A drawing, or contours as text; - is standard input")
          ->required(),
      FileRole::kInput);
  command
      ->add_option(
          "-d,--distance",
          options->distances_mm,
          "Distance of the offset, mm: a positive one makes the material larger, a negative "
          "one smaller; several are possible")
      ->required()
      ->expected(1, -1)
      ->check(in_range(-drawing::kFarthestMm, drawing::kFarthestMm, "mm"));
  add_outline_options(*command, options->outline);
  const auto add_output = [&](const char* name, std::string& file, const char* help) {
    mark_file(command->add_option(name, file, help)->type_name("FILE"), FileRole::kOutput);
  };
  add_output("-o,--output", options->output, "File of the offsets; default: standard output");
  add_output("--svg", options->svg, "Draw the contours and their offsets");
  add_output("--dxf", options->dxf, "Write the offsets as polylines with bulges");
  command->callback([options, &status] { status = offset_or_tell(*options); });
}

}  // namespace sim
