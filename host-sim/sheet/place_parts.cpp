#include "host-sim/sheet/place_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "host-sim/import/piece.hpp"
#include "host-sim/report/printable.hpp"

namespace sim::sheet {
namespace {

using drawing::Drawing;
using drawing::Fault;
using drawing::FaultKind;
using drawing::Piece;
using drawing::Shape;

/// Returns the unit direction of an angle, which is exact for quarter turns.
Place exact_direction(double angle_deg) {
  const double quarters = angle_deg / 90.0;
  if (quarters != std::floor(quarters)) {
    return drawing::direction(angle_deg * std::numbers::pi / 180.0);
  }
  const auto quarter = static_cast<int>(quarters - 4.0 * std::floor(quarters / 4.0));
  const Place along_x{quarter == 0 ? 1.0 : -1.0, 0.0};
  const Place along_y{0.0, quarter == 1 ? 1.0 : -1.0};
  return quarter % 2 == 0 ? along_x : along_y;
}

std::string label_of(const SheetPart& part, std::size_t copy) {
  return part.places.size() == 1 ? part.name : fmt::format("{} #{}", part.name, copy + 1);
}

/// Makes one drawing from the copies of all parts of a sheet.
class PartPlacer {
 public:
  PartPlacer(const Sheet& sheet, const ReadText& read_text, const drawing::ImportOptions& options)
      : sheet_{sheet},
        read_text_{read_text},
        options_{options},
        sketch_{options.effort, options.text} {
    for (const Fault& fault : sheet.faults) sketch_.report(fault);
  }

  Drawing place() && {
    for (const SheetPart& part : sheet_.parts) {
      const Drawing* const drawn = drawing_of(part);
      if (drawn == nullptr) continue;
      const std::vector<std::size_t> layers = layers_of(*drawn);
      report_faults(part, *drawn, layers);
      if (!take_shapes(part, *drawn)) break;
      for (std::size_t copy = 0; copy < part.places.size(); ++copy) {
        turns_.push_back(sheet_.locked ? turns_.size() : part.turn);
        add(*drawn, layers, label_of(part, copy), transform_of(part.places[copy]));
      }
    }
    nest(sketch_, pieces_);
    sketch_.finish();
    Drawing all;
    all.file = sheet_.file;
    all.stock = sheet_.stock;
    all.parts = std::move(labels_);
    if (has_order()) all.turns = {std::move(turns_), sheet_.locked};
    all.layers = std::move(sketch_.layers());
    all.contours.reserve(pieces_.size());
    for (Piece& piece : pieces_) all.contours.push_back(std::move(piece.contour));
    all.faults = std::move(sketch_.faults());
    all.more_faults = sketch_.more_faults();
    all.more_lines = sketch_.more_lines();
    return all;
  }

 private:
  [[nodiscard]] bool has_order() const {
    const auto waits = [](const SheetPart& part) { return !part.after.empty(); };
    return sheet_.locked || std::ranges::any_of(sheet_.parts, waits);
  }

  /// Returns the drawing of a part. Reads each file once. Returns null and reports a fault if the
  /// file cannot be read or is a sheet itself.
  const Drawing* drawing_of(const SheetPart& part) {
    const std::string file = resolved(sheet_, part.drawing);
    const auto known = drawings_.find(file);
    if (known != drawings_.end()) return &known->second;
    const auto refuse = [&](std::string reason, std::string remedy) {
      sketch_.report({FaultKind::kUnreadable,
                      {.name = fmt::format("{}: part \"{}\"", part.pointer, part.name)},
                      {},
                      std::move(reason),
                      std::move(remedy)});
    };
    std::string text;
    try {
      text = read_text_(file);
    } catch (const std::exception& error) {
      refuse(error.what(), "name a drawing by its path from the sheet file");
      return nullptr;
    }
    if (is_sheet(text)) {
      refuse(fmt::format("{} is a sheet, too", printable(file)), "list its parts here");
      return nullptr;
    }
    return &drawings_.emplace(file, read_drawing(file, text, options_)).first->second;
  }

  std::vector<std::size_t> layers_of(const Drawing& drawn) {
    std::vector<std::size_t> layers;
    for (const drawing::Layer& layer : drawn.layers) layers.push_back(sketch_.layer(layer));
    return layers;
  }

  /// Reports the faults of a part's drawing. Their positions are positions in the file of the
  /// drawing, not on the sheet.
  void report_faults(const SheetPart& part,
                     const Drawing& drawn,
                     const std::vector<std::size_t>& layers) {
    for (const Fault& fault : drawn.faults) {
      Fault told = fault;
      told.entity = {.name = fmt::format("part \"{}\"", part.name)};
      if (fault.entity.layer < layers.size()) told.entity.layer = layers[fault.entity.layer];
      told.place_mm.reset();
      Fault without_remedy = fault;
      without_remedy.remedy.clear();
      told.reason = to_string(without_remedy, drawn.file);
      sketch_.report(std::move(told));
    }
    if (drawn.more_faults == 0) return;
    sketch_.report({FaultKind::kTooMuch,
                    {.name = fmt::format("part \"{}\"", part.name)},
                    {},
                    fmt::format("{} has {} more faults", printable(drawn.file), drawn.more_faults),
                    "mend the drawing"});
  }

  bool take_shapes(const SheetPart& part, const Drawing& drawn) {
    std::size_t shapes = 0;
    for (const auto& contour : drawn.contours) shapes += contour.shapes.size();
    shapes_ += shapes * part.places.size();
    if (shapes_ <= sketch_.share_of(drawing::kMaxShapes)) return true;
    sketch_.report({FaultKind::kTooMuch,
                    {.name = fmt::format("{}: part \"{}\"", part.pointer, part.name)},
                    {},
                    "more lines and curves than can be cut; this and all later parts are left out",
                    "cut the sheet in several jobs"});
    return false;
  }

  void add(const Drawing& drawn,
           const std::vector<std::size_t>& layers,
           const std::string& label,
           const drawing::Transform& transform) {
    for (const drawing::DrawnContour& contour : drawn.contours) {
      Piece& piece = pieces_.emplace_back();
      for (const Shape& shape : contour.shapes) {
        piece.contour.shapes.push_back(transformed(shape, transform));
      }
      piece.contour.closed = contour.closed;
      piece.contour.entity = {.name = fmt::format("{}: {}", label, contour.entity.name),
                              .layer = layers[contour.entity.layer],
                              .part = labels_.size()};
      measure(piece);
    }
    labels_.push_back(label);
  }

  const Sheet& sheet_;
  const ReadText& read_text_;
  const drawing::ImportOptions& options_;
  drawing::Sketch sketch_;
  std::map<std::string, Drawing> drawings_;
  std::vector<Piece> pieces_;
  std::vector<std::string> labels_;
  std::vector<std::size_t> turns_;  ///< Rank of each copy, in the same order as `labels_`.
  std::size_t shapes_ = 0;
};

}  // namespace

std::string resolved(const Sheet& sheet, const std::string& drawing) {
  if (sheet.file == "-") return drawing;
  return (std::filesystem::path{sheet.file}.parent_path() / drawing).string();
}

drawing::Transform transform_of(const Placing& placing) {
  const Place x = exact_direction(placing.angle_deg);
  const Place y{-x.y(), x.x()};
  return {.x_axis = placing.mirror ? Place{-x} : x, .y_axis = y, .origin = placing.at_mm};
}

Drawing place_parts(const Sheet& sheet,
                    const ReadText& read_text,
                    const drawing::ImportOptions& options) {
  return PartPlacer{sheet, read_text, options}.place();
}

}  // namespace sim::sheet
