#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <vector>

#include "host-sim/import/outline_box.hpp"
#include "host-sim/import/svg_document.hpp"
#include "host-sim/import/svg_style.hpp"

namespace sim::drawing {

using SvgSubpaths = std::vector<std::vector<Shape>>;

/// Reads clip paths and the edges of viewports, and removes shapes that they hide.
class SvgClips {
 public:
  SvgClips(SvgDocument& document, Sketch& sketch);

  /// Adds the clip path that an element names to the clips that the element inherits.
  /// @param box box of the element in its own units, if the element is a shape
  void enter(const pugi::xml_node& node,
             const SvgProperties& properties,
             const std::optional<OutlineBox>& box,
             SvgStyle& style);
  /// Adds the edge of a viewport as a clip, unless `overflow` makes content beyond the edge
  /// visible. A corner of the viewport is at the origin of `style`.
  void enter_viewport(const pugi::xml_node& node, const Place& size, SvgStyle& style);

  /// Keeps the subpaths, in mm, that are within all clips of the style. Subpaths outside are
  /// removed with a note. A subpath that crosses an edge is a fault.
  void keep_visible(const pugi::xml_node& node, const SvgStyle& style, SvgSubpaths& subpaths);

 private:
  void add_paths(const pugi::xml_node& clip_path,
                 const Transform& to_mm,
                 SvgStyle style,
                 ClipRegion& clip);
  void add_path(pugi::xml_node child, const Transform& to_mm, SvgStyle style, ClipRegion& clip);
  [[nodiscard]] bool is_visible(const pugi::xml_node& node,
                                const SvgStyle& style,
                                const std::vector<Shape>& shapes);

  SvgDocument& document_;
  Sketch& sketch_;
  ClipComparison comparison_;
  std::size_t depth_ = 0;
};

/// Returns the transform of an element about its `transform-origin`; nothing if the transform
/// cannot be read.
[[nodiscard]] std::optional<Transform> svg_own_transform(const SvgProperties& properties,
                                                         const SvgViewport& viewport);

}  // namespace sim::drawing
