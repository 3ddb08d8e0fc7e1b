#include <cairo-pdf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <numbers>

#include "tests/host-sim/import/support.hpp"

namespace sim::drawing {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

constexpr double kPointsPerMm = 72.0 / 25.4;

cairo_status_t keep(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

/// Returns a PDF of 100 mm by 80 mm, with y upwards and mm as units.
std::string pdf_of(const std::function<void(cairo_t*)>& draw) {
  std::string pdf;
  cairo_surface_t* const surface =
      cairo_pdf_surface_create_for_stream(&keep, &pdf, 100.0 * kPointsPerMm, 80.0 * kPointsPerMm);
  cairo_t* const context = cairo_create(surface);
  cairo_translate(context, 0.0, 80.0 * kPointsPerMm);
  cairo_scale(context, kPointsPerMm, -kPointsPerMm);
  cairo_set_line_width(context, 0.1);
  draw(context);
  cairo_destroy(context);
  cairo_surface_destroy(surface);
  return pdf;
}

TEST(Pdf, StrokesAndFillsArePathsInTheirPlace) {
  const Drawing drawn = read(pdf_of([](cairo_t* context) {
    cairo_set_source_rgb(context, 1.0, 0.0, 0.0);
    cairo_rectangle(context, 10.0, 20.0, 30.0, 40.0);
    cairo_stroke(context);
    cairo_set_source_rgb(context, 0.0, 0.0, 1.0);
    cairo_arc(context, 70.0, 40.0, 15.0, 0.0, 2.0 * std::numbers::pi);
    cairo_fill(context);
  }));
  ASSERT_THAT(drawn.contours, SizeIs(2));
  EXPECT_NEAR(drawn.contours[0].area_mm2, 1200.0, 0.01);
  Place least{100.0, 100.0};
  for (const Shape& shape : drawn.contours[0].shapes) least = least.cwiseMin(start_of(shape));
  // The size of the page is rounded to three decimals of a point.
  EXPECT_NEAR(distance(least, {10.0, 20.0}), 0.0, 2e-3);
  EXPECT_EQ(drawn.layers.at(drawn.contours[0].entity.layer).name, "");
  EXPECT_EQ(drawn.layers.at(drawn.contours[0].entity.layer).colour, "#ff0000");
  EXPECT_NEAR(drawn.contours[1].area_mm2, 225.0 * std::numbers::pi, 0.3);
  EXPECT_EQ(drawn.layers.at(drawn.contours[1].entity.layer).colour, "#0000ff");
  EXPECT_EQ(drawn.contours[1].entity.line, 0U);
  EXPECT_FALSE(drawn.has_errors());
}

TEST(Pdf, FurtherPagesAreTold) {
  const Drawing drawn = read(pdf_of([](cairo_t* context) {
    cairo_rectangle(context, 10.0, 20.0, 30.0, 40.0);
    cairo_stroke(context);
    cairo_show_page(context);
    cairo_rectangle(context, 10.0, 20.0, 30.0, 40.0);
    cairo_stroke(context);
  }));
  EXPECT_THAT(drawn.contours, SizeIs(1));
  ASSERT_THAT(kinds_of(drawn), Contains(FaultKind::kNote));
  EXPECT_THAT(drawn.faults.back().reason, HasSubstr("it has 2 pages"));
}

TEST(Pdf, ThatIsBrokenIsRefused) {
  const Drawing drawn = read("%PDF-1.7\nnothing");
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kUnreadable));
  EXPECT_THAT(drawn.faults[0].reason, HasSubstr("broken PDF"));
}

}  // namespace
}  // namespace sim::drawing
