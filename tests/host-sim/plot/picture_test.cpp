#include "host-sim/plot/picture.hpp"

#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <librsvg/rsvg.h>

#include <set>
#include <stdexcept>
#include <system_error>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/plot/legend_content.hpp"
#include "host-sim/plot/path_recorder.hpp"
#include "host-sim/plot/png.hpp"
#include "host-sim/plot/view.hpp"
#include "tests/host-sim/plot/step_pen.hpp"
#include "tests/host-sim/trace/scratch_file.hpp"

namespace sim {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

Path small_job() {
  PathRecorder recorder{{80.0F, 80.0F, 80.0F, 10.0F, 10.0F, 10.0F}};
  StepPen pen{recorder, 80.0};
  pen.line({20.0, 10.0}, 100.0, 2'000.0);
  pen.set_duty(1.0F);
  pen.arc({10.0, 10.0}, 1.0, 50.0, 500.0);
  pen.end();
  return recorder.path();
}

bool is_well_formed(const std::string& svg) {
  const auto* bytes = reinterpret_cast<const guint8*>(svg.data());
  GError* error = nullptr;
  RsvgHandle* handle = rsvg_handle_new_from_data(bytes, svg.size(), &error);
  if (handle == nullptr) {
    ADD_FAILURE() << error->message;
    g_error_free(error);
    return false;
  }
  g_object_unref(handle);
  return true;
}

TEST(Picture, ShowsPathLegendAndDimensions) {
  const std::string svg = draw_svg(small_job(), {.title = "ring.nc"});
  EXPECT_TRUE(is_well_formed(svg));
  for (const char* text : {"ring.nc",
                           "20.0 × 20.0 mm",
                           "Speed, mm/min",
                           "cut, kerf 0.1 mm",
                           ">rapid<",
                           ">start<",
                           ">end<",
                           "stroke-dasharray",
                           "3000"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
  EXPECT_THAT(svg, Not(HasSubstr("beam off")));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(Picture, DrawsNoKerfWhenItIsZero) {
  const std::string svg = draw_svg(small_job(), {.title = "", .kerf_width_mm = 0.0});
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr(">cut<"));
}

TEST(Picture, SaysWhenThereIsNothingToSee) {
  const std::string empty = draw_svg({}, {.title = "empty.nc"});
  EXPECT_TRUE(is_well_formed(empty));
  EXPECT_THAT(empty, HasSubstr("no motion"));
  const std::string drill = draw_svg({{{}, {}}, 1.0}, {.title = "drill.nc"});
  EXPECT_TRUE(is_well_formed(drill));
  EXPECT_THAT(drill, HasSubstr("no motion in X and Y"));
  EXPECT_THAT(drill, Not(HasSubstr("nan")));
}

TEST(Picture, SurvivesAnyTitle) {
  const std::string svg =
      draw_svg({}, {.title = "a<b>&\"c\"\x01\xff\xed\xa0\x80\xef\xbf\xbf ä.nc"});
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("a&lt;b&gt;&amp;&quot;c&quot; "));
  EXPECT_THAT(svg, HasSubstr(" ä.nc"));
}

TEST(Picture, SurvivesAnyShape) {
  for (const double width_mm : {0.0, 1e-3, 1.0, 1e5}) {
    for (const double height_mm : {1e-3, 50.0, 1e5}) {
      const PathVertex end{width_mm, height_mm, 10.0F, Move::kCut};
      const std::string svg = draw_svg({{{}, end}, 1.0}, {});
      EXPECT_TRUE(is_well_formed(svg));
      EXPECT_LT(svg.size(), 50'000U);
    }
  }
}

TEST(Picture, StaysBelowTwoMegabytesForTheLongestPath) {
  Path path;
  for (std::size_t i = 0; i < PathRecorder::kMaxVertices; ++i) {
    const double angle = 0.7 * static_cast<double>(i);
    const double radius = 1e-2 * static_cast<double>(i);
    const auto speed = static_cast<float>(i * 7'919 % 100);
    path.vertices.push_back(
        {radius * std::cos(angle), radius * std::sin(angle), speed, Move::kCut});
  }
  const std::string svg = draw_svg(path, {.title = "worst"});
  EXPECT_LT(svg.size(), 2'000'000U);
  EXPECT_TRUE(is_well_formed(svg));
}

/// Returns a straight cut of 100 mm at 50 mm/s, with one scattered stretch and some steps with the
/// beam off.
std::vector<PathVertex> scattered_line() {
  return {{},
          {50.0, 0.0, 50.4F, Move::kCut},
          {50.05, 0.0, 55.0F, Move::kCut},
          {50.06, 0.0, 50.0F, Move::kFeed},
          {100.0, 0.0, 50.0F, Move::kCut}};
}

TEST(LegendContent, IsNotMisledByScatterAndDots) {
  const LegendContent content = legend_content(scattered_line(), 0.1, 10.0);
  EXPECT_EQ(content.top_speed_mm_min, 3'000.0);
  EXPECT_EQ(content.tick_speed_mm_min, 500.0);
  EXPECT_TRUE(content.has_cut);
  EXPECT_FALSE(content.has_feed);
  EXPECT_FALSE(content.has_travel);
}

TEST(LegendContent, HasNoScaleWithoutFeed) {
  EXPECT_EQ(legend_content({}, 0.1, 10.0).top_speed_mm_min, 0.0);
  const LegendContent content = legend_content({{}, {50.0, 0.0}}, 0.1, 10.0);
  EXPECT_EQ(content.top_speed_mm_min, 0.0);
  EXPECT_TRUE(content.has_travel);
}

TEST(ColourMap, GetsLighterAllTheWayAndStaysVisibleOnWhite) {
  double last = -1.0;
  for (int i = 0; i <= 100; i += 5) {
    const Colour colour = speed_colour(0.01 * i);
    const double lightness = 0.2126 * colour.red + 0.7152 * colour.green + 0.0722 * colour.blue;
    EXPECT_GT(lightness, last) << i;
    EXPECT_LT(lightness, 180.0) << i;
    last = lightness;
  }
  EXPECT_EQ(hex(speed_colour(-1.0)), "#0d0887");
  EXPECT_EQ(hex(speed_colour(2.0)), "#fb9f3a");
}

TEST(View, RoundsStepsUpToOneTwoFive) {
  EXPECT_DOUBLE_EQ(round_step(1.0), 1.0);
  EXPECT_DOUBLE_EQ(round_step(1.01), 2.0);
  EXPECT_DOUBLE_EQ(round_step(0.021), 0.05);
  EXPECT_DOUBLE_EQ(round_step(600.0), 1000.0);
}

/// Returns the colours of a PNG file; none if it cannot be decoded.
std::set<std::uint32_t> colours_of(const std::string& file, int& width_px) {
  cairo_surface_t* image = cairo_image_surface_create_from_png(file.c_str());
  std::set<std::uint32_t> colours;
  width_px = cairo_image_surface_get_width(image);
  const int height_px = cairo_image_surface_get_height(image);
  for (int y = 0; y < height_px; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(
        cairo_image_surface_get_data(image) + y * cairo_image_surface_get_stride(image));
    for (int x = 0; x < width_px; ++x) colours.insert(row[x] & 0xFFFFFFU);
  }
  cairo_surface_destroy(image);
  return colours;
}

TEST(Png, DecodesAndShowsTheColoursOfThePath) {
  const ScratchFile file{".png"};
  write_png(file.path(), draw_svg(small_job(), {.title = "ring.nc"}), 800);
  int width_px = 0;
  const auto colours = colours_of(file.path(), width_px);
  EXPECT_EQ(width_px, 800);
  EXPECT_TRUE(colours.contains(0xFFFFFFU));
  EXPECT_GT(colours.size(), 100U);
}

TEST(Png, SaysWhichFileCannotBeDrawnOrWritten) {
  EXPECT_THAT([] { write_png("/tmp/p.png", "<svg"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("cannot draw /tmp/p.png")));
  EXPECT_THAT([] { write_png("/no/such/p.png", draw_svg({}, {}), 100); },
              ThrowsMessage<std::system_error>(HasSubstr("cannot create /no/such/p.png")));
}

}  // namespace
}  // namespace sim
