#include <gmock/gmock.h>

#include <limits>

#include "tests/host-sim/surface/support.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(StlReader, MeshesAreReadBack) {
  const proof::Trials trials{300};
  for (const std::uint64_t seed : trials) {
    const Mesh mesh = random_mesh(seed, 2 + seed % 5, 2 + seed % 4);
    for (const std::string& bytes : {binary_stl_of(mesh), ascii_stl_of(mesh)}) {
      const SurfaceInput input = read_surface(bytes, "f", {});
      EXPECT_FALSE(input.grid.has_value());
      EXPECT_EQ(corners_of(input.mesh), corners_of(mesh));
      EXPECT_EQ(input.mesh.points.size(), mesh.points.size());
      EXPECT_THAT(input.notes, IsEmpty());
    }
  }
}

TEST(StlReader, ABinaryHeaderMayBeginWithSolid) {
  const Mesh mesh = random_mesh(1);
  for (const char* header : {"solid part", "solid\nfacet normal", "SOLID"}) {
    EXPECT_EQ(corners_of(read_surface(binary_stl_of(mesh, header), "f", {}).mesh),
              corners_of(mesh));
  }
}

TEST(StlReader, WordsMayHaveCapitalsAndLinesCrLf) {
  EXPECT_EQ(read_surface("  SOLID x\r\nFacet Normal 0 0 1\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\n"
                         "VERTEX 1E0 0 0\r\n vertex 0 +1.0 0\r\nENDLOOP\r\nENDFACET\r\nENDSOLID",
                         "f",
                         {.unit_mm = 25.4})
                .mesh.points,
            (std::vector<Eigen::Vector3d>{{0, 0, 0}, {25.4, 0, 0}, {0, 25.4, 0}}));
}

TEST(StlReader, DamagedBinaryFilesAreRefused) {
  const std::string bytes = binary_stl_of(random_mesh(1));
  EXPECT_EQ(
      refusal_of(bytes.substr(0, bytes.size() - 1)),
      "f: announces 24 facets of binary STL, but has bytes for 23; it is cut off or of another "
      "format; export the mesh again");
  EXPECT_THAT(refusal_of("solid" + std::string(70, '\0')), HasSubstr("too short for binary STL"));
  std::string many = std::string(80, ' ') + "\xFF\xFF\xFF\xFF" + std::string(100, '\0');
  EXPECT_THAT(refusal_of(many), HasSubstr("announces 4294967295 facets"));
  EXPECT_THAT(refusal_of(std::string(84, '\0')), HasSubstr("has no facet with an area"));
}

TEST(StlReader, WhatIsNotFiniteIsRefused) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Mesh mesh = random_mesh(1);
    mesh.points[6].y() = bad;
    EXPECT_EQ(refusal_of(binary_stl_of(mesh)),
              "f: facet 1 has a coordinate that is not finite; export the mesh again without such "
              "points");
    EXPECT_THAT(refusal_of(ascii_stl_of(mesh)), StartsWith("f:6: facet 1: `"));
  }
}

TEST(StlReader, DamagedTextsAreRefused) {
  const std::string text = ascii_stl_of(random_mesh(1));
  EXPECT_THAT(refusal_of(text.substr(0, text.size() - 14)), HasSubstr("ends without endsolid"));
  const std::string start = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
  EXPECT_EQ(refusal_of(start + "endloop\n"),
            "f:5: facet 1: has 1 corners in place of 3; export the mesh again");
  EXPECT_THAT(refusal_of(start + start.substr(6) + "vertex 1 1\n"),
              HasSubstr("`` is not a finite"));
  EXPECT_THAT(refusal_of(start + "vertex 1 0 0\nvertex 2 0 0\nvertex 3 3 3\n"),
              StartsWith("f:7: facet 1: has more than 3 corners"));
  EXPECT_THAT(refusal_of(start + "colour\n"), StartsWith("f:5: facet 1: `colour` is not a word"));
  EXPECT_THAT(refusal_of("solid\nendsolid\n"), HasSubstr("has no facet with an area"));
}

TEST(MeshFinish, FacetsWithoutAreaAreLeftOut) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}},
                  {{0, 1, 2}, {0, 1, 3}, {1, 1, 2}, {1, 3, 2}}};
  const SurfaceInput input = read_surface(binary_stl_of(mesh), "f", {});
  EXPECT_EQ(input.mesh.facets.size(), 2U);
  EXPECT_THAT(input.notes,
              ElementsAre("f: 2 facets without area are left out, the first is facet 2"));
}

TEST(MeshFinish, AMeshBeyondTenMetresIsRefused) {
  Mesh mesh = random_mesh(1);
  mesh.points.back().x() = 10'001.0;
  EXPECT_EQ(refusal_of(binary_stl_of(mesh)),
            "f: facet 23 lies beyond 10 m; check the unit, or move the origin to the part");
}

TEST(MeshFinish, AnOpenMeshThatFacesDownIsTurnedOver) {
  Mesh mesh = random_mesh(1);
  const auto upward = mesh.facets;
  for (auto& facet : mesh.facets) std::swap(facet[1], facet[2]);
  const SurfaceInput input = read_surface(ascii_stl_of(mesh), "f", {});
  EXPECT_THAT(input.notes, ElementsAre(HasSubstr("inside out")));
  for (const auto& facet : input.mesh.facets) {
    const Eigen::Vector3d u = input.mesh.points[facet[1]] - input.mesh.points[facet[0]];
    const Eigen::Vector3d v = input.mesh.points[facet[2]] - input.mesh.points[facet[0]];
    EXPECT_GT(u.x() * v.y() - u.y() * v.x(), 0.0);
  }
}

TEST(MeshFinish, AClosedMeshThatIsInsideOutIsTurnedOver) {
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.3, 1}},
            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  EXPECT_THAT(read_surface(binary_stl_of(mesh), "f", {}).notes, IsEmpty());
  for (auto& facet : mesh.facets) std::swap(facet[1], facet[2]);
  EXPECT_THAT(read_surface(binary_stl_of(mesh), "f", {}).notes, ElementsAre(HasSubstr("inside")));
}

}  // namespace
}  // namespace sim::surface
