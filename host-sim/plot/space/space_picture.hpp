#pragma once

#include <string>
#include <vector>

#include "host-sim/plot/picture_key.hpp"
#include "host-sim/plot/space/axonometry.hpp"
#include "host-sim/plot/space/hidden_lines.hpp"
#include "host-sim/surface/mesh.hpp"

namespace sim {

/// Lines in space that have the same meaning and style.
struct SpaceLines {
  /// Style and label of the lines. Lines without a label have no entry in the key.
  KeySample sample;
  std::vector<SpaceLine> lines;
};

/// The content of an axonometric picture: a surface with lines over it, in mm.
struct SpaceScene {
  std::string title{};
  std::string subtitle{};
  surface::Mesh mesh{};
  /// Colour of each point of the mesh. If empty, all points are light grey.
  std::vector<Colour> colours{};
  std::vector<SpaceLines> lines{};
  PictureKey key{};  ///< Key of the picture, to which the samples of the lines are added.
};

/// Returns an axonometric picture as an SVG document. It shows the shaded surface within a box
/// whose axes have scales in mm, and the lines where the surface does not hide them. It has a title
/// and a key. If the surface is flat compared with its size, its heights are multiplied by a round
/// factor, which the key states. The surface is an image within the document; the other content is
/// lines and texts. Throws std::runtime_error, with the name `file`, if the surface cannot be
/// drawn.
/// @pre the mesh has a facet
[[nodiscard]] std::string draw_space(const std::string& file,
                                     SpaceScene scene,
                                     const Viewpoint& viewpoint);

/// Returns the colour of each point of a mesh by its height, from dark (low) to light (high). Adds
/// the scale of these colours to a key.
[[nodiscard]] std::vector<Colour> height_colours(const surface::Mesh& mesh, PictureKey& key);

}  // namespace sim
