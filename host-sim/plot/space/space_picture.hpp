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
  KeySample sample;  ///< Style of the lines; without a label they have no entry in the key.
  std::vector<SpaceLine> lines;
};

/// A surface with lines over it, in mm.
struct SpaceScene {
  std::string title{};
  std::string subtitle{};
  surface::Mesh mesh{};
  std::vector<Colour> colours{};  ///< One for each point of the mesh; empty: all points light grey.
  std::vector<SpaceLines> lines{};
  PictureKey key{};  ///< Key of the picture, to which the samples of the lines are added.
};

/// Returns an axonometric picture as an SVG document: the shaded surface within a box whose axes
/// have scales in mm, lines where the surface does not hide them, title and key. A surface that is
/// flat for its size is drawn with its heights stretched by a round factor, which the key states.
/// The surface is an image within the document; all else is lines and text.
/// Throws std::runtime_error naming `file` if the surface cannot be drawn.
/// @pre the mesh has a facet
[[nodiscard]] std::string draw_space(const std::string& file,
                                     SpaceScene scene,
                                     const Viewpoint& viewpoint);

/// Returns a colour for the height of each point of a mesh, from dark to light, and adds the scale
/// of these colours to a key.
[[nodiscard]] std::vector<Colour> height_colours(const surface::Mesh& mesh, PictureKey& key);

}  // namespace sim
