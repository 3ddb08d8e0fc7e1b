#pragma once

#include <string>
#include <vector>

#include "host-sim/import/clip_region.hpp"
#include "host-sim/import/dxf_group.hpp"
#include "host-sim/import/dxf_shapes.hpp"
#include "host-sim/import/dxf_tables.hpp"
#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Properties that an INSERT passes on to the entities of its block.
struct DxfInstance {
  Transform to_mm{};
  std::string layer{};      ///< Layer of entities that are on layer 0.
  std::string colour{};     ///< Colour of entities with the colour BYBLOCK.
  std::string line_type{};  ///< Line type of entities with the line type BYBLOCK.
  std::size_t line = 0;
  std::size_t depth = 0;
  ClipRegions clips{};  ///< Boundaries of this INSERT and of the INSERTs around it.
};

/// Adds entities to the sketch, on their layers, with notes and faults about them.
class DxfDrawer {
 public:
  explicit DxfDrawer(Sketch& sketch)
      : sketch_{sketch}, comparison_{sketch.share_of(kMaxClipSteps)} {}

  [[nodiscard]] DxfTables& tables() { return tables_; }

  /// Returns why an entity is not visible; empty if it is visible. A layer that is off does not
  /// hide the entities that an INSERT on it brings on other layers; a frozen layer hides them.
  [[nodiscard]] std::string hidden(const DxfEntity& entity, const DxfInstance& within) const;

  /// Returns an entity as messages name it, and with its layer.
  [[nodiscard]] Entity described(const DxfEntity& entity, const DxfInstance& within);
  [[nodiscard]] Layer layer_of(const DxfEntity& entity, const DxfInstance& within) const;
  /// Returns the line type of an entity after BYLAYER and BYBLOCK are resolved.
  [[nodiscard]] std::string line_type_of(const DxfEntity& entity, const DxfInstance& within) const;

  /// Adds the shapes of an entity as chains of curves that meet, or reports why there are none.
  void add(const DxfEntity& entity, const DxfInstance& within, DxfShapes drawn);
  /// Draws letters in the text mode of the sketch.
  /// @pre is_dxf_text(entity.type)
  void add_text(const DxfEntity& entity, const DxfInstance& within);
  /// Reports that an entity is left out because it has nothing to cut, or because its type is not
  /// read.
  void leave_out(const DxfEntity& entity, const DxfInstance& within);
  void refuse(const DxfEntity& entity,
              const DxfInstance& within,
              std::string reason,
              std::string remedy = "it is left out; mend it in the drawing");

 private:
  [[nodiscard]] bool is_visible(const std::vector<Shape>& row,
                                const Entity& named,
                                const ClipRegions& clips);
  void note_style(const DxfEntity& entity, const DxfStyle& style, const Entity& named);
  [[nodiscard]] DxfLayer layer_record(const DxfEntity& entity, const DxfInstance& within) const;

  Sketch& sketch_;
  DxfTables tables_;
  ClipComparison comparison_;
};

}  // namespace sim::drawing
