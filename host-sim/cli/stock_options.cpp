#include "host-sim/cli/stock_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string_view>

#include "host-sim/cli/cutter_text.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/contour/contour_file.hpp"
#include "host-sim/contour/contour_text.hpp"
#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/drawing.hpp"
#include "host-sim/plot/picture_file.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/surface/read_surface.hpp"
#include "host-sim/trace/input_file.hpp"

namespace sim {
namespace {

constexpr const char* kStockForm = "XMIN,YMIN,XMAX,YMAX,ZTOP[,ZBOTTOM]";

std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> words;
  for (;;) {
    const std::size_t comma = text.find(',');
    words.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return words;
    text.remove_prefix(comma + 1);
  }
}

void read_box(const std::string& text, StockWish& wish) {
  const std::vector<std::string_view> words = split_at_commas(text);
  if (words.size() != 5 && words.size() != 6) {
    refuse_option("--stock",
                  text,
                  fmt::format("has {} numbers; it requires {} in mm, such as 0,0,100,80,0,-12",
                              words.size(),
                              kStockForm));
  }
  std::vector<double> values;
  values.reserve(words.size());
  for (const std::string_view word : words) values.push_back(number_of("--stock", text, word));
  wish.has_bottom = values.size() == 6;
  const double bottom = wish.has_bottom ? values[5] : values[4] - stock::kDeepestStockMm;
  wish.box = {values[0], values[1], values[2], values[3], values[4], bottom};
}

stock::Ring ring_of(const std::vector<drawing::Shape>& shapes) {
  stock::Ring ring;
  for (const drawing::Place& place : outline_of(shapes, drawing::kChordToleranceMm)) {
    ring.push_back({place.x(), place.y()});
  }
  return ring;
}

/// Returns the loops of contours as text, with their arcs within 1 µm.
std::vector<stock::Ring> rings_of_text(const std::string& text, const std::string& file) {
  try {
    const Contour contour = contour_from_text(text, file);
    std::vector<stock::Ring> rings;
    for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
      std::vector<drawing::Shape> shapes;
      const std::uint32_t first = contour.view().loop_begin(loop);
      for (std::uint32_t i = first; i < contour.loop_ends[loop]; ++i) {
        const ContourVertex& from = contour.vertices[i];
        const ContourVertex& to = contour.vertices[i + 1 < contour.loop_ends[loop] ? i + 1 : first];
        shapes.push_back(drawing::bulge_edge(from.point(), to.point(), from.bulge));
      }
      rings.push_back(ring_of(shapes));
    }
    return rings;
  } catch (const ContourTextError& error) {
    throw std::invalid_argument(error.what());
  }
}

/// Returns the closed contours of a drawing, or of contours as text, with their curves within 1 µm.
/// Throws std::invalid_argument for the first fault.
std::vector<stock::Ring> rings_of(const std::string& file) {
  const std::string text = read_text(file);
  if (is_contour_text(text)) return rings_of_text(text, file);
  const drawing::Drawing drawn = drawing::read_drawing(file, text, {.refuses_crossings = true});
  for (const drawing::Fault& fault : drawn.faults) {
    const bool is_text = fault.kind == drawing::FaultKind::kText;
    if (fault.is_error() || is_text) throw std::invalid_argument(to_string(fault, file));
    if (fault.kind == drawing::FaultKind::kMended) {
      terminal::print(stderr, "{}\n", to_string(fault, file));
    }
  }
  std::vector<stock::Ring> rings;
  for (const drawing::DrawnContour& contour : drawn.contours) {
    if (contour.closed) rings.push_back(ring_of(contour.shapes));
  }
  return rings;
}

/// Checks that each option is given together with the option that it requires. Throws
/// std::invalid_argument otherwise.
void refuse_lonely(const StockOptions& options) {
  if (options.target.empty() != !options.depth_mm) {
    throw std::invalid_argument(
        options.target.empty() ? "--stock-depth: requires the drawing of --stock-target"
                               : "--stock-target: requires the depth of the pocket, --stock-depth");
  }
  if (!options.map.empty() && options.surface.empty()) {
    throw std::invalid_argument("--stock-map: requires the surface of --stock-surface");
  }
  if (!options.surface.empty() && !options.target.empty()) {
    throw std::invalid_argument(
        "--stock-surface: excludes --stock-target, because the stock is compared with only one of "
        "them; leave one out");
  }
  if (!options.box.empty()) return;
  const auto refuse_without_stock = [](const char* option) {
    throw std::invalid_argument(fmt::format("{}: requires the block of --stock", option));
  };
  for (const auto& [option, value] : stock_files(options)) {
    if (!value.empty()) refuse_without_stock(option);
  }
  if (!options.target.empty()) refuse_without_stock("--stock-target");
  if (!options.surface.empty()) refuse_without_stock("--stock-surface");
  if (!options.tool.empty()) refuse_without_stock("--tool");
}

}  // namespace

void add_stock_options(CLI::App& command, StockOptions& options) {
  command
      .add_option("--stock",
                  options.box,
                  "Block that is carved along the steps, mm in machine coordinates; default of the "
                  "bottom: below every cut")
      ->type_name(kStockForm);
  command
      .add_option(
          "--tool",
          options.tool,
          "Tool that carves: diameter in mm and kind, flat by default; for a bull nose its "
          "corner radius; for a V its included angle in degrees and the diameter of its tip")
      ->type_name(kCutterForm);
  command
      .add_option("--stock-cell",
                  options.cell_mm,
                  "Side of a cell of the stock, mm; a cell takes 8 bytes of memory")
      ->check(in_range(stock::kMinCellMm, stock::kGreatestCellMm, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  const auto add_output = [&](const char* name, std::string& file, const char* help) {
    mark_file(command.add_option(name, file, help)->type_name("FILE"), FileRole::kOutput);
  };
  add_output("--stock-png", options.png, "Draw the carved stock in plan, coloured by depth");
  add_output("--stock-stl", options.stl, "Write the carved stock as a body, binary STL in mm");
  add_output("--stock-ply", options.ply, "Write the carved stock as binary PLY in mm");
  mark_file(command
                .add_option("--stock-target",
                            options.target,
                            "Compare the carved stock with the pocket of this drawing, or of "
                            "contours as text, in machine\ncoordinates")
                ->type_name("FILE"),
            FileRole::kInput);
  command
      .add_option("--stock-depth",
                  options.depth_mm,
                  "Depth of the pocket of --stock-target below the stock's top, mm")
      ->check(in_range(0.0, stock::kDeepestStockMm, "mm"))
      ->type_name("MM");
  mark_file(command
                .add_option("--stock-surface",
                            options.surface,
                            "Compare the carved stock with this surface, a grid or a mesh as "
                            "kerfline surface\nreads them, mm in machine coordinates")
                ->type_name("FILE"),
            FileRole::kInput);
  add_output(
      "--stock-map",
      options.map,
      "Draw the error of the stock against --stock-surface in plan, SVG or PNG: gouges red,\n"
      "rests blue, with a list of the worst points");
}

std::optional<StockWish> stock_wish_of(const StockOptions& options) {
  refuse_lonely(options);
  if (options.box.empty()) return std::nullopt;
  if (options.tool.empty()) {
    throw std::invalid_argument("--stock: requires the tool that carves, such as --tool 6");
  }
  StockWish wish;
  wish.cell_mm = options.cell_mm;
  wish.png = options.png;
  wish.stl = options.stl;
  wish.ply = options.ply;
  wish.map = options.map;
  require_picture_name("--stock-map", options.map);
  read_box(options.box, wish);
  wish.cutter = cutter_of("--tool", options.tool);
  if (const std::string fault = fault_of(wish.box, wish.cell_mm); !fault.empty()) {
    refuse_option("--stock", options.box, fault);
  }
  if (options.surface.empty()) return wish;
  if (const std::string fault = fault_of_comparison(wish.box, wish.cell_mm); !fault.empty()) {
    refuse_option("--stock-surface", options.surface, fault);
  }
  return wish;
}

std::optional<stock::PocketTarget> stock_target_of(const StockOptions& options) {
  if (options.target.empty()) return std::nullopt;
  stock::PocketTarget target{rings_of(options.target), options.depth_mm.value_or(0.0)};
  if (const std::string fault = fault_of(target, options.cell_mm); !fault.empty()) {
    refuse_option("--stock-target", options.target, fault);
  }
  return target;
}

std::shared_ptr<const surface::Mesh> stock_surface_of(const StockOptions& options) {
  if (options.surface.empty()) return nullptr;
  surface::SurfaceInput read =
      surface::read_surface(read_bytes(options.surface), name_of_input(options.surface), {});
  for (const std::string& note : read.notes) terminal::print(stderr, "{}\n", note);
  return std::make_shared<const surface::Mesh>(std::move(read.mesh));
}

std::vector<std::pair<const char*, std::string>> stock_files(const StockOptions& options) {
  return {{"--stock-png", options.png},
          {"--stock-stl", options.stl},
          {"--stock-ply", options.ply},
          {"--stock-map", options.map}};
}

}  // namespace sim
