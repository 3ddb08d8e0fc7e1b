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
  std::string layer{};      ///< Layer that entities on layer 0 of the block get.
  std::string colour{};     ///< Colour that entities with the colour BYBLOCK get.
  std::string line_type{};  ///< Line type that entities with the line type BYBLOCK get.
  std::size_t line = 0;
  std::size_t depth = 0;
  ClipRegions clips{};  ///< Boundaries of this INSERT and of the INSERTs around it.
};

/// Adds entities of a DXF file to the sketch, on their layers, with notes and faults about them.
class DxfDrawer {
 public:
  explicit DxfDrawer(Sketch& sketch)
      : sketch_{sketch}, comparison_{sketch.share_of(kMaxClipSteps)} {}

  [[nodiscard]] DxfTables& tables() { return tables_; }

  /// Returns the reason why an entity is not visible; empty if it is visible. If the layer of an
  /// INSERT is off, the entities of its block on other layers stay visible. If that layer is
  /// frozen, all of them are hidden.
  [[nodiscard]] std::string hidden(const DxfEntity& entity, const DxfInstance& within) const;

  /// Returns the name, position and layer of an entity.
  [[nodiscard]] Entity described(const DxfEntity& entity, const DxfInstance& within);
  [[nodiscard]] Layer layer_of(const DxfEntity& entity, const DxfInstance& within) const;
  /// Returns the line type of an entity, with BYLAYER and BYBLOCK replaced by the line types that
  /// they stand for.
  [[nodiscard]] std::string line_type_of(const DxfEntity& entity, const DxfInstance& within) const;

  /// Adds the shapes of an entity as chains, each of which is a row of connected curves. Reports
  /// the reason if there are no shapes.
  void add(const DxfEntity& entity, const DxfInstance& within, DxfShapes drawn);
  /// Draws letters in the text mode of the sketch.
  /// @pre is_dxf_text(entity.type)
  void add_text(const DxfEntity& entity, const DxfInstance& within);
  /// Reports that an entity is left out, because it contains nothing to cut or its type is not
  /// supported.
  void leave_out(const DxfEntity& entity, const DxfInstance& within);
  void refuse(const DxfEntity& entity,
              const DxfInstance& within,
              std::string reason,
              std::string remedy = "it is left out; correct it in the drawing");

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
