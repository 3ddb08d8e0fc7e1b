#include "host-sim/import/lbrn_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <pugixml.hpp>
#include <tuple>
#include <utility>

#include "host-sim/import/dxf_polyline.hpp"
#include "host-sim/import/lbrn_path.hpp"
#include "host-sim/import/lbrn_settings.hpp"
#include "host-sim/import/line_table.hpp"
#include "host-sim/import/scanner.hpp"
#include "host-sim/picture/base64.hpp"

namespace sim::drawing {
namespace {

// Bound on the work of reading a project. One unit of work is the reading of kBytesOfWork bytes of
// the lists of a shape. Many shapes may share one long list, so without a bound a file of one page
// could take hours. Each shape costs kWorkOfShape units in addition to its lists.
constexpr std::size_t kMaxLbrnWork = 20'000'000;
constexpr std::size_t kWorkOfShape = 32;
constexpr std::size_t kBytesOfWork = 16;
constexpr std::string_view kLbrnRoot = "LightBurnProject";
constexpr std::string_view kLbrnPicture = "Bitmap";

std::optional<double> lbrn_number(const pugi::xml_node& node, const char* name) {
  Scanner scanner{node.attribute(name).value()};
  const auto number = scanner.number();
  if (!number || !scanner.at_end()) return {};
  return number;
}

/// Returns the map that the XForm of a shape gives by six numbers; nothing if the XForm is broken,
/// the identity if the shape has none.
std::optional<Transform> lbrn_transform(const pugi::xml_node& shape) {
  const pugi::xml_node form = shape.child("XForm");
  if (!form) return Transform{};
  Scanner scanner{form.child_value()};
  std::array<double, 6> values{};
  for (double& value : values) {
    const auto number = scanner.number();
    if (!number) return {};
    value = *number;
  }
  if (!scanner.at_end()) return {};
  return Transform{
      .x_axis{values[0], values[1]}, .y_axis{values[2], values[3]}, .origin{values[4], values[5]}};
}

/// Returns a rectangle whose middle is the origin, with corners rounded by a radius.
/// @pre 2 r <= width, height
std::vector<Shape> rounded_rectangle(double width, double height, double radius) {
  const double x = 0.5 * width;
  const double y = 0.5 * height;
  if (radius <= 0.0) return bulge_edges({{{-x, -y}}, {{x, -y}}, {{x, y}}, {{-x, y}}}, true);
  const double bulge = std::tan(std::numbers::pi / 8.0);
  return bulge_edges({{{-x + radius, -y}},
                      {{x - radius, -y}, bulge},
                      {{x, -y + radius}},
                      {{x, y - radius}, bulge},
                      {{x - radius, y}},
                      {{-x + radius, y}, bulge},
                      {{-x, y - radius}},
                      {{-x, -y + radius}, bulge}},
                     true);
}

class LbrnReader {
 public:
  LbrnReader(const std::string& text, Sketch& sketch)
      : text_{text}, lines_{text}, sketch_{sketch}, left_{sketch.share_of(kMaxLbrnWork)} {}

  void read() {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text_.data(), text_.size());
    if (!parsed) {
      const auto [line, column] = lines_.at(static_cast<std::size_t>(parsed.offset));
      return sketch_.refuse(line,
                            column,
                            fmt::format("broken XML: {}", parsed.description()),
                            "save the project again");
    }
    const pugi::xml_node project = document.document_element();
    if (project.name() != kLbrnRoot) {
      return sketch_.refuse(1, 0, "it is no project of LightBurn", "save it again");
    }
    layers_ = lbrn_layers(project, LbrnUse::kLines);
    picture_layers_ = lbrn_layers(project, LbrnUse::kPictures);
    read_shapes(project, {.to_mm = origin_of(project)});
  }

 private:
  struct Within {
    Transform to_mm{};
    std::size_t depth = 0;
  };

  Transform origin_of(const pugi::xml_node& project) {
    const bool left = std::string_view{project.attribute("MirrorX").value()} == "True";
    const bool down = std::string_view{project.attribute("MirrorY").value()} == "True";
    if (left || down) {
      sketch_.note(fmt::format("the project's origin is at another corner: its {} is mirrored",
                               left ? (down ? "X and Y" : "X") : "Y"),
                   {},
                   "check that letters are not mirrored");
    }
    return scaled_by(left ? -1.0 : 1.0, down ? -1.0 : 1.0);
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_shapes(const pugi::xml_node& parent, const Within& within) {
    for (const pugi::xml_node& shape : parent.children("Shape")) {
      if (left_ == 0 || sketch_.full()) return;
      read_shape(shape, within);
      spend(kWorkOfShape);
      if (left_ == 0) too_many(shape);
    }
  }

  void spend(std::size_t work) { left_ -= std::min(left_, work); }

  void too_many(const pugi::xml_node& shape) {
    sketch_.report({FaultKind::kTooMuch,
                    entity_of(shape),
                    {},
                    "the project has more shapes than can be read; the rest is left out",
                    "divide the drawing into several files"});
  }

  [[nodiscard]] const LbrnLayer& layer_of(const pugi::xml_node& shape) {
    const double number = lbrn_number(shape, "CutIndex").value_or(0.0);
    const int index = std::abs(number) < 1.0e6 ? static_cast<int>(number) : -1;
    const bool is_picture = shape.attribute("Type").value() == kLbrnPicture;
    std::map<int, LbrnLayer>& layers = is_picture ? picture_layers_ : layers_;
    const auto found = layers.find(index);
    if (found != layers.end()) return found->second;
    return layers.emplace(index, lbrn_layer_without_settings(index)).first->second;
  }

  Entity entity_of(const pugi::xml_node& shape) {
    Entity entity{.name = fmt::format("{:.40}", shape.attribute("Type").value())};
    const std::string_view text = shape.attribute("Str").value();
    const std::string_view name = shape.attribute("Name").value();
    if (!text.empty() || !name.empty()) {
      entity.name += fmt::format(" \"{:.40}\"", text.empty() ? name : text);
    }
    const std::ptrdiff_t offset = shape.offset_debug();
    if (offset > 0) {
      std::tie(entity.line, entity.column) = lines_.at(static_cast<std::size_t>(offset - 1));
    }
    entity.layer = sketch_.layer(layer_of(shape).layer);
    return entity;
  }

  void bad(const pugi::xml_node& shape,
           std::string reason,
           std::string remedy = "it is left out; correct it in LightBurn") {
    sketch_.report(
        {FaultKind::kBadEntity, entity_of(shape), {}, std::move(reason), std::move(remedy)});
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_shape(const pugi::xml_node& shape, Within within) {
    const std::string_view type = shape.attribute("Type").value();
    remember_lists(shape);
    const auto own = lbrn_transform(shape);
    if (!own) return bad(shape, "its XForm is not six numbers");
    if (type == "Text") return read_letters(shape, within);
    within.to_mm = within.to_mm * *own;
    if (type == "Group") return read_group(shape, within);
    if (!is_output(shape)) return;
    if (type == "Rect") return read_rectangle(shape, within);
    if (type == "Ellipse") return read_ellipse(shape, within);
    if (type == "Path") return read_path(shape, within);
    if (type == kLbrnPicture) return read_picture(shape, within);
    bad(shape,
        "this kind of shape is not read",
        "it is left out; make a path of it in LightBurn (Convert to Path)");
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_group(const pugi::xml_node& shape, Within within) {
    if (++within.depth > kDeepestNesting) {
      return bad(shape, fmt::format("nested deeper than {} groups", kDeepestNesting));
    }
    read_shapes(shape.child("Children"), within);
  }

  /// Reads letters from the outlines that the project contains. Outlines and letters have the same
  /// position in the project.
  void read_letters(const pugi::xml_node& shape, Within within) {
    if (!is_output(shape)) return;
    const pugi::xml_node outline = shape.child("BackupPath");
    if (!outline) {
      return sketch_.ignore("Text: letters are no paths, and are left out",
                            entity_of(shape),
                            "to cut them, make a path of them in LightBurn (Convert to Path)");
    }
    remember_lists(outline);
    const auto own = lbrn_transform(outline);
    if (!own) return bad(shape, "the XForm of its outline is not six numbers");
    within.to_mm = within.to_mm * *own;
    draw_path(shape, outline, within);
  }

  bool is_output(const pugi::xml_node& shape) {
    const LbrnLayer& layer = layer_of(shape);
    if (layer.has_sub_layers) {
      sketch_.note(fmt::format("layer {:.60} has sub-layers: only its first settings are used",
                               layer.layer.name),
                   entity_of(shape));
    }
    if (const auto& offered = layer.layer.offered; offered && offered->kerf_offset_mm) {
      sketch_.note(
          fmt::format(
              "layer {:.60}: {}", layer.layer.name, note_of_kerf_offset(*offered->kerf_offset_mm)),
          entity_of(shape));
    }
    if (shape.child("Tabs")) sketch_.note("tabs of the project are ignored", entity_of(shape));
    if (layer.is_output) return true;
    sketch_.ignore(fmt::format("layer {:.60} is not sent to the laser", layer.layer.name),
                   entity_of(shape));
    return false;
  }

  void read_rectangle(const pugi::xml_node& shape, const Within& within) {
    const auto width = lbrn_number(shape, "W");
    const auto height = lbrn_number(shape, "H");
    if (!width || !height || !(*width > 0.0) || !(*height > 0.0)) {
      return bad(shape, "its W and H are not above 0");
    }
    const double radius = lbrn_number(shape, "Cr").value_or(0.0);
    if (radius < 0.0) {
      return bad(shape,
                 "its corners are cut inwards (Cr below 0)",
                 "it is left out; make a path of it in LightBurn (Convert to Path)");
    }
    const double most = 0.5 * std::min(*width, *height);
    add(shape, within, rounded_rectangle(*width, *height, std::min(radius, most)));
  }

  void read_ellipse(const pugi::xml_node& shape, const Within& within) {
    const auto rx = lbrn_number(shape, "Rx");
    const auto ry = lbrn_number(shape, "Ry");
    if (!rx || !ry || !(*rx > 0.0) || !(*ry > 0.0)) {
      return bad(shape, "its Rx and Ry are not above 0");
    }
    add(shape, within, {Ellipse{{0.0, 0.0}, {*rx, 0.0}, {0.0, *ry}, 0.0, kFullTurn}});
  }

  /// Reads a picture, whose middle is the origin of its XForm. The data of the picture are the
  /// bytes of a picture file in base 64.
  void read_picture(const pugi::xml_node& shape, const Within& within) {
    Entity entity = entity_of(shape);
    const auto width = lbrn_number(shape, "W");
    const auto height = lbrn_number(shape, "H");
    if (!width || !height || !(*width > 0.0) || !(*height > 0.0)) {
      return bad(shape, "its W and H are not above 0");
    }
    const auto bytes = picture::base64_decoded(shape.attribute("Data").value());
    if (!bytes || bytes->empty()) {
      return sketch_.report_bad_picture(
          entity, "the project does not contain its data", "import the picture again in LightBurn");
    }
    auto image = sketch_.decode(*bytes, entity);
    if (!image) return;
    const Transform to_mm = within.to_mm * moved_by({-0.5 * *width, 0.5 * *height}) *
                            scaled_by(*width / static_cast<double>(image->width),
                                      -*height / static_cast<double>(image->height));
    const bool is_near = to_mm.finite() && to_mm.origin.cwiseAbs().maxCoeff() <= kFarthestMm;
    if (!is_near || to_mm.determinant() == 0.0)
      return bad(shape, "its XForm reduces it to nothing");
    sketch_.add(DrawnPicture{std::move(image), to_mm, std::move(entity), {}});
  }

  /// Stores the lists of a path by their numbers. A list that several paths share is written in the
  /// file once, with a number, and later paths refer to this number.
  void remember_lists(const pugi::xml_node& path) {
    const auto remember = [](auto& lists, const char* id, const pugi::xml_node& list) {
      if (*id != '\0' && list) lists.insert_or_assign(std::string{id}, list);
    };
    remember(vertex_lists_, path.attribute("VertID").value(), path.child("VertList"));
    remember(edge_lists_, path.attribute("PrimID").value(), path.child("PrimList"));
  }

  void read_path(const pugi::xml_node& shape, const Within& within) {
    draw_path(shape, shape, within);
  }

  void draw_path(const pugi::xml_node& shape, const pugi::xml_node& path, const Within& within) {
    const std::string vertex_list = vertex_text(path);
    const std::string edge_list = edge_text(path);
    spend((vertex_list.size() + edge_list.size()) / kBytesOfWork);
    const auto vertices = lbrn_vertices(vertex_list);
    if (!vertices) return bad(shape, "its list of vertices is broken");
    if (vertices->empty()) return bad(shape, "it has no vertices");
    const auto edges = lbrn_edges(edge_list, vertices->size());
    if (!edges) return bad(shape, "its list of lines and curves is broken");
    if (edges->empty()) return bad(shape, "it has no lines and curves");
    for (std::vector<Shape>& row : lbrn_rows(*vertices, *edges)) {
      add(shape, within, std::move(row));
    }
  }

  /// Returns the list of vertices of a path in the short form. Converts the longer form of old
  /// projects.
  std::string vertex_text(const pugi::xml_node& path) const {
    if (const auto list = list_of(path, "VertList", "VertID", vertex_lists_)) return *list;
    std::string text;
    for (const pugi::xml_node& vertex : path.children("V")) {
      text += fmt::format(
          "V{} {}", vertex.attribute("vx").as_string("0"), vertex.attribute("vy").as_string("0"));
      for (const char* const name : {"c0x", "c0y", "c1x", "c1y"}) {
        if (const auto value = vertex.attribute(name))
          text += fmt::format("{}{}", name, value.value());
      }
    }
    return text;
  }

  std::string edge_text(const pugi::xml_node& path) const {
    if (const auto list = list_of(path, "PrimList", "PrimID", edge_lists_)) return *list;
    std::string text;
    for (const pugi::xml_node& edge : path.children("P")) {
      text += fmt::format("{}{} {}",
                          edge.attribute("T").value(),
                          edge.attribute("p0").as_string("0"),
                          edge.attribute("p1").as_string("0"));
    }
    return text;
  }

  using Lists = std::map<std::string, pugi::xml_node, std::less<>>;

  static std::optional<std::string> list_of(const pugi::xml_node& path,
                                            const char* tag,
                                            const char* id,
                                            const Lists& lists) {
    if (const pugi::xml_node own = path.child(tag)) return own.child_value();
    const auto found = lists.find(std::string_view{path.attribute(id).value()});
    if (found == lists.end()) return {};
    return found->second.child_value();
  }

  void add(const pugi::xml_node& shape, const Within& within, std::vector<Shape> row) {
    for (Shape& part : row) part = transformed(part, within.to_mm);
    static_cast<void>(sketch_.add({std::move(row), sketch_.add_entity(entity_of(shape))}));
  }

  const std::string& text_;
  LineTable lines_;
  Sketch& sketch_;
  std::size_t left_;
  std::map<int, LbrnLayer> layers_;
  std::map<int, LbrnLayer> picture_layers_;
  Lists vertex_lists_;
  Lists edge_lists_;
};

}  // namespace

bool is_lbrn(std::string_view start) {
  constexpr std::size_t kHead = 4096;
  if (!start.starts_with('<')) return false;
  const std::string_view head = start.substr(0, kHead);
  const std::size_t at = head.find(kLbrnRoot);
  return at != std::string_view::npos && at != 0 && head[at - 1] == '<';
}

void read_lbrn(const std::string& text, Sketch& sketch) { LbrnReader{text, sketch}.read(); }

}  // namespace sim::drawing
