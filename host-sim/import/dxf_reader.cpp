#include "host-sim/import/dxf_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "host-sim/import/dxf_shapes.hpp"

namespace sim::drawing {
namespace {

// Blocks of blocks double at each level: without a bound, a page of text fills memory.
constexpr std::size_t kMostInstances = 500'000;
constexpr std::size_t kMostGroups = 8'000'000;
constexpr int kByBlock = 0;
constexpr int kByLayer = 256;
constexpr double kDegreeInRadians = kFullTurn / 360.0;

struct DxfLayer {
  std::string colour = "ACI 7";
  bool hidden = false;
};

struct DxfBlock {
  Place base{0.0, 0.0};
  DxfCursor body;  ///< Stands at the group 0 after BLOCK's.
};

/// What an INSERT hands down to the entities of its block.
struct Instance {
  Transform to_mm{};
  std::string layer{};   ///< For entities on layer 0.
  std::string colour{};  ///< For entities by block.
  std::size_t line = 0;
  std::size_t depth = 0;
};

/// Millimetres per unit of $INSUNITS; nothing where it says none.
std::optional<double> millimetres_per(int unit) {
  static constexpr std::array<double, 15> kUnits{0.0,
                                                 25.4,
                                                 304.8,
                                                 1609344.0,
                                                 1.0,
                                                 10.0,
                                                 1000.0,
                                                 1.0e6,
                                                 2.54e-5,
                                                 0.0254,
                                                 914.4,
                                                 1.0e-7,
                                                 1.0e-6,
                                                 1.0e-3,
                                                 100.0};
  if (unit <= 0 || unit >= static_cast<int>(kUnits.size())) return {};
  return kUnits[static_cast<std::size_t>(unit)];
}

bool is_text(std::string_view type) {
  return type == "TEXT" || type == "MTEXT" || type == "ATTRIB";
}

class DxfReader {
 public:
  DxfReader(const std::string& text, Sketch& sketch)
      : cursor_{text}, sketch_{sketch}, most_instances_{sketch.share_of(kMostInstances)} {}

  void read() {
    next(cursor_);
    bool any = false;
    while (group_) {
      if (group_->code == 0 && group_->value == "EOF") return finish(any);
      if (group_->code != 0 || group_->value != "SECTION") {
        next(cursor_);
        continue;
      }
      next(cursor_);
      const std::string_view name = group_ ? group_->value : std::string_view{};
      any = true;
      next(cursor_);
      read_section(name);
    }
    if (!cursor_.bad_code().empty()) {
      sketch_.refuse(cursor_.line(),
                     0,
                     fmt::format("`{:.40}` is no group code", cursor_.bad_code()),
                     "save the drawing again as DXF in ASCII");
    } else {
      sketch_.refuse(
          cursor_.line(), 0, "the file ends without EOF", "it was cut off; copy or save it again");
    }
  }

 private:
  void finish(bool any) {
    if (!any) sketch_.refuse(1, 0, "no section of a DXF file", "save the drawing again as DXF");
  }

  void next(DxfCursor& cursor) { group_ = cursor.next(); }
  [[nodiscard]] bool at(std::string_view keyword) const {
    return group_ && group_->code == 0 && group_->value == keyword;
  }

  /// The entity whose group 0 was read last; then the group 0 after it.
  DxfEntity take_entity(DxfCursor& cursor) {
    DxfEntity entity;
    entity.type = group_->value;
    entity.line = group_->line;
    for (next(cursor); group_ && group_->code != 0; next(cursor)) {
      if (entity.groups.size() < kMostGroups) entity.groups.push_back(*group_);
    }
    return entity;
  }

  void read_section(std::string_view name) {
    if (name == "HEADER") read_header();
    while (group_ && !at("ENDSEC") && !at("EOF")) {
      // NOLINTNEXTLINE(bugprone-branch-clone): what nobody reads is passed over twice.
      if (group_->code != 0) {
        next(cursor_);
      } else if (name == "TABLES" && group_->value == "LAYER") {
        add_layer(take_entity(cursor_));
      } else if (name == "BLOCKS" && group_->value == "BLOCK") {
        add_block();
      } else if (name == "ENTITIES") {
        read_entity(cursor_, whole_drawing());
      } else {
        next(cursor_);
      }
    }
  }

  void read_header() {
    std::string_view variable;
    for (; group_ && group_->code != 0; next(cursor_)) {
      if (group_->code == 9) variable = group_->value;
      if (variable != "$INSUNITS" || group_->code != 70) continue;
      const auto unit = dxf_number(group_->value);
      const auto mm =
          unit ? millimetres_per(static_cast<int>(std::clamp(*unit, -1.0, 1.0e3))) : std::nullopt;
      if (mm) mm_per_unit_ = *mm;
      has_units_ = mm.has_value();
    }
  }

  Instance whole_drawing() {
    if (!has_units_) {
      sketch_.ignore("$INSUNITS names no unit: taken as mm", {}, "set the unit in the drawing");
      has_units_ = true;
    }
    return {.to_mm = scaled_by(mm_per_unit_, mm_per_unit_), .layer = "0", .colour = "ACI 7"};
  }

  void add_layer(const DxfEntity& entity) {
    constexpr int kFrozen = 1;
    const int colour = entity.whole(62, 7);
    DxfLayer layer{.colour = fmt::format("ACI {}", std::abs(colour)),
                   .hidden = colour < 0 || (entity.whole(70, 0) & kFrozen) != 0};
    if (const auto rgb = entity.number(420)) layer.colour = hex(*rgb);
    layers_.insert_or_assign(std::string{entity.text(2)}, std::move(layer));
  }

  static std::string hex(double rgb) {
    return fmt::format("#{:06x}", static_cast<unsigned>(std::clamp(rgb, 0.0, 16777215.0)));
  }

  void add_block() {
    const DxfEntity head = take_before(cursor_);
    blocks_.insert_or_assign(std::string{head.text(2)}, DxfBlock{head.place(10), before_});
    while (group_ && !at("ENDBLK") && !at("ENDSEC") && !at("EOF")) next(cursor_);
  }

  /// As take_entity, and keeps the cursor that reads the group 0 after it again.
  DxfEntity take_before(DxfCursor& cursor) {
    DxfEntity entity;
    entity.type = group_->value;
    entity.line = group_->line;
    before_ = cursor;
    for (next(cursor); group_ && group_->code != 0; next(cursor)) {
      if (entity.groups.size() < kMostGroups) entity.groups.push_back(*group_);
      before_ = cursor;
    }
    return entity;
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_entity(DxfCursor& cursor, const Instance& within) {
    const DxfEntity entity = take_entity(cursor);
    if (!count(entity)) return;
    std::vector<DxfEntity> vertices;
    if (entity.type == "POLYLINE") {
      while (at("VERTEX") && vertices.size() < kMostShapes) vertices.push_back(take_entity(cursor));
    }
    if (entity.type == "SEQEND" || entity.type == "ATTDEF") return;
    if (entity.whole(67, 0) == 1 || entity.whole(60, 0) == 1) {
      return sketch_.ignore("entities of the paper or invisible", described(entity, within));
    }
    if (hidden(entity, within)) {
      return sketch_.ignore(fmt::format("layer {:.60} is off or frozen", entity.text(8)),
                            described(entity, within));
    }
    read_visible(entity, vertices, within);
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_visible(const DxfEntity& entity,
                    const std::vector<DxfEntity>& vertices,
                    const Instance& within) {
    if (const DxfGroup* const bad = bad_number(entity, vertices)) {
      return refuse(
          entity, within, fmt::format("line {}: `{:.40}` is no number", bad->line, bad->value));
    }
    if (is_dxf_shape(entity.type)) {
      add(entity, within, dxf_shapes(entity));
    } else if (entity.type == "POLYLINE") {
      add(entity, within, old_polyline(entity, vertices));
    } else if (entity.type == "INSERT") {
      insert(entity, within);
    } else if (is_text(entity.type)) {
      Entity named = described(entity, within);
      named.layer = sketch_.layer(layer_of(entity, within));
      sketch_.report({FaultKind::kText,
                      std::move(named),
                      {},
                      "letters are no paths",
                      "convert text to polylines in the drawing program (TXTEXP)"});
    } else {
      sketch_.ignore(fmt::format("{:.40} is nothing to cut", entity.type),
                     described(entity, within));
    }
  }

  static const DxfGroup* bad_number(const DxfEntity& entity,
                                    const std::vector<DxfEntity>& vertices) {
    const DxfGroup* bad = entity.bad_number();
    for (std::size_t i = 0; i < vertices.size() && bad == nullptr; ++i) {
      bad = vertices[i].bad_number();
    }
    return bad;
  }

  /// POLYLINE: its corners are entities of their own.
  static DxfShapes old_polyline(const DxfEntity& entity, const std::vector<DxfEntity>& vertices) {
    constexpr int kClosed = 1;
    constexpr int kMesh = 16 | 64;
    constexpr int kFrame = 16;
    const int flags = entity.whole(70, 0);
    if ((flags & kMesh) != 0) return {{}, "it is a mesh"};
    const auto plane = dxf_plane(entity);
    if (!plane) return {{}, "it lies in a tilted plane"};
    std::vector<BulgeVertex> corners;
    for (const DxfEntity& vertex : vertices) {
      if ((vertex.whole(70, 0) & kFrame) != 0) continue;
      corners.push_back({vertex.place(10), vertex.number(42, 0.0)});
    }
    std::vector<Shape> shapes = bulge_edges(corners, (flags & kClosed) != 0);
    for (Shape& shape : shapes) shape = transformed(shape, *plane);
    return {std::move(shapes), {}};
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void insert(const DxfEntity& entity, const Instance& within) {
    const auto block = blocks_.find(entity.text(2));
    if (block == blocks_.end()) {
      return refuse(entity, within, fmt::format("there is no block `{:.60}`", entity.text(2)));
    }
    if (std::ranges::find(open_, &block->second) != open_.end()) {
      return refuse(entity, within, fmt::format("block `{:.60}` inserts itself", entity.text(2)));
    }
    if (within.depth >= kDeepestNesting) {
      return refuse(entity, within, fmt::format("nested deeper than {} blocks", kDeepestNesting));
    }
    const auto plane = dxf_plane(entity);
    if (!plane) return refuse(entity, within, "it lies in a tilted plane");
    const Layer layer = layer_of(entity, within);
    Instance instance{.layer = layer.name,
                      .colour = layer.colour,
                      .line = within.line != 0 ? within.line : entity.line,
                      .depth = within.depth + 1};
    const Transform frame = within.to_mm * *plane * moved_by(entity.place(10)) *
                            turned_by(entity.number(50, 0.0) * kDegreeInRadians);
    const Transform inner =
        scaled_by(entity.number(41, 1.0), entity.number(42, 1.0)) * moved_by(-block->second.base);
    const InsertArray array = insert_array(entity);
    if (array.left_out > 0) left_out(entity, within, array.left_out);
    open_.push_back(&block->second);
    for (std::size_t copy = 0; copy < array.columns * array.rows; ++copy) {
      instance.to_mm = frame * moved_by(array.step(copy)) * inner;
      if (!count(entity) || sketch_.full()) break;
      expand(block->second, instance);
    }
    open_.pop_back();
  }

  void left_out(const DxfEntity& entity, const Instance& within, std::size_t copies) {
    sketch_.report({FaultKind::kDuplicate,
                    described(entity, within),
                    {},
                    fmt::format("{} of its copies have no spacing and lie on others", copies),
                    "they are left out; set the spacing, or one row and column"});
  }

  /// One more is drawn. False, and told once, where there are too many.
  bool count(const DxfEntity& entity) {
    if (++instances_ <= most_instances_) return true;
    if (instances_ == most_instances_ + 1) too_many(entity);
    return false;
  }

  /// One copy of a block.
  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void expand(const DxfBlock& block, const Instance& instance) {
    const auto kept = group_;
    DxfCursor cursor = block.body;
    next(cursor);
    while (group_ && !at("ENDBLK") && !at("ENDSEC") && !at("EOF") &&
           instances_ <= most_instances_ && !sketch_.full()) {
      if (group_->code == 0) {
        read_entity(cursor, instance);
      } else {
        next(cursor);
      }
    }
    group_ = kept;
  }

  [[nodiscard]] Layer layer_of(const DxfEntity& entity, const Instance& within) const {
    Layer layer{.name = std::string{entity.text(8)}, .colour = within.colour};
    if (layer.name.empty() || layer.name == "0") layer.name = within.layer;
    const int index = entity.whole(62, kByLayer);
    const auto known = layers_.find(layer.name);
    if (const auto rgb = entity.number(420)) {
      layer.colour = hex(*rgb);
    } else if (index == kByLayer) {
      layer.colour = known != layers_.end() ? known->second.colour : "ACI 7";
    } else if (index != kByBlock) {
      layer.colour = fmt::format("ACI {}", std::abs(index));
    }
    return layer;
  }

  [[nodiscard]] bool hidden(const DxfEntity& entity, const Instance& within) const {
    const std::string_view own = entity.text(8);
    const auto layer = layers_.find(own == "0" || own.empty() ? within.layer : own);
    return layer != layers_.end() && layer->second.hidden;
  }

  [[nodiscard]] static Entity described(const DxfEntity& entity, const Instance& within) {
    std::string name = fmt::format("{:.40}", entity.type);
    if (!entity.text(5).empty()) name += fmt::format(" {:.40}", entity.text(5));
    if (within.line != 0) name += fmt::format(" of the INSERT of line {}", within.line);
    return {.name = std::move(name), .line = entity.line};
  }

  void refuse(const DxfEntity& entity, const Instance& within, std::string reason) {
    sketch_.report({FaultKind::kBadEntity,
                    described(entity, within),
                    {},
                    std::move(reason),
                    "it is left out; mend it in the drawing"});
  }

  void too_many(const DxfEntity& entity) {
    sketch_.report(
        {FaultKind::kTooMuch,
         described(entity, {}),
         {},
         fmt::format("more than {} entities are drawn; the rest is left out", most_instances_),
         "cut the drawing in parts"});
  }

  void add(const DxfEntity& entity, const Instance& within, DxfShapes drawn) {
    if (!drawn.wrong.empty()) return refuse(entity, within, drawn.wrong);
    Entity named = described(entity, within);
    named.layer = sketch_.layer(layer_of(entity, within));
    for (Shape& shape : drawn.shapes) shape = transformed(shape, within.to_mm);
    static_cast<void>(sketch_.add({std::move(drawn.shapes), sketch_.add_entity(std::move(named))}));
  }

  DxfCursor cursor_;
  DxfCursor before_{{}};
  Sketch& sketch_;
  std::size_t most_instances_;
  std::optional<DxfGroup> group_;
  std::map<std::string, DxfLayer, std::less<>> layers_;
  std::map<std::string, DxfBlock, std::less<>> blocks_;
  std::vector<const DxfBlock*> open_;
  double mm_per_unit_ = 1.0;
  bool has_units_ = false;
  std::size_t instances_ = 0;
};

}  // namespace

void read_dxf(const std::string& text, Sketch& sketch) { DxfReader{text, sketch}.read(); }

}  // namespace sim::drawing
