#include "host-sim/contour/contour_dxf.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string_view>

namespace sim {
namespace {

// The value 4 of $INSUNITS stands for mm. Readers of release 12 do not know this variable and skip
// it. Readers of later releases use it.
constexpr std::string_view kDxfHead =
    "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n"
    "0\nSECTION\n2\nENTITIES\n";
constexpr std::string_view kDxfTail = "0\nENDSEC\n0\nEOF\n";

void add_loop(std::string& out, std::span<const ContourVertex> vertices, std::size_t layer) {
  fmt::format_to(std::back_inserter(out), "0\nPOLYLINE\n8\n{}\n66\n1\n70\n1\n", layer);
  for (const ContourVertex& vertex : vertices) {
    fmt::format_to(std::back_inserter(out),
                   "0\nVERTEX\n8\n{}\n10\n{}\n20\n{}\n42\n{}\n",
                   layer,
                   vertex.x,
                   vertex.y,
                   vertex.bulge);
  }
  fmt::format_to(std::back_inserter(out), "0\nSEQEND\n8\n{}\n", layer);
}

}  // namespace

std::string dxf_of_contours(std::span<const Contour> contours) {
  std::string out{kDxfHead};
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const std::span<const ContourVertex> vertices{contours[i].vertices};
    std::size_t begin = 0;
    for (const std::uint32_t end : contours[i].loop_ends) {
      add_loop(out, vertices.subspan(begin, end - begin), i + 1);
      begin = end;
    }
  }
  return out += kDxfTail;
}

}  // namespace sim
