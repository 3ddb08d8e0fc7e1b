#include "host-sim/plot/stock_picture.hpp"

#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/plot/png.hpp"
#include "host-sim/stock/carver.hpp"
#include "tests/host-sim/trace/scratch_file.hpp"

namespace sim {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The colours of a PNG.
class Pixels {
 public:
  explicit Pixels(const std::string& file)
      : surface_{cairo_image_surface_create_from_png(file.c_str())} {}
  ~Pixels() { cairo_surface_destroy(surface_); }
  Pixels(const Pixels&) = delete;
  Pixels& operator=(const Pixels&) = delete;

  /// Returns the number of pixels of this colour.
  [[nodiscard]] int count(const Colour& colour) const {
    int found = 0;
    const int height = cairo_image_surface_get_height(surface_);
    for (int y = 0; y < height; ++y) {
      const auto* row = reinterpret_cast<const std::uint32_t*>(
          cairo_image_surface_get_data(surface_) +
          static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface_));
      for (int x = 0; x < cairo_image_surface_get_width(surface_); ++x) {
        const std::uint32_t wanted = static_cast<std::uint32_t>(colour.red) << 16U |
                                     static_cast<std::uint32_t>(colour.green) << 8U | colour.blue;
        if ((row[x] & 0xFFFFFFU) == wanted) ++found;
      }
    }
    return found;
  }

 private:
  cairo_surface_t* surface_;
};

stock::Stock slotted(double depth_mm) {
  stock::Stock carved{{0.0, 0.0, 40.0, 20.0, 0.0, -5.0}, 0.1};
  stock::Carver carver{carved, {.kind = stock::CutterKind::kFlat, .diameter_mm = 10.0}};
  carver.sweep({{-10.0, 10.0, -depth_mm}, {50.0, 10.0, -depth_mm}});
  return carved;
}

TEST(StockPicture, ShowsHalfOfThePlanCutToItsDepth) {
  const stock::Stock carved = slotted(3.0);
  const std::string svg = draw_stock("out.png", carved, "slot.nc", "600 mm³ removed");
  for (const char* text : {"slot.nc", "600 mm³ removed", "Depth, mm", ">3<", "data:image/png"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
  EXPECT_THAT(svg, Not(HasSubstr(">start<")));
  const ScratchFile png{".png"};
  write_png(png.path(), svg);
  const Pixels pixels{png.path()};
  const double cut = pixels.count(speed_colour(0.0));
  const double uncut = pixels.count({0xd9, 0xdc, 0xe0});
  EXPECT_GT(cut, 100'000);
  EXPECT_NEAR(cut / uncut, 1.0, 0.05);
}

TEST(StockPicture, OfAnUncutStockHasNoScale) {
  const std::string svg = draw_stock("out.png", slotted(-1.0), "air.nc", "");
  EXPECT_THAT(svg, Not(HasSubstr("Depth, mm")));
  EXPECT_THAT(svg, HasSubstr("data:image/png"));
}

}  // namespace
}  // namespace sim
