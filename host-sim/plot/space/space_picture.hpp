#pragma once

#include <string>
#include <vector>

#include "host-sim/plot/picture_key.hpp"
#include "host-sim/plot/space/axonometry.hpp"
#include "host-sim/plot/space/hidden_lines.hpp"
#include "host-sim/surface/mesh.hpp"

namespace sim {

/// Lines of one kind in space.
struct SpaceLines {
  KeySample sample;  ///< How they are drawn; without a label they have no entry in the key.
  std::vector<SpaceLine> lines;
};

/// A surface with lines over it, in mm.
struct SpaceScene {
  std::string title{};
  std::string subtitle{};
  surface::Mesh mesh{};
  std::vector<Colour> colours{};  ///< One for each point of the mesh; empty: all light grey.
  std::vector<SpaceLines> lines{};
  PictureKey key{};  ///< Samples of lines are added to it.
};

/// Returns an axonometric picture as an SVG document: the shaded surface within a box whose axes
/// have scales in mm, lines where the surface does not hide them, title and key. Surfaces that are
/// flat for their size are drawn with their heights stretched by a round factor, which the key
/// states. The surface is an image within the document; all else is lines and text.
/// Throws std::runtime_error naming `file` if it cannot be drawn. @pre the mesh has a facet
[[nodiscard]] std::string draw_space(const std::string& file,
                                     SpaceScene scene,
                                     const Viewpoint& viewpoint);

/// Returns colours of heights, from dark to light, of each point of a mesh, and adds their scale to
/// a key.
[[nodiscard]] std::vector<Colour> height_colours(const surface::Mesh& mesh, PictureKey& key);

}  // namespace sim
