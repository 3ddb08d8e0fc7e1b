#pragma once

#include <string>
#include <vector>

#include "host-sim/import/clip_region.hpp"
#include "host-sim/import/dxf_group.hpp"
#include "host-sim/import/dxf_shapes.hpp"
#include "host-sim/import/dxf_tables.hpp"
#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Properties that an INSERT hands down to the entities of its block.
struct DxfInstance {
  Transform to_mm{};
  std::string layer{};      ///< For entities on layer 0.
  std::string colour{};     ///< For entities by block.
  std::string line_type{};  ///< The same.
  std::size_t line = 0;
  std::size_t depth = 0;
  ClipRegions clips{};  ///< Boundaries of it and of those around it.
};

/// Puts entities into the sketch, on their layers, with what is to be said of them.
class DxfDrawer {
 public:
  explicit DxfDrawer(Sketch& sketch)
      : sketch_{sketch}, comparison_{sketch.share_of(kMostClipSteps)} {}

  [[nodiscard]] DxfTables& tables() { return tables_; }

  /// Returns why an entity is not seen; empty where it is. Layers that are off do not hide what
  /// an INSERT on them brings on other layers.
  [[nodiscard]] std::string hidden(const DxfEntity& entity, const DxfInstance& within) const;

  /// Returns an entity as messages name it, with its layer.
  [[nodiscard]] Entity described(const DxfEntity& entity, const DxfInstance& within);
  [[nodiscard]] Layer layer_of(const DxfEntity& entity, const DxfInstance& within) const;
  /// Returns the line type that an entity has in the end.
  [[nodiscard]] std::string line_type_of(const DxfEntity& entity, const DxfInstance& within) const;

  /// Adds what was read of an entity, in chains of curves that meet, or says what is wrong.
  void add(const DxfEntity& entity, const DxfInstance& within, DxfShapes drawn);
  /// Draws letters as the sketch wishes them. @pre is_dxf_text(entity.type)
  void add_text(const DxfEntity& entity, const DxfInstance& within);
  /// Says that an entity is left out that has nothing to cut, or that is not read.
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
