#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
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
    "  kerfline offset part.txt --distance -1 -2 -3 --svg pocket.svg -o pocket.txt\n"
    "\n"
    "Exit status: 0 fine, 1 the contours have faults or a loop of them vanishes, 2 the call is "
    "wrong.";

struct OffsetOptions {
  std::string file;
  std::vector<double> distances_mm;
  OutlineOptions outline;
  std::string output;
  std::string svg;
  std::string dxf;
};

struct LoopSize {
  double area_mm2 = 0.0;  ///< Positive where the loop turns left.
  double length_mm = 0.0;
};

/// Of a contour with one loop.
LoopSize size_of(const Contour& loop) {
  LoopSize size;
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    const ContourVertex& from = loop.vertices[i];
    const ContourVertex& to = loop.vertices[i + 1 < loop.vertices.size() ? i + 1 : 0];
    const double chord = std::hypot(to.x - from.x, to.y - from.y);
    const double sweep = 4.0 * std::atan(from.bulge);
    const double half_sine = std::sin(0.5 * sweep);
    const double radius = half_sine == 0.0 ? 0.0 : 0.5 * chord / half_sine;  // Signed.
    size.area_mm2 += 0.5 * (from.x * to.y - from.y * to.x);
    size.area_mm2 += 0.5 * radius * radius * (sweep - std::sin(sweep));
    size.length_mm += half_sine == 0.0 ? chord : radius * sweep;
  }
  return size;
}

void append(Contour& contour, const cnc::contour::ContourView<double>& more) {
  const auto before = static_cast<std::uint32_t>(contour.vertices.size());
  contour.vertices.insert(contour.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const std::uint32_t end : more.loop_ends) contour.loop_ends.push_back(before + end);
}

/// One loop as a contour of its own, with its inside on the left.
Contour loop_of(const Contour& part, std::size_t loop) {
  Contour alone;
  const std::uint32_t first = part.view().loop_begin(loop);
  for (std::uint32_t i = first; i < part.loop_ends[loop]; ++i) {
    alone.vertices.push_back(part.vertices[i]);
  }
  alone.end_loop();
  return alone;
}

/// A loop that has the inside on its right is a hole: what lets material grow lets it shrink.
void turn_round(Contour& loop) {
  std::vector<ContourVertex> turned;
  for (std::size_t i = loop.vertices.size(); i-- > 0;) {
    const ContourVertex& before = loop.vertices[i > 0 ? i - 1 : loop.vertices.size() - 1];
    turned.push_back({loop.vertices[i].x, loop.vertices[i].y, -before.bulge});
  }
  loop.vertices = std::move(turned);
}

/// Reports the loops that a distance leaves nothing of. True where there are any.
bool report_vanished(const std::string& file,
                     const std::vector<Contour>& parts,
                     double distance_mm,
                     ContourOffset& offsetter) {
  bool any = false;
  for (const Contour& part : parts) {
    for (std::size_t loop = 0; loop < part.loop_ends.size(); ++loop) {
      Contour alone = loop_of(part, loop);
      const LoopSize size = size_of(alone);
      const bool shrinks = size.area_mm2 < 0.0 ? distance_mm > 0.0 : distance_mm < 0.0;
      // The widest circle in a loop has at least the radius of area over length.
      const double wide = std::abs(size.area_mm2) / std::max(size.length_mm, 1.0e-9);
      if (!shrinks || std::abs(distance_mm) < wide) continue;
      if (size.area_mm2 < 0.0) turn_round(alone);
      if (offsetter.offset(alone.view(), -std::abs(distance_mm)).loop_ends.size() != 0) continue;
      any = true;
      fmt::print(stderr,
                 "{}: the {} that begins at {:.3f} {:.3f} vanishes at distance {:g} mm; choose a "
                 "smaller one\n",
                 file,
                 size.area_mm2 < 0.0 ? "hole" : "loop",
                 alone.vertices.front().x,
                 alone.vertices.front().y,
                 distance_mm);
    }
  }
  return any;
}

ExitStatus offset_file(const OffsetOptions& options) {
  const std::vector<Contour> parts = read_contour_file(options.file, options.outline);
  Contour input;
  for (const Contour& part : parts) append(input, part.view());
  ContourOffset offsetter;
  std::vector<Contour> offsets;
  std::string text;
  bool vanished = false;
  for (const double distance_mm : options.distances_mm) {
    Contour& result = offsets.emplace_back();
    for (const Contour& part : parts) append(result, offsetter.offset(part.view(), distance_mm));
    vanished = report_vanished(options.file, parts, distance_mm, offsetter) || vanished;
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
  return vanished ? ExitStatus::kFaults : ExitStatus::kFine;
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
  mark_file(
      command
          ->add_option("FILE", options->file, "A drawing, or contours as text; - is standard input")
          ->required(),
      FileRole::kInput);
  command
      ->add_option("-d,--distance",
                   options->distances_mm,
                   "mm; positive lets material grow, negative lets it shrink; several at once")
      ->required()
      ->expected(1, -1)
      ->check(in_range(-drawing::kFarthestMm, drawing::kFarthestMm, "mm"));
  add_outline_options(*command, options->outline);
  const auto add_output = [&](const char* name, std::string& file, const char* help) {
    mark_file(command->add_option(name, file, help)->type_name("FILE"), FileRole::kOutput);
  };
  add_output("-o,--output", options->output, "Where to write; else standard output");
  add_output("--svg", options->svg, "Draw the contours and their offsets");
  add_output("--dxf", options->dxf, "Write the offsets as polylines with bulges");
  command->callback([options, &status] { status = offset_or_tell(*options); });
}

}  // namespace sim
