#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/import_options.hpp"
#include "host-sim/cli/outline_options.hpp"
#include "host-sim/cli/picture_files.hpp"
#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/drawing.hpp"
#include "host-sim/job/setting_line.hpp"
#include "host-sim/plot/drawing_picture.hpp"
#include "host-sim/report/report_json.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

using drawing::Drawing;
using drawing::DrawnContour;

// Greatest distance between the curves and the chords of --json, mm.
constexpr double kJsonChordMm = 0.01;

constexpr const char* kDrawingFooter =
    "Examples:\n"
    "  kerfline drawing part.dxf --svg part.svg\n"
    "  kerfline drawing part.svg --gap 0.1 --json\n"
    "\n"
    "Reads SVG, DXF, PDF, projects of LightBurn, and the JSON of nesting jobs and layouts.\n"
    "Exit status: 0 fine, 1 the drawing has faults, 2 the call is wrong.";

struct DrawingOptions {
  std::string file;
  drawing::ImportOptions import;
  std::string svg;
  bool json = false;
};

std::map<std::string, std::size_t> kinds_of(const DrawnContour& contour) {
  std::map<std::string, std::size_t> kinds;
  for (const drawing::Shape& shape : contour.shapes) ++kinds[std::string{name_of(shape)}];
  return kinds;
}

std::string_view side_of(const DrawnContour& contour) {
  if (!contour.closed) return "open";
  return contour.is_hole() ? "hole" : "outer";
}

void print(const Drawing& drawn) {
  terminal::print("{}: {} contours\n", drawn.file, drawn.contours.size());
  for (std::size_t i = 0; i < drawn.contours.size(); ++i) {
    const DrawnContour& contour = drawn.contours[i];
    const drawing::Layer& layer = drawn.layers[contour.entity.layer];
    std::string kinds;
    for (const auto& [kind, count] : kinds_of(contour)) kinds += fmt::format(" {} {}", count, kind);
    const std::string in = contour.parent ? fmt::format(" in {}", *contour.parent + 1) : "";
    terminal::print("  {:4} {:5}{}  layer \"{}\" {}  {:.3f} mm  {:.3f} mm2 {}  {}\n",
                    i + 1,
                    side_of(contour),
                    in,
                    layer.name,
                    layer.colour,
                    contour.length_mm,
                    std::abs(contour.area_mm2),
                    kinds,
                    contour.entity.name);
  }
  for (const drawing::DrawnPicture& picture : drawn.pictures) {
    const drawing::Layer& layer = drawn.layers[picture.entity.layer];
    terminal::print("  picture  layer \"{}\" {}  {} x {} pixels  {}\n",
                    layer.name,
                    layer.colour,
                    picture.image->width,
                    picture.image->height,
                    picture.entity.name);
  }
  for (const drawing::Fault& fault : drawn.faults) {
    terminal::print("{}: {}\n", name_of(fault.kind), to_string(fault, drawn.file));
  }
  if (drawn.more_lines != 0) terminal::print("and {} more open contours\n", drawn.more_lines);
  if (drawn.more_faults != 0) terminal::print("and {} more faults\n", drawn.more_faults);
}

nlohmann::ordered_json to_json(const drawing::Place& place) { return {place.x(), place.y()}; }

nlohmann::ordered_json to_json(const DrawnContour& contour, const Drawing& drawn) {
  nlohmann::ordered_json row;
  row["entity"] = contour.entity.name;
  row["line"] = contour.entity.line;
  row["layer"] = drawn.layers[contour.entity.layer].name;
  row["colour"] = drawn.layers[contour.entity.layer].colour;
  row["side"] = side_of(contour);
  row["depth"] = contour.depth;
  row["parent"] = contour.parent ? nlohmann::ordered_json(*contour.parent) : nullptr;
  row["length_mm"] = contour.length_mm;
  row["area_mm2"] = std::abs(contour.area_mm2);
  row["kinds"] = kinds_of(contour);
  row["outline_mm"] = nlohmann::ordered_json::array();
  for (const auto& place : outline_of(contour.shapes, kJsonChordMm)) {
    row["outline_mm"].push_back(to_json(place));
  }
  return row;
}

nlohmann::ordered_json to_json(const drawing::DrawnPicture& picture, const Drawing& drawn) {
  const auto width = static_cast<double>(picture.image->width);
  const auto height = static_cast<double>(picture.image->height);
  nlohmann::ordered_json row;
  row["entity"] = picture.entity.name;
  row["line"] = picture.entity.line;
  row["layer"] = drawn.layers[picture.entity.layer].name;
  row["colour"] = drawn.layers[picture.entity.layer].colour;
  row["columns"] = picture.image->width;
  row["rows"] = picture.image->height;
  row["file"] =
      picture.file.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(picture.file);
  row["corners_mm"] = nlohmann::ordered_json::array();
  for (const drawing::Place& corner : {drawing::Place{0.0, 0.0},
                                       drawing::Place{width, 0.0},
                                       drawing::Place{width, height},
                                       drawing::Place{0.0, height}}) {
    row["corners_mm"].push_back(to_json(picture.to_mm(corner)));
  }
  return row;
}

nlohmann::ordered_json to_json(const drawing::Fault& fault) {
  nlohmann::ordered_json row;
  row["kind"] = name_of(fault.kind);
  row["entity"] = fault.entity.name;
  row["line"] = fault.entity.line;
  row["column"] = fault.entity.column;
  row["place_mm"] = fault.place_mm ? to_json(*fault.place_mm) : nlohmann::ordered_json(nullptr);
  row["reason"] = fault.reason;
  row["remedy"] = fault.remedy;
  return row;
}

nlohmann::ordered_json to_json(const Drawing& drawn) {
  nlohmann::ordered_json all;
  all["file"] = drawn.file;
  all["contours"] = nlohmann::ordered_json::array();
  for (const DrawnContour& contour : drawn.contours)
    all["contours"].push_back(to_json(contour, drawn));
  all["pictures"] = nlohmann::ordered_json::array();
  for (const drawing::DrawnPicture& picture : drawn.pictures) {
    all["pictures"].push_back(to_json(picture, drawn));
  }
  all["faults"] = nlohmann::ordered_json::array();
  for (const drawing::Fault& fault : drawn.faults) all["faults"].push_back(to_json(fault));
  all["more_faults"] = drawn.more_faults;
  all["more_open_lines"] = drawn.more_lines;
  return all;
}

ExitStatus look_at(const DrawingOptions& options) {
  drawing::ImportOptions import = options.import;
  import.read_beside = reader_beside(options.file);
  const Drawing drawn = drawing::read_drawing(options.file, read_text(options.file, true), import);
  if (options.json) {
    constexpr int kIndent = 1;
    terminal::write_data(dumped(to_json(drawn), kIndent) + "\n");
  } else {
    print(drawn);
  }
  if (!options.svg.empty()) write_file(options.svg, draw_contours(drawn));
  return drawn.has_errors() ? ExitStatus::kFaults : ExitStatus::kFine;
}

}  // namespace

void add_drawing_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command = app.add_subcommand(
      "drawing", "Check a drawing: its contours, which of them are holes, and every fault.");
  command->footer(kDrawingFooter);
  const auto options = std::make_shared<DrawingOptions>();
  mark_file(command
                ->add_option("FILE",
                             options->file,
                             "Drawing as SVG, DXF, PDF, LightBurn or JSON; - is standard input")
                ->required(),
            FileRole::kInput);
  add_import_options(*command, options->import);
  add_text_option(*command, options->import.text);
  mark_file(
      command
          ->add_option(
              "--svg", options->svg, "Draw the contours that were read, with the points of faults")
          ->type_name("FILE"),
      FileRole::kOutput);
  command->add_flag(
      "--json", options->json, "Print the contours as JSON, with outlines within 0.01 mm");
  command->callback([options, &status] { status = look_at(*options); });
}

}  // namespace sim
