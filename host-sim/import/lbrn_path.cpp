#include "host-sim/import/lbrn_path.hpp"

#include <array>

#include "host-sim/import/scanner.hpp"

namespace sim::drawing {
namespace {

/// Reads the Bézier handles that follow the point of a vertex: `c0x` and `c0y`, `c1x` and `c1y`.
/// Ignores a handle that lacks one of its two numbers: LightBurn writes `c0x1` for a vertex without
/// a curve.
class HandleReader {
 public:
  /// Reads one coordinate of a handle, such as `c0x3`. Returns false if it is malformed.
  bool read(Scanner& scanner) {
    if (!scanner.take('c')) return false;
    const char which = scanner.peek();
    if (which != '0' && which != '1') return false;
    scanner.skip();
    const char axis = scanner.peek();
    if (axis != 'x' && axis != 'y') return false;
    scanner.skip();
    const auto value = scanner.number();
    if (!value) return false;
    const std::size_t index = (which == '1' ? 2U : 0U) + (axis == 'y' ? 1U : 0U);
    values_.at(index) = value;
    return true;
  }

  [[nodiscard]] std::optional<Place> leaving() const { return handle(0); }
  [[nodiscard]] std::optional<Place> reaching() const { return handle(2); }

 private:
  [[nodiscard]] std::optional<Place> handle(std::size_t index) const {
    const auto& x = values_.at(index);
    const auto& y = values_.at(index + 1);
    if (!x || !y) return {};
    return Place{*x, *y};
  }

  std::array<std::optional<double>, 4> values_{};
};

std::optional<std::size_t> index_below(Scanner& scanner, std::size_t count) {
  const auto number = scanner.number();
  if (!number || !(*number >= 0.0) || !(*number < static_cast<double>(count))) return {};
  return static_cast<std::size_t>(*number);
}

std::vector<LbrnEdge> all_around(std::size_t vertices, bool closed) {
  std::vector<LbrnEdge> edges;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < vertices; ++i) {
    edges.push_back({false, i, (i + 1) % vertices});
  }
  return edges;
}

Shape shape_of(const LbrnVertex& from, const LbrnVertex& to, bool is_curve) {
  if (!is_curve) return Line{from.place, to.place};
  return Bezier{
      {from.place, from.leaving.value_or(from.place), to.reaching.value_or(to.place), to.place}};
}

}  // namespace

std::optional<std::vector<LbrnVertex>> lbrn_vertices(std::string_view list) {
  std::vector<LbrnVertex> vertices;
  Scanner scanner{list};
  while (!scanner.at_end()) {
    // An S marks a vertex as smooth. It is skipped, because the handles of the vertex already make
    // the path smooth.
    if (scanner.take('S')) continue;
    if (!scanner.take('V')) return {};
    const auto x = scanner.number();
    const auto y = x ? scanner.number() : std::nullopt;
    if (!y) return {};
    HandleReader handles;
    while (scanner.peek() == 'c') {
      if (!handles.read(scanner)) return {};
    }
    vertices.push_back({{*x, *y}, handles.leaving(), handles.reaching()});
  }
  return vertices;
}

std::optional<std::vector<LbrnEdge>> lbrn_edges(std::string_view list, std::size_t vertices) {
  Scanner scanner{list};
  // Skips blanks; the returned character is not used.
  static_cast<void>(scanner.peek());
  if (scanner.rest().starts_with("LineClosed")) return all_around(vertices, true);
  if (scanner.rest().starts_with("LineOpen")) return all_around(vertices, false);
  std::vector<LbrnEdge> edges;
  while (!scanner.at_end()) {
    const char kind = scanner.peek();
    if (kind != 'L' && kind != 'B') return {};
    scanner.skip();
    const auto from = index_below(scanner, vertices);
    const auto to = from ? index_below(scanner, vertices) : std::nullopt;
    if (!to) return {};
    edges.push_back({kind == 'B', *from, *to});
  }
  return edges;
}

std::vector<std::vector<Shape>> lbrn_rows(const std::vector<LbrnVertex>& vertices,
                                          const std::vector<LbrnEdge>& edges) {
  std::vector<std::vector<Shape>> rows;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const LbrnEdge& edge = edges[i];
    if (i == 0 || edges[i - 1].to != edge.from) rows.emplace_back();
    rows.back().push_back(shape_of(vertices[edge.from], vertices[edge.to], edge.is_curve));
  }
  return rows;
}

}  // namespace sim::drawing
