#include <gmock/gmock.h>

#include "tests/host-sim/surface/support.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Integer heights, row by row; the first row has the greatest Y.
struct Heights {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<int> values;
};

Heights random_heights(std::uint64_t seed, int greatest) {
  std::mt19937_64 random{seed};
  Heights heights{2 + seed % 5, 2 + seed % 7, {}};
  std::uniform_int_distribution<int> some{0, greatest};
  for (std::size_t i = 0; i < heights.rows * heights.columns; ++i) {
    heights.values.push_back(some(random));
  }
  return heights;
}

/// Expects the scaled heights as a grid of 0.5 mm from 0, 0.
void expect_grid(const SurfaceInput& input, const Heights& heights, double scale) {
  ASSERT_EQ(input.grid->rows, heights.rows);
  ASSERT_EQ(input.grid->columns, heights.columns);
  for (std::size_t r = 0; r < heights.rows; ++r) {
    for (std::size_t c = 0; c < heights.columns; ++c) {
      const Eigen::Vector3d& point = input.grid->at(heights.rows - 1 - r, c);
      EXPECT_EQ(point.x(), 0.5 * static_cast<double>(c));
      EXPECT_EQ(point.y(), 0.5 * static_cast<double>(heights.rows - 1 - r));
      EXPECT_DOUBLE_EQ(point.z(), heights.values[r * heights.columns + c] * scale);
    }
  }
}

std::string text_of(const Heights& heights, const char* separator = " ") {
  std::string text;
  for (std::size_t i = 0; i < heights.values.size(); ++i) {
    if (i > 0) text += i % heights.columns == 0 && *separator == ' ' ? "\n" : separator;
    text += std::to_string(heights.values[i]);
  }
  return text;
}

TEST(PgmReader, PicturesAreReadBack) {
  const ReadOptions options{.pitch_mm = 0.5, .height_mm = 4.0};
  const proof::Trials trials{500};
  for (const std::uint64_t seed : trials) {
    for (const int white : {1, 200, 255, 256, 65'535}) {
      const Heights heights = random_heights(seed, white);
      const std::string size = fmt::format("{} {}", heights.columns, heights.rows);
      const std::string text =
          fmt::format("P2 # text\n# more\n{}\n{}\n{}\n", size, white, text_of(heights));
      expect_grid(read_surface(text, "f", options), heights, 4.0 / white);
      std::string bytes = fmt::format("P5\n{}\n{}\n", size, white);
      for (const int value : heights.values) {
        if (white > 255) bytes += static_cast<char>(value / 256);
        bytes += static_cast<char>(value % 256);
      }
      expect_grid(read_surface(bytes, "f", options), heights, 4.0 / white);
    }
  }
}

TEST(PgmReader, BadPicturesAreRefused) {
  const ReadOptions options{.pitch_mm = 0.5, .height_mm = 4.0};
  EXPECT_THAT(refusal_of("P2 2 2 9 1 2 3 4"), HasSubstr("give it in mm with --pitch"));
  EXPECT_THAT(refusal_of("P2 2 2 9 1 2 3 4", {.pitch_mm = 1.0}), HasSubstr("--height"));
  EXPECT_THAT(refusal_of("P2 2 2 9 1 2 3 10", options),
              HasSubstr("10 in row 2, column 2 is above"));
  EXPECT_THAT(refusal_of("P2 2 2\n9 1 2 x 4 ", options),
              StartsWith("f:2: `x` is not a whole number"));
  EXPECT_THAT(refusal_of("P2 2 2 99 11 22 3 ", options), HasSubstr("ends too early"));
  EXPECT_THAT(refusal_of("P2 2", options), HasSubstr("ends too early"));
  EXPECT_THAT(refusal_of("P5 2 2 255\nabc", options), HasSubstr("needs 1 more bytes"));
  EXPECT_THAT(refusal_of("P5 2 2 256\nabcdefg", options), HasSubstr("needs 1 more bytes"));
  EXPECT_THAT(refusal_of("P5 1 9 255\nabcdefghi", options), HasSubstr("has 9 rows of 1 heights"));
  EXPECT_THAT(refusal_of("P5 2 2 0\nabcd", options), HasSubstr("its value of white is 0"));
  EXPECT_THAT(refusal_of("P5 2 2 65536\nabcd", options), HasSubstr("its value of white is 65536"));
  EXPECT_THAT(refusal_of("P5 4000000000 4000000000 255\n", options), HasSubstr("are too many"));
  EXPECT_THAT(refusal_of("P5 18446744073709551615 2 255\n", options), HasSubstr("are too many"));
  EXPECT_THAT(refusal_of("P5 5000 5000 255\n", options), HasSubstr("needs 25000000 more bytes"));
}

TEST(AscReader, GridsAreReadBack) {
  const proof::Trials trials{500};
  for (const std::uint64_t seed : trials) {
    Heights heights = random_heights(seed, 9);
    // The grid must be smooth: among random heights, single ones would be outliers.
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
      heights.values[i] = heights.values[i] % 2 + static_cast<int>(i % heights.columns);
    }
    const std::string text = fmt::format(
        "ncols {}\nnrows {}\nxllcorner -12.5\nyllcorner -12.5\ncellsize 25\nNODATA_value -1\n{}\n",
        heights.columns,
        heights.rows,
        text_of(heights));
    expect_grid(read_surface(text, "f", {.unit_mm = 0.02}), heights, 0.02);
  }
}

TEST(AscReader, MiddlesOfCellsAndOtherKeys) {
  const SurfaceInput input = read_surface(
      "NCOLS 2\r\nNROWS 2\r\nXLLCENTER 10\r\nYLLCENTER 20\r\nDX 2\r\nDY 3\r\n1 2\r\n3 4\r\n",
      "f",
      {});
  EXPECT_EQ(input.grid->points,
            (std::vector<Eigen::Vector3d>{{10, 20, 3}, {12, 20, 4}, {10, 23, 1}, {12, 23, 2}}));
}

TEST(AscReader, TerrainInMetresTakesThePitchAndTheHeightOfTheOptions) {
  const std::string text =
      "ncols 3\nnrows 2\nxllcorner 500000\nyllcorner 5e6\ncellsize 30\n"
      "1500 1600 1700\n1500 1550 1600\n";
  EXPECT_THAT(refusal_of(text, {.unit_mm = 1000.0}), HasSubstr("move the origin"));
  const SurfaceInput input =
      read_surface(text, "f", {.unit_mm = 1000.0, .pitch_mm = 0.5, .height_mm = 2.0});
  EXPECT_EQ(input.grid->points,
            (std::vector<Eigen::Vector3d>{
                {0, 0, 0}, {0.5, 0, 0.5}, {1, 0, 1}, {0, 0.5, 0}, {0.5, 0.5, 1}, {1, 0.5, 2}}));
}

TEST(AscReader, MissingHeightsAreRefusedAndFilled) {
  std::string text = "ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  EXPECT_THAT(
      refusal_of(text + "1 1 1 1\n1 -9999 nan 1\n1 1 1 1\n1 1 1 1\n"),
      StartsWith("f:7: 2 heights are missing at row 2, column 2; row 2, column 3; measure"));
  text += "NODATA_value 0\n1 1 1 1\n1 0 1 1\n1 1 1 1\n1 1 1 0\n";
  EXPECT_THAT(refusal_of(text), StartsWith("f:8: 2 heights are missing at row 2, column 2; row 4"));
  const SurfaceInput input = read_surface(text, "f", {.repair = true});
  for (const Eigen::Vector3d& point : input.grid->points) EXPECT_DOUBLE_EQ(point.z(), 1.0);
  EXPECT_THAT(input.notes,
              ElementsAre("f: 2 missing heights are filled from their neighbours, at row 2, column "
                          "2; row 4, column 4"));
}

TEST(AscReader, BadGridsAreRefused) {
  const std::string start = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  EXPECT_THAT(refusal_of(start + "1 2 3\n"),
              StartsWith("f:7: ends in row 2, after 3 heights of 4"));
  EXPECT_THAT(refusal_of(start + "1 2\n3 4\n5\n"), StartsWith("f:8: has more than 4 heights"));
  EXPECT_THAT(refusal_of(start + "1 2\n3 x\n"),
              StartsWith("f:7: `x` in row 2, column 2 is not a finite number"));
  EXPECT_THAT(refusal_of(start + "1 2\n3 inf\n"), HasSubstr("column 2 is not a finite number"));
  EXPECT_THAT(refusal_of("ncols 2\nnrows 2\nfoo 3\n1 2 3 4\n"), StartsWith("f:3: `foo 3` is no"));
  EXPECT_THAT(refusal_of("ncols 2\nnrows 2\n1 2 3 4\n"), HasSubstr("no cellsize above 0"));
  EXPECT_THAT(refusal_of("ncols 2.5\nnrows 2\n1 2 3 4\n"), HasSubstr("not a whole number"));
  EXPECT_THAT(refusal_of("ncols -2\nnrows 2\n1 2 3 4\n"), HasSubstr("not a whole number"));
  EXPECT_THAT(refusal_of("ncols 1\nnrows 2\n1 2\n"), HasSubstr("2 rows of 1 heights"));
  EXPECT_THAT(refusal_of("ncols 30000\nnrows 30000\n1 2\n"), HasSubstr("too many"));
  EXPECT_THAT(refusal_of("ncols 3000\nnrows 3000\ncellsize 1\n1 2\n"), HasSubstr("too short"));
  EXPECT_THAT(refusal_of("ncols 2\nnrows 2\nxllcorner nan\ncellsize 1\n1 2 3 4"),
              HasSubstr("finite"));
}

TEST(JsonHeights, AreReadBack) {
  const proof::Trials trials{300};
  for (const std::uint64_t seed : trials) {
    Heights heights = random_heights(seed, 1);
    const std::string text = fmt::format(R"({{"width": {}, "height": {}, "values": [{}]}})",
                                         heights.columns,
                                         heights.rows,
                                         text_of(heights, ","));
    expect_grid(read_surface(text, "f", {.unit_mm = 0.05, .pitch_mm = 0.5}), heights, 0.05);
  }
}

TEST(JsonHeights, MissingOnesAreFilled) {
  const std::string text = R"({"width": 3, "height": 3, "values": [1,1,1,1,null,1,1,1,3]})";
  EXPECT_THAT(refusal_of(text, {.pitch_mm = 1.0}),
              StartsWith("f: 1 heights are missing at row 2, column 2"));
  EXPECT_EQ(read_surface(text, "f", {.pitch_mm = 1.0, .repair = true}).grid->at(1, 1).z(), 1.0);
  EXPECT_EQ(read_surface(text, "f", {.pitch_mm = 1.0, .height_mm = 5.0, .repair = true})
                .grid->at(0, 2)
                .z(),
            5.0);
}

TEST(JsonHeights, OtherDocumentsAreRefused) {
  const ReadOptions options{.pitch_mm = 1.0};
  EXPECT_EQ(refusal_of("{\n\"width\": 2,\n]", options),
            "f:3: broken JSON at byte 14; export it again");
  EXPECT_THAT(refusal_of("[1, 2]", options), HasSubstr("has no whole number `width`"));
  EXPECT_THAT(refusal_of(R"({"width": 2})", options), HasSubstr("`height`"));
  EXPECT_THAT(refusal_of(R"({"width": 2, "height": 2.5})", options), HasSubstr("`height`"));
  EXPECT_THAT(refusal_of(R"({"width": 2, "height": 2})", options), HasSubstr("no list `values`"));
  EXPECT_THAT(refusal_of(R"({"width": 2, "height": 2, "values": [1]})", options),
              HasSubstr("has 1 values for 2 rows of 2"));
  EXPECT_THAT(refusal_of(R"({"width": 2, "height": 2, "values": [1, 2, "x", 4]})", options),
              HasSubstr("/values/2 in row 2, column 1 is neither"));
  EXPECT_THAT(refusal_of(R"({"width": 2, "height": 2, "values": [1, 2, 3, 4]})"),
              HasSubstr("--pitch"));
  EXPECT_THAT(refusal_of(R"({"width": 1e999})", options), HasSubstr("too great"));
  EXPECT_THAT(refusal_of(R"({"width": 3000000000, "height": 3000000000})", options),
              HasSubstr("too many"));
  EXPECT_THAT(refusal_of(std::string(100'000, '['), options), HasSubstr("nested too deeply"));
}

}  // namespace
}  // namespace sim::surface
