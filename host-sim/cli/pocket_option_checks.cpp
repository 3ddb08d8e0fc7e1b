#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <set>
#include <stdexcept>
#include <system_error>

#include "host-sim/cli/pocket_options.hpp"
#include "host-sim/pocket/spiral_path.hpp"
#include "host-sim/report/nearest_name.hpp"

namespace sim {
namespace {

LayerDepth parse_layer_depth(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  const std::string number = equals == std::string::npos ? "" : text.substr(equals + 1);
  const char* const end = number.data() + number.size();
  double depth_mm = -1.0;
  const auto read = std::from_chars(number.data(), end, depth_mm);
  const bool is_number = read.ec == std::errc{} && read.ptr == end;
  if (!is_number || !(depth_mm >= 0.0 && depth_mm <= kGreatestDepthMm)) {
    throw std::invalid_argument{
        fmt::format("--depth-of {}: must be a layer or colour and its depth, 0 to {:g} mm, such as "
                    "\"holes=3.5\"",
                    text,
                    kGreatestDepthMm)};
  }
  return {text.substr(0, equals), depth_mm};
}

[[noreturn]] void refuse_layer(const LayerDepth& depth, const std::set<drawing::Layer>& layers) {
  std::string known;
  std::vector<std::string> names;
  for (const drawing::Layer& layer : layers) {
    names.insert(names.end(), {layer.name, layer.colour});
    known += fmt::format(" \"{}\" {};", layer.name, layer.colour);
  }
  throw std::invalid_argument{fmt::format(
      "--depth-of: the drawing has no closed contour of layer or colour \"{}\"; it has{}{}",
      depth.layer,
      known,
      did_you_mean(depth.layer, names))};
}

/// Options that V carving does not use.
constexpr std::initializer_list<const char*> kOptionsOfClearing{"--depth-of",
                                                                "--strategy",
                                                                "--engagement",
                                                                "--stepover",
                                                                "--corner",
                                                                "--depth-step",
                                                                "--entry",
                                                                "--slope",
                                                                "--conventional",
                                                                "--keep-feed",
                                                                "--finish",
                                                                "--finish-floor",
                                                                "--wear",
                                                                "--stock",
                                                                "--rest-of",
                                                                "--holes"};

/// Checks of a call for options that exclude each other.
class Refusals {
 public:
  explicit Refusals(const CLI::App& command) : command_{command} {}

  /// Checks that the call has none of the options `names`. Throws std::invalid_argument otherwise.
  void of(std::initializer_list<const char*> names, const char* mode, const char* remedy) const {
    for (const char* name : names) {
      if (command_.count(name) == 0) continue;
      throw std::invalid_argument{
          fmt::format("{}: cannot be used with {}; {}", name, mode, remedy)};
    }
  }

 private:
  const CLI::App& command_;
};

/// Checks allowances and step-over. Throws std::invalid_argument if one of them is too large for
/// the tool or the level.
void check_sizes(const PocketCommandOptions& options) {
  if (options.finish_mm > options.radius_mm()) {
    throw std::invalid_argument{fmt::format("--finish {:g}: must be at most half the tool, {:g} mm",
                                            options.finish_mm,
                                            options.radius_mm())};
  }
  if (options.floor_mm > options.level_mm()) {
    throw std::invalid_argument{
        fmt::format("--finish-floor {:g}: must be at most one level, {:g} mm",
                    options.floor_mm,
                    options.level_mm())};
  }
  if (options.rest_of_mm > 0.0 && options.rest_of_mm <= options.tool_mm) {
    throw std::invalid_argument{fmt::format(
        "--rest-of {:g}: must be larger than --tool {:g} mm", options.rest_of_mm, options.tool_mm)};
  }
  const std::optional<pocket::StockBox> stock = options.stock_box();
  if (stock && !(stock->x0 < stock->x1 && stock->y0 < stock->y1)) {
    throw std::invalid_argument{
        "--stock: must be XMIN,YMIN,XMAX,YMAX in mm, the greater values last"};
  }
  const auto& clearing = strategy_options_of(options).pocket.clearing;
  const double widest_mm = pocket::widest_spiral_mm(clearing.tool_radius, clearing.corner_radius);
  if (options.strategy == pocket::Strategy::kSpiral && options.stepover_mm > widest_mm) {
    throw std::invalid_argument{
        fmt::format("--stepover {:g}: turns of a spiral are at most {:g} mm apart, half the tool "
                    "less the radius of corners",
                    options.stepover_mm,
                    widest_mm)};
  }
  if (options.stepover_mm > options.tool_mm) {
    throw std::invalid_argument{fmt::format(
        "--stepover {:g}: passes farther apart than the tool's {:g} mm leave stock between them",
        options.stepover_mm,
        options.tool_mm)};
  }
}

}  // namespace

void check_pocket_options(const CLI::App& command, const PocketCommandOptions& options) {
  check_sizes(options);
  const Refusals refusals{command};
  if (options.finish_mm == 0.0) refusals.of({"--wear"}, "a call without --finish", "add --finish");
  if (!options.holes.empty() && !options.plunges()) {
    refusals.of({"--holes"}, "this entry into the stock", "add --entry plunge");
  }
  if (options.rest_of_mm > 0.0) {
    refusals.of({"--finish"}, "--rest-of", "the passes of --rest-of already run along the walls");
    refusals.of({"--stock"}, "--rest-of", "mill open pockets with one tool");
  }
  if (!options.stock.empty()) {
    refusals.of({"--finish"}, "--stock", "open pockets have no separate passes along walls");
  }
  if (options.is_v_carving()) {
    return refusals.of(kOptionsOfClearing, "--v-angle", "leave it out");
  }
  if (options.strategy != pocket::Strategy::kContour) {
    refusals.of({"--rest-of"}, "this strategy", "rests are milled by --strategy contour");
  }
  switch (options.strategy) {
    case pocket::Strategy::kAdaptive:
      return refusals.of({"--stepover", "--corner", "--conventional"},
                         "--strategy adaptive",
                         "--engagement limits the cut");
    case pocket::Strategy::kZigzag:
      refusals.of({"--conventional"}, "--strategy zigzag", "lines run in both directions");
      break;
    case pocket::Strategy::kPaper:
      refusals.of(
          {"--stepover", "--corner", "--entry", "--slope", "--conventional", "--finish", "--stock"},
          "--strategy paper",
          "that strategy follows the paper exactly");
      break;
    case pocket::Strategy::kContour:
    case pocket::Strategy::kSpiral:
      break;
  }
  refusals.of({"--engagement", "--keep-feed"}, "this strategy", "add --strategy adaptive");
}

std::vector<LayerDepth> layer_depths_of(const PocketCommandOptions& options,
                                        const std::vector<ContourPart>& parts) {
  std::set<drawing::Layer> layers;
  for (const ContourPart& part : parts) layers.insert(part.layers.begin(), part.layers.end());
  std::vector<LayerDepth> depths;
  for (const std::string& text : options.depths_of) {
    const LayerDepth depth = parse_layer_depth(text);
    if (std::ranges::none_of(layers, [&](const auto& layer) { return depth.is_of(layer); })) {
      refuse_layer(depth, layers);
    }
    depths.push_back(depth);
  }
  return depths;
}

}  // namespace sim
