#include "host-sim/stock/mesh_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "host-sim/stock/carver.hpp"
#include "host-sim/stock/height_map.hpp"
#include "tests/host-sim/trace/scratch_file.hpp"

namespace sim::stock {
namespace {

using Corner = std::array<float, 3>;
using Face = std::array<Corner, 3>;

template <typename Value>
Value value_at(const std::string& bytes, std::size_t place) {
  Value value{};
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

std::vector<Face> read_stl(const std::string& bytes) {
  const auto count = value_at<std::uint32_t>(bytes, 80);
  EXPECT_EQ(bytes.size(), 84U + 50U * count);
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i < count; ++i) {
    faces.push_back(value_at<Face>(bytes, 84U + 50U * i + 12U));
  }
  return faces;
}

std::vector<Face> read_ply(const std::string& bytes) {
  std::size_t points = 0;
  std::size_t triangles = 0;
  std::istringstream lines{bytes};
  std::string line;
  while (std::getline(lines, line) && line != "end_header") {
    if (line.starts_with("element vertex ")) points = std::stoul(line.substr(15));
    if (line.starts_with("element face ")) triangles = std::stoul(line.substr(13));
  }
  const auto begin = static_cast<std::size_t>(lines.tellg());
  EXPECT_EQ(bytes.size(), begin + 12U * points + 13U * triangles);
  std::vector<Face> faces;
  for (std::size_t i = 0; i < triangles; ++i) {
    const std::size_t at = begin + 12U * points + 13U * i;
    EXPECT_EQ(bytes[at], 3);
    Face face{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto index = value_at<std::uint32_t>(bytes, at + 1U + 4U * k);
      EXPECT_LT(index, points);
      face[k] = value_at<Corner>(bytes, begin + 12U * index);
    }
    faces.push_back(face);
  }
  return faces;
}

/// Returns the signed volume, about the origin, of the body that the faces enclose.
double volume_of(const std::vector<Face>& faces) {
  double sum = 0.0;
  for (const auto& [a, b, c] : faces) {
    const auto at = [](const Corner& corner, std::size_t i) {
      return static_cast<double>(corner[i]);
    };
    sum += at(a, 0) * (at(b, 1) * at(c, 2) - at(b, 2) * at(c, 1)) -
           at(a, 1) * (at(b, 0) * at(c, 2) - at(b, 2) * at(c, 0)) +
           at(a, 2) * (at(b, 0) * at(c, 1) - at(b, 1) * at(c, 0));
  }
  return sum / 6.0;
}

/// Expects that each edge belongs to two faces, which run along it in opposite directions, as in a
/// closed body.
void expect_closed(const std::vector<Face>& faces) {
  std::map<std::pair<Corner, Corner>, int> edges;
  for (const Face& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner& from = face[i];
      const Corner& to = face[(i + 1) % 3];
      ++edges[{from, to}];
      --edges[{to, from}];
    }
  }
  for (const auto& [edge, balance] : edges) ASSERT_EQ(balance, 0);
}

constexpr StockBox kPiece{-3.0, 5.0, 17.0, 15.0, 2.0, -4.0};

TEST(MeshFile, EncloseWhatIsLeft) {
  Stock stock{kPiece, 0.1};
  Carver carver{stock, {.kind = CutterKind::kBall, .diameter_mm = 4.0}};
  carver.sweep({{2.0, 10.0, 0.0}, {12.0, 11.0, 0.5}});
  const ScratchFile stl{".stl"};
  write_stl(stl.path(), stock);
  const std::vector<Face> faces = read_stl(stl.text());
  expect_closed(faces);
  const VolumeBounds removed = stock.removed();
  const double left = 20.0 * 10.0 * 6.0 - 0.5 * (removed.min_mm3 + removed.max_mm3);
  EXPECT_NEAR(volume_of(faces), left, 0.2);
  const ScratchFile ply{".ply"};
  write_ply(ply.path(), stock);
  EXPECT_EQ(read_ply(ply.text()), faces);
}

TEST(MeshFile, OfAnUncutStockIsItsBox) {
  const Stock stock{kPiece, 3.0};
  const ScratchFile stl{".stl"};
  write_stl(stl.path(), stock);
  const std::vector<Face> faces = read_stl(stl.text());
  expect_closed(faces);
  EXPECT_NEAR(volume_of(faces), 1'200.0, 1.0e-3);
}

TEST(MeshFile, OfAFineStockHasBoundedSize) {
  const Stock stock{{0.0, 0.0, 100.0, 80.0, 0.0, -1.0}, 0.02};
  const ScratchFile ply{".ply"};
  write_ply(ply.path(), stock);
  EXPECT_LE(ply.text().size(), 45U * kMaxMeshPoints);
}

TEST(HeightMap, HasTheMeansOfBlocks) {
  Stock stock{{0.0, 0.0, 10.0, 10.0, 5.0, 0.0}, 0.05};
  Carver carver{stock, {.kind = CutterKind::kFlat, .diameter_mm = 4.0}};
  carver.sweep({{5.0, 5.0, 3.0}, {5.0, 5.0, 2.0}});
  const HeightMap fine{stock, 1'000'000};
  EXPECT_EQ(fine.block_cells(), 1);
  EXPECT_NEAR(fine.lowest(), 2.0, 1.0e-5);
  const HeightMap map{stock, 5'000};
  EXPECT_LE(map.columns() * map.rows(), 5'000);
  double sum = 0.0;
  for (int row = 0; row < map.rows(); ++row) {
    for (int column = 0; column < map.columns(); ++column) sum += 5.0 - map.height(column, row);
  }
  const double volume = sum * 100.0 / (map.columns() * map.rows());
  EXPECT_NEAR(volume, 4.0 * std::numbers::pi * 3.0, 0.5);
  EXPECT_NEAR(map.height(map.columns() / 2, map.rows() / 2), 2.0, 1.0e-5);
  EXPECT_EQ(map.height(0, 0), 5.0);
}

}  // namespace
}  // namespace sim::stock
