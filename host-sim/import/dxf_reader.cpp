#include "host-sim/import/dxf_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "host-sim/import/dxf_binary.hpp"
#include "host-sim/import/dxf_clips.hpp"
#include "host-sim/import/dxf_drawer.hpp"
#include "host-sim/import/dxf_letters.hpp"
#include "host-sim/import/dxf_polyline.hpp"
#include "host-sim/import/dxf_text.hpp"

namespace sim::drawing {
namespace {

// Nested blocks may double the number of instances at each level. Without a bound, a file of one
// page could fill the memory.
constexpr std::size_t kMaxInstances = 500'000;
constexpr std::size_t kMaxGroups = 8'000'000;
constexpr double kDegreeInRadians = kFullTurn / 360.0;

struct DxfBlock {
  Place base{0.0, 0.0};
  bool is_external = false;  ///< True if the entities of the block are in another file.
  DxfCursor body;  ///< Cursor at the first group 0 after the group 0 that begins the BLOCK.
};

class DxfReader {
 public:
  DxfReader(const std::string& text, Sketch& sketch, std::optional<double> mm_per_unit)
      : cursor_{text},
        sketch_{sketch},
        drawer_{sketch},
        clips_{dxf_clips(text)},
        wanted_mm_per_unit_{mm_per_unit},
        max_instances_{sketch.share_of(kMaxInstances)} {}

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

  [[nodiscard]] double mm_per_unit() const {
    return wanted_mm_per_unit_.value_or(header_.mm_per_unit.value_or(1.0));
  }

 private:
  void finish(bool any) {
    if (any) return;
    sketch_.refuse(1, 0, "the file has no section of a DXF file", "save the drawing again as DXF");
  }

  void next(DxfCursor& cursor) { group_ = cursor.next(); }
  [[nodiscard]] bool at(std::string_view keyword) const {
    return group_ && group_->code == 0 && group_->value == keyword;
  }
  [[nodiscard]] bool at_end(std::string_view keyword) const {
    return !group_ || at(keyword) || at("ENDSEC") || at("EOF");
  }

  /// Returns the entity whose group 0 was read last. Reads the file up to and including the next
  /// group 0.
  DxfEntity take_entity(DxfCursor& cursor) {
    DxfEntity entity;
    entity.type = group_->value;
    entity.line = group_->line;
    before_ = cursor;
    for (next(cursor); group_ && group_->code != 0; next(cursor)) {
      if (entity.groups.size() < kMaxGroups) entity.groups.push_back(*group_);
      before_ = cursor;
    }
    return entity;
  }

  void read_section(std::string_view name) {
    if (name == "HEADER") read_header();
    while (!at_end("ENDSEC")) {
      // NOLINTNEXTLINE(bugprone-branch-clone): the first and the last branch both skip a group.
      if (group_->code != 0) {
        next(cursor_);
      } else if (name == "TABLES") {
        read_record();
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
      header_.take(variable, *group_);
    }
  }

  void read_record() {
    const DxfEntity record = take_entity(cursor_);
    if (record.type == "LAYER") drawer_.tables().add_layer(record);
    if (record.type == "STYLE") drawer_.tables().add_style(record);
    if (record.type == "LTYPE") drawer_.tables().add_line_type(record);
  }

  DxfInstance whole_drawing() {
    if (!wanted_mm_per_unit_ && !header_.mm_per_unit && !told_units_) {
      sketch_.note(fmt::format("$INSUNITS names no unit: mm is assumed{}",
                               header_.is_english ? ", though $MEASUREMENT says English" : ""),
                   {},
                   "if the unit is a different one, set it with --drawing-unit");
      told_units_ = true;
    }
    return {.to_mm = scaled_by(mm_per_unit(), mm_per_unit()), .layer = "0", .colour = "ACI 7"};
  }

  void add_block() {
    constexpr int kExternal = 4;
    const DxfEntity head = take_entity(cursor_);
    const bool is_external = (head.whole(70, 0) & kExternal) != 0;
    blocks_.insert_or_assign(dxf_key(head.text(2)), DxfBlock{head.place(10), is_external, before_});
    while (!at_end("ENDBLK")) next(cursor_);
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_entity(DxfCursor& cursor, const DxfInstance& within) {
    const DxfEntity entity = take_entity(cursor);
    if (!count(entity)) return;
    std::vector<DxfEntity> vertices;
    if (entity.type == "POLYLINE") {
      while (at("VERTEX") && vertices.size() < kMaxShapes) vertices.push_back(take_entity(cursor));
    }
    // An ATTDEF, which is a template for the attributes of an INSERT, is visible only outside of
    // blocks.
    if (entity.type == "SEQEND" || (entity.type == "ATTDEF" && within.depth != 0)) return;
    const std::string hidden = drawer_.hidden(entity, within);
    if (!hidden.empty()) return sketch_.ignore(hidden, drawer_.described(entity, within));
    read_visible(entity, vertices, within);
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_visible(const DxfEntity& entity,
                    const std::vector<DxfEntity>& vertices,
                    const DxfInstance& within) {
    if (const DxfGroup* const bad = bad_number(entity, vertices)) {
      drawer_.refuse(
          entity, within, fmt::format("line {}: `{:.40}` is no number", bad->line, bad->value));
    } else if (is_dxf_shape(entity.type)) {
      drawer_.add(entity, within, dxf_shapes(entity));
    } else if (entity.type == "POLYLINE") {
      drawer_.add(entity, within, old_polyline(entity, vertices));
    } else if (is_dxf_text(entity.type) && sketch_.text() != TextMode::kSkip) {
      drawer_.add_text(entity, within);
    } else if (entity.type == "INSERT") {
      insert(entity, within);
    } else {
      drawer_.leave_out(entity, within);
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

  /// Returns the reason why an INSERT is not drawn, and the remedy; both are empty if it is drawn.
  [[nodiscard]] std::pair<std::string, std::string> obstacle(const DxfEntity& entity,
                                                             const DxfBlock* block,
                                                             std::size_t depth) const {
    const std::string name = fmt::format("`{:.60}`", entity.text(2));
    constexpr const char* kMend = "it is left out; correct it in the drawing";
    if (block == nullptr) return {fmt::format("there is no block {}", name), kMend};
    if (block->is_external) {
      return {fmt::format("block {} is in another file", name),
              "it is left out; bind the external reference (XREF, Bind)"};
    }
    if (std::ranges::find(open_, block) != open_.end()) {
      return {fmt::format("block {} inserts itself", name), kMend};
    }
    if (depth >= kDeepestNesting) {
      return {fmt::format("it is nested deeper than {} blocks", kDeepestNesting), kMend};
    }
    const auto clip = clips_.find(entity.text(5));
    if (clip != clips_.end() && !clip->second.is_in_plan) {
      return {
          fmt::format("block {} is clipped (XCLIP) at a boundary that is not in the plan", name),
          "it is left out; explode it and trim it at the boundary, or delete the boundary"};
    }
    return {};
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void insert(const DxfEntity& entity, const DxfInstance& within) {
    const auto found = blocks_.find(dxf_key(entity.text(2)));
    const DxfBlock* const block = found == blocks_.end() ? nullptr : &found->second;
    const auto [reason, remedy] = obstacle(entity, block, within.depth);
    if (!reason.empty()) return drawer_.refuse(entity, within, reason, remedy);
    const auto plane = dxf_plane(entity, entity.number(30, 0.0));
    if (!plane) return drawer_.refuse(entity, within, kDxfUpright);
    const Entity named = drawer_.described(entity, within);
    if (plane->is_tilted) sketch_.note(fmt::format("INSERT {}", kDxfSeenFromAbove), named);
    const Layer layer = drawer_.layer_of(entity, within);
    DxfInstance instance{.layer = layer.name,
                         .colour = layer.colour,
                         .line_type = drawer_.line_type_of(entity, within),
                         .line = within.line != 0 ? within.line : entity.line,
                         .depth = within.depth + 1};
    const Transform frame = within.to_mm * plane->to_plan * moved_by(entity.place(10)) *
                            turned_by(entity.number(50, 0.0) * kDegreeInRadians);
    const Transform inner =
        scaled_by(entity.number(41, 1.0), entity.number(42, 1.0)) * moved_by(-block->base);
    const InsertArray array = insert_array(entity);
    if (array.left_out > 0) left_out(named, array.left_out);
    open_.push_back(block);
    const auto clip = clips_.find(entity.text(5));
    const bool is_clipped = clip != clips_.end();
    if (is_clipped && clip->second.has_depths) {
      sketch_.note("the boundary of a block (XCLIP) clips by height, too, which is ignored", named);
    }
    for (std::size_t copy = 0; copy < array.columns * array.rows; ++copy) {
      instance.to_mm = frame * moved_by(array.step(copy)) * inner;
      instance.clips = within.clips;
      if (is_clipped) {
        const ClipRegion region = region_of(clip->second, instance.to_mm, named.name);
        instance.clips.push_back(std::make_shared<const ClipRegion>(region));
      }
      if (!count(entity) || sketch_.full()) break;
      expand(*block, instance);
    }
    open_.pop_back();
  }

  void left_out(const Entity& entity, std::size_t copies) {
    sketch_.report({FaultKind::kDuplicate,
                    entity,
                    {},
                    fmt::format("{} of its copies have no spacing and lie on other copies", copies),
                    "they are left out; set the spacing, or use one row and one column"});
  }

  /// Counts one more entity that is drawn. Returns false if there are too many; reports a fault at
  /// the first entity beyond the limit.
  bool count(const DxfEntity& entity) {
    if (++instances_ <= max_instances_) return true;
    if (instances_ == max_instances_ + 1) too_many(entity);
    return false;
  }

  void too_many(const DxfEntity& entity) {
    sketch_.report(
        {FaultKind::kTooMuch,
         drawer_.described(entity, whole_drawing()),
         {},
         fmt::format("the drawing has more than {} entities; the rest is left out", max_instances_),
         "divide the drawing into several files"});
  }

  /// Draws one copy of a block.
  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void expand(const DxfBlock& block, const DxfInstance& instance) {
    const auto kept = group_;
    DxfCursor cursor = block.body;
    next(cursor);
    while (!at_end("ENDBLK") && instances_ <= max_instances_ && !sketch_.full()) {
      if (group_->code == 0) {
        read_entity(cursor, instance);
      } else {
        next(cursor);
      }
    }
    group_ = kept;
  }

  DxfCursor cursor_;
  DxfCursor before_{{}};
  Sketch& sketch_;
  DxfDrawer drawer_;
  DxfClips clips_;
  std::optional<double> wanted_mm_per_unit_;
  DxfHeader header_;
  std::size_t max_instances_;
  std::optional<DxfGroup> group_;
  std::map<std::string, DxfBlock, std::less<>> blocks_;
  std::vector<const DxfBlock*> open_;
  bool told_units_ = false;
  std::size_t instances_ = 0;
};

}  // namespace

double read_dxf(const std::string& text, Sketch& sketch, std::optional<double> mm_per_unit) {
  const std::string lines =
      utf8_of_dxf(is_binary_dxf(text) ? ascii_of_binary_dxf(text) : text, sketch);
  DxfReader reader{lines, sketch, mm_per_unit};
  reader.read();
  return reader.mm_per_unit();
}

}  // namespace sim::drawing
