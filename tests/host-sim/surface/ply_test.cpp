#include <gmock/gmock.h>

#include "tests/host-sim/surface/support.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Returns a header with the counts of a mesh.
std::string header_of(const std::string& format, const std::string& real, const Mesh& mesh) {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment by a test\nelement vertex {}\nproperty {} x\nproperty {} y\n"
      "property {} z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      format,
      mesh.points.size(),
      real,
      real,
      real,
      mesh.facets.size());
}

std::string ascii_ply_of(const Mesh& mesh) {
  std::string text = header_of("ascii", "double", mesh);
  for (const auto& p : mesh.points) text += fmt::format("{} {} {}\n", p.x(), p.y(), p.z());
  for (const auto& f : mesh.facets) text += fmt::format("3 {} {} {}\n", f[0], f[1], f[2]);
  return text;
}

template <typename Real>
std::string binary_ply_of(const Mesh& mesh, bool is_big) {
  std::string bytes = header_of(is_big ? "binary_big_endian" : "binary_little_endian",
                                sizeof(Real) == 4 ? "float" : "double",
                                mesh);
  const auto add = [&](auto number) { bytes += is_big ? big(number) : little(number); };
  for (const auto& point : mesh.points) {
    for (const double value : point) add(static_cast<Real>(value));
  }
  for (const auto& facet : mesh.facets) {
    bytes += '\x03';
    for (const std::uint32_t corner : facet) add(corner);
  }
  return bytes;
}

TEST(PlyReader, MeshesAreReadBackInAllFormats) {
  const proof::Trials trials{300};
  for (const std::uint64_t seed : trials) {
    const Mesh mesh = random_mesh(seed, 2 + seed % 5, 2 + seed % 4);
    for (const std::string& bytes : {ascii_ply_of(mesh),
                                     binary_ply_of<float>(mesh, false),
                                     binary_ply_of<float>(mesh, true),
                                     binary_ply_of<double>(mesh, false),
                                     binary_ply_of<double>(mesh, true)}) {
      const SurfaceInput input = read_surface(bytes, "f", {});
      ASSERT_EQ(input.mesh.points, mesh.points);
      ASSERT_EQ(input.mesh.facets, mesh.facets);
      EXPECT_THAT(input.notes, IsEmpty());
    }
  }
}

TEST(PlyReader, NormalsColoursAndOtherElementsArePassedOver) {
  const SurfaceInput input = read_surface(
      "ply\r\nformat ascii 1.0\r\nobj_info scan\r\nelement edge 1\r\nproperty list uchar int "
      "ends\r\n"
      "element vertex 4\r\nproperty float nx\r\nproperty float x\r\nproperty float y\r\n"
      "property uchar red\r\nproperty float z\r\nelement face 1\r\nproperty uchar mark\r\n"
      "property list uint8 uint32 vertex_index\r\nproperty list uchar float weights\r\n"
      "end_header\r\n2 0 1\r\n9 0 0 255 1\r\n9 1 0 255 2\r\n9 1 1 255 3\r\n9 0 1 255 4\r\n"
      "7 4 0 1 2 3 2 0.5 0.5\r\n",
      "f",
      {});
  EXPECT_EQ(input.mesh.points,
            (std::vector<Eigen::Vector3d>{{0, 0, 1}, {1, 0, 2}, {1, 1, 3}, {0, 1, 4}}));
  EXPECT_THAT(input.mesh.facets, ElementsAre(Facet{0, 1, 2}, Facet{0, 2, 3}));
}

TEST(PlyReader, StripsAreTriangles) {
  const std::string start =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
  const SurfaceInput input = read_surface(start + "9 0 1 2 3 -1 2 3 4 5\n", "f", {});
  EXPECT_THAT(input.mesh.facets,
              ElementsAre(Facet{0, 1, 2}, Facet{2, 1, 3}, Facet{2, 3, 4}, Facet{4, 3, 5}));
  // Two strips are read as one, because they share equal corners.
  const SurfaceInput joined = read_surface(start + "10 0 1 2 3 3 2 2 3 4 5\n", "f", {});
  EXPECT_EQ(joined.mesh.facets, input.mesh.facets);
  EXPECT_THAT(refusal_of(start + "3 0 1 -2\n"), HasSubstr("facet 1 has point -2"));
  EXPECT_THAT(refusal_of(start + "3 0 1 7\n"), HasSubstr("point"));
}

TEST(PlyReader, AllScalarsAreRead) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\n"
      "property short y\nproperty int z\nproperty ushort a\nproperty uint b\nproperty double c\n"
      "element face 1\nproperty list ushort uchar vertex_indices\nend_header\n";
  for (const int i : {0, 1, 2}) {
    bytes += little(static_cast<std::uint8_t>(-i));
    bytes += little(static_cast<std::uint16_t>(i * (i - 3)));
    bytes += little(static_cast<std::uint32_t>(-70'000 + i));
    bytes += std::string(14, '\x7F');
  }
  bytes += little(std::uint16_t{3}) + std::string{"\0\1\2", 3};
  EXPECT_THAT(refusal_of(bytes), HasSubstr("facet 1 lies beyond 10 m"));
  const SurfaceInput input = read_surface(bytes, "f", {.unit_mm = 0.1});
  EXPECT_EQ(input.mesh.points[1], Eigen::Vector3d(-1, -2, -69'999) * 0.1);
}

TEST(PlyReader, GreatPromisesAreRefusedBeforeMemoryIsReserved) {
  const std::string start = "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  EXPECT_EQ(
      refusal_of(start + "property float x\nproperty float y\nproperty float z\n" + face +
                 std::string(1000, '\0')),
      "f: announces 4000000000 of `vertex`, but has bytes for 83; the file is cut off; export "
      "it again");
  EXPECT_THAT(refusal_of(start + face), HasSubstr("an element without properties"));
  EXPECT_THAT(refusal_of("ply\nformat ascii 1.0\nelement vertex 99999999999999999999\n"),
              StartsWith("f:3: `99999999999999999999` is not a number"));
  EXPECT_THAT(refusal_of("ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\n"
                         "property float y\nproperty float z\nelement face 1\n"
                         "property list uint int vertex_indices\nend_header\n" +
                         std::string(12, '\0') + "\xFF\xFF\xFF\xFF"),
              HasSubstr("a list of 4294967295 numbers"));
}

TEST(PlyReader, BadHeadersAreRefusedWithTheirLine) {
  EXPECT_EQ(refusal_of("ply\nfromat ascii 1.0\n"),
            "f:2: `fromat` is not a word of a PLY header; export the mesh again");
  EXPECT_THAT(refusal_of("ply\nformat utf8 1.0\n"), StartsWith("f:2: `utf8` is not a format"));
  EXPECT_THAT(refusal_of("ply\nelement vertex -1\n"), StartsWith("f:2: `-1` is not a number"));
  EXPECT_THAT(refusal_of("ply\nproperty float x\n"), StartsWith("f:2: has a property before"));
  EXPECT_THAT(refusal_of("ply\nelement a 1\nproperty half x\n"), StartsWith("f:3: `half` is no"));
  EXPECT_THAT(refusal_of("ply\nelement a 1\nproperty list float int x\n"),
              StartsWith("f:3: the length of a list"));
  EXPECT_THAT(refusal_of("ply\nend_header\n"), StartsWith("f:2: has no line `format`"));
  EXPECT_THAT(refusal_of("ply\nformat ascii 1.0\n"), HasSubstr("ends without end_header"));
  EXPECT_THAT(refusal_of("ply\nformat ascii 1.0\nend_header\n"), HasSubstr("points alone"));
}

TEST(PlyReader, BadIndicesAndShortFilesAreRefused) {
  Mesh mesh = random_mesh(1);
  mesh.facets[4][1] = 20;
  EXPECT_EQ(refusal_of(ascii_ply_of(mesh)),
            "f: facet 5 has point 20, but the last point is 19; export the mesh again");
  mesh.facets[4][1] = 0xFFFF'FFFF;
  EXPECT_THAT(refusal_of(binary_ply_of<float>(mesh, true)), HasSubstr("facet 5 has point -1"));
  const std::string text = ascii_ply_of(random_mesh(1));
  EXPECT_THAT(refusal_of(text.substr(0, text.size() - 3)), HasSubstr("ends too early"));
  EXPECT_THAT(refusal_of(text.substr(0, text.size() - 3) + "x"), HasSubstr("`x` is not a number"));
  for (const bool is_big : {false, true}) {
    const std::string bytes = binary_ply_of<double>(random_mesh(1), is_big);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      EXPECT_NE(refusal_of(bytes.substr(0, size)), "") << size;
    }
  }
}

TEST(PlyReader, PointsThatNoFacetHasAreLeftOut) {
  Mesh mesh = random_mesh(1);
  mesh.points.insert(mesh.points.begin() + 3, {std::nan(""), 0.0, 1e9});
  for (auto& facet : mesh.facets) {
    for (std::uint32_t& corner : facet) corner += corner >= 3 ? 1 : 0;
  }
  const SurfaceInput input = read_surface(ascii_ply_of(mesh), "f", {});
  EXPECT_EQ(input.mesh.points, random_mesh(1).points);
  EXPECT_EQ(input.mesh.facets, random_mesh(1).facets);
  EXPECT_THAT(input.notes, ElementsAre("f: 1 points that belong to no facet are left out"));
  mesh.facets[0][0] = 3;
  EXPECT_THAT(refusal_of(ascii_ply_of(mesh)), HasSubstr("facet 1 has a coordinate that is not fi"));
}

}  // namespace
}  // namespace sim::surface
