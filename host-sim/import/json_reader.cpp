#include "host-sim/import/json_reader.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host-sim/import/dxf_polyline.hpp"
#include "host-sim/import/line_table.hpp"

namespace sim::drawing {
namespace {

using nlohmann::json;

constexpr int kDeepestJson = 16;

/// Returns the vertex of an array [x, y] or [x, y, bulge]; nothing for any other value.
std::optional<BulgeVertex> vertex_of(const json& value) {
  if (!value.is_array() || value.size() < 2 || value.size() > 3) return {};
  for (const json& number : value) {
    if (!number.is_number()) return {};
  }
  BulgeVertex vertex{{value[0].get<double>(), value[1].get<double>()}};
  if (value.size() == 3) vertex.bulge = value[2].get<double>();
  return vertex;
}

class JsonReader {
 public:
  explicit JsonReader(Sketch& sketch) : sketch_{sketch} {}

  void read(const json& document) {
    if (document.is_array()) {
      for (const json& part : document) read_part(part);
    } else if (document.is_object() && document.contains("items") && document["items"].is_array()) {
      for (const json& item : document["items"]) read_item(item);
    } else if (document.is_object() && document.contains("kerfline_sheet")) {
      sketch_.refuse(1, 0, "a sheet of parts, not a drawing", "`kerfline cut` takes sheets");
    } else {
      sketch_.refuse(1,
                     0,
                     "neither a list of parts nor a nesting job",
                     "docs/drawings.md describes the format of both");
    }
  }

 private:
  void bad(const std::string& pointer, std::string reason) {
    sketch_.report({FaultKind::kBadEntity,
                    {.name = pointer},
                    {},
                    std::move(reason),
                    "it is left out; correct it"});
  }

  void read_part(const json& part) {
    const std::string pointer = fmt::format("/{}", part_++);
    if (!part.is_object() || !part.contains("paths") || !part["paths"].is_array()) {
      return bad(pointer, "no part in the list has paths");
    }
    const auto id = part.find("partid");
    const bool named = id != part.end() && id->is_string();
    const std::string layer = named ? id->get<std::string>() : std::string{};
    std::size_t index = 0;
    for (const json& path : part["paths"]) {
      add(fmt::format("{}/paths/{}", pointer, index++), layer, path, false);
    }
  }

  void read_item(const json& item) {
    const std::string pointer = fmt::format("/items/{}", part_++);
    const bool whole = item.is_object() && item.contains("shape") && item["shape"].is_object() &&
                       item["shape"].contains("data");
    if (!whole) return bad(pointer, "no item of the job has a shape");
    const json& shape = item["shape"];
    if (shape.value("type", json{}) != "simple_polygon") {
      return bad(pointer + "/shape", "its type is not simple_polygon");
    }
    const json id = item.value("id", json{});
    add(pointer + "/shape/data",
        id.is_null() ? pointer : fmt::format("item {}", id.dump()),
        shape["data"],
        true);
  }

  void add(const std::string& pointer, const std::string& layer, const json& path, bool closed) {
    if (!path.is_array()) return bad(pointer, "no list of vertices");
    std::vector<BulgeVertex> vertices;
    for (const json& value : path) {
      const auto vertex = vertex_of(value);
      if (!vertex) {
        return bad(fmt::format("{}/{}", pointer, vertices.size()), "no [x, y] or [x, y, bulge]");
      }
      vertices.push_back(*vertex);
    }
    const std::size_t entity =
        sketch_.add_entity({.name = pointer, .layer = sketch_.layer({layer, {}}), .part = part_});
    std::vector<Shape> shapes = bulge_edges(vertices, closed);
    if (shapes.empty()) return bad(pointer, "it has no length");
    static_cast<void>(sketch_.add({std::move(shapes), entity}));
  }

  Sketch& sketch_;
  std::size_t part_ = 0;
};

}  // namespace

void read_json(const std::string& text, Sketch& sketch) {
  const auto shallow = [](int depth, json::parse_event_t /*event*/, json& /*value*/) {
    if (depth > kDeepestJson) throw std::length_error{"nested too deeply"};
    return true;
  };
  try {
    JsonReader{sketch}.read(json::parse(text, shallow));
  } catch (const json::parse_error& error) {
    const auto [line, column] = LineTable{text}.at(error.byte == 0 ? 0 : error.byte - 1);
    sketch.refuse(line, column, "broken JSON", "export it again");
  } catch (const json::exception&) {
    sketch.refuse(1, 0, "a number in the file is too great", "correct it");
  } catch (const std::length_error& error) {
    sketch.refuse(1, 0, error.what(), "it is no drawing in a format that Kerfline can read");
  }
}

}  // namespace sim::drawing
