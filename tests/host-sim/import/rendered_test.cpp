/// Compares our reader of SVG with an independent one: librsvg draws the document, cairo draws the
/// outlines that our reader returns, and both pictures must be equal.

#include <cairo.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>
#include <regex>

#include "host-sim/import/curve_measure.hpp"
#include "tests/host-sim/import/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::drawing {
namespace {

constexpr int kPixels = 400;  ///< Width of the picture, pixels for 100 mm.

// cairo, which draws for librsvg, deviates from curves by up to a tenth of a pixel, always to the
// same side; by half of that on average.
constexpr double kChordPx = 0.05;

double outline_px(const Drawing& drawn) {
  double length = 0.0;
  for (const DrawnContour& contour : drawn.contours) length += contour.length_mm;
  return length * kPixels / 100.0;
}

/// Returns an upper bound of the area of loops that notes report as left out, because they are
/// narrower than any beam.
double left_out_px(const Drawing& drawn) {
  constexpr double kPxPerMm2 = kPixels * kPixels / 1.0e4;
  static const std::regex kLoops{"(\\d+) (?:loops? )?smaller than .* has ([0-9.]+) mm2"};
  double area = 0.0;
  for (const Fault& fault : drawn.faults) {
    std::smatch found;
    if (fault.kind != FaultKind::kMended || !std::regex_search(fault.reason, found, kLoops))
      continue;
    area += std::stod(found[1]) * std::stod(found[2]);
  }
  return area * kPxPerMm2;
}

/// Coverage of black on an empty ground, 0…255 for each pixel.
class Canvas {
 public:
  Canvas()
      : surface_{cairo_image_surface_create(CAIRO_FORMAT_ARGB32, kPixels, kPixels),
                 cairo_surface_destroy},
        context_{cairo_create(surface_.get()), cairo_destroy} {}

  bool draw(const std::string& svg) {
    const std::unique_ptr<RsvgHandle, decltype(&g_object_unref)> handle{
        rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), nullptr),
        g_object_unref};
    if (!handle) return false;
    const RsvgRectangle all{0.0, 0.0, kPixels, kPixels};
    return rsvg_handle_render_document(handle.get(), context_.get(), &all, nullptr) != 0;
  }

  void draw(const Drawing& drawn) {
    constexpr double kPxPerMm = kPixels / 100.0;
    cairo_set_fill_rule(context_.get(), CAIRO_FILL_RULE_EVEN_ODD);
    for (const DrawnContour& contour : drawn.contours) {
      cairo_new_sub_path(context_.get());
      for (const Place& place : outline_of(contour.shapes, 0.001)) {
        cairo_line_to(context_.get(), place.x() * kPxPerMm, (100.0 - place.y()) * kPxPerMm);
      }
      cairo_close_path(context_.get());
    }
    cairo_fill(context_.get());
  }

  [[nodiscard]] int at(int x, int y) const {
    const unsigned char* const row =
        cairo_image_surface_get_data(surface_.get()) +
        static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface_.get());
    std::uint32_t pixel = 0;
    std::copy_n(
        row + static_cast<std::ptrdiff_t>(x) * 4, 4, reinterpret_cast<unsigned char*>(&pixel));
    return static_cast<int>(pixel >> 24);
  }

  void flush() { cairo_surface_flush(surface_.get()); }

 private:
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context_;
};

class RandomDocument {
 public:
  explicit RandomDocument(std::uint64_t seed) : random_{seed} {}

  std::string document() {
    const double w = random_.between(20.0, 200.0);
    const double h = random_.between(20.0, 200.0);
    static constexpr const char* kAspects[]{
        "none", "xMinYMax", "xMidYMid", "xMaxYMin meet", "xMidYMin slice"};
    return fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
        "width='100mm' height='10cm' viewBox='{} {} {} {}' preserveAspectRatio='{}'>{}</svg>",
        number(-5.0, 5.0),
        number(-5.0, 5.0),
        w,
        h,
        kAspects[random_.below(5)],
        group(random_.below(3)));
  }

 private:
  std::string number(double least, double most) {
    return fmt::format("{:.3f}", random_.between(least, most));
  }
  std::string place() {
    return number(5.0, 80.0) + (random_.chance(0.5) ? "," : " ") + number(5.0, 80.0);
  }
  std::string way() { return number(-40.0, 40.0) + " " + number(-40.0, 40.0); }

  std::string transform() {
    switch (random_.below(6)) {
      case 0:
        return "translate(" + way() + ")";
      case 1:
        return "rotate(" + number(-180.0, 180.0) + ", 30, 30)";
      case 2:
        return "scale(" + number(0.5, 1.5) + ")";
      case 3:
        return "skewX(" + number(-30.0, 30.0) + ") scale(1 -1) translate(0 -60)";
      case 4:
        return "matrix(0.8 0.2 -.3 1.1 5 3)";
      default:
        return "";
    }
  }

  std::string group(std::size_t depth) {
    if (depth == 0) return shape();
    return "<g transform='" + transform() + "'>" + group(depth - 1) + "</g>";
  }

  std::string shape() {
    switch (random_.below(6)) {
      case 0:
        return fmt::format("<rect x='{}' y='{}' width='{}' height='{}' rx='{}' ry='{}'/>",
                           number(0, 30),
                           number(0, 30),
                           number(5, 50),
                           number(5, 50),
                           number(0, 20),
                           number(0, 20));
      case 1:
        return fmt::format(
            "<circle cx='{}' cy='{}' r='{}%'/>", number(20, 60), number(20, 60), number(5, 30));
      case 2:
        return fmt::format(
            "<defs><ellipse id='e' cx='{}' cy='{}' rx='{}' ry='{}'/></defs><use xlink:href='#e' "
            "x='{}'/>",
            number(20, 60),
            number(20, 60),
            number(5, 30),
            number(5, 30),
            number(-5, 5));
      case 3:
        return "<polygon points='" + place() + " " + place() + " " + place() + "'/>";
      default:
        return "<path fill-rule='evenodd' d='" + path() + "'/>";
    }
  }

  std::string path() {
    std::string d = "M" + place();
    for (std::size_t i = 0, count = 2 + random_.below(5); i < count; ++i) d += command();
    return d + (random_.chance(0.7) ? "z" : " z m" + way() + "l" + way() + " " + way() + "Z");
  }

  std::string command() {
    const std::string flags =
        random_.chance(0.5) ? " 01" : (random_.chance(0.5) ? " 1,0 " : " 0 0 ");
    switch (random_.below(10)) {
      case 0:
        return "L" + place() + " " + place();
      case 1:
        return "h" + number(-30, 30) + "v" + number(-30, 30);
      case 2:
        return "C" + place() + " " + place() + " " + place();
      case 3:
        return "s" + way() + " " + way();
      case 4:
        return "Q" + place() + " " + place() + "T" + place();
      case 5:
        return "q" + way() + " " + way() + "t" + way() + "t" + way();
      case 6:
        return "c" + way() + " " + way() + " " + way() + "S" + place() + " " + place();
      case 7:
        return "H" + number(5, 80) + "V" + number(5, 80);
      case 8: {
        const std::string r = number(5, 40);
        return "A" + r + " " + r + " 0" + flags + place();
      }
      default:
        return "a" + number(5, 40) + "," + number(5, 40) + " " + number(-90, 90) + flags + way();
    }
  }

  proof::Random random_;
};

TEST(Rendered, WhatWeReadCoversWhatLibrsvgDraws) {
  const proof::Trials trials{1500};
  std::size_t covered = 0;
  for (const std::uint64_t seed : trials) {
    const std::string svg = RandomDocument{seed}.document();
    Canvas theirs;
    ASSERT_TRUE(theirs.draw(svg)) << svg;
    Canvas ours;
    const Drawing drawn = read(svg);
    ours.draw(drawn);
    theirs.flush();
    ours.flush();
    int differing = 0;
    double difference = 0.0;
    for (int y = 0; y < kPixels; ++y) {
      for (int x = 0; x < kPixels; ++x) {
        const int apart = ours.at(x, y) - theirs.at(x, y);
        if (std::abs(apart) > 100) ++differing;
        difference += apart / 255.0;
        covered += theirs.at(x, y) > 0 ? 1U : 0U;
      }
    }
    EXPECT_LE(differing, 12) << "KERFLINE_SEED=" << seed << ": " << svg;
    EXPECT_LE(std::abs(difference), 5.0 + kChordPx * outline_px(drawn) + left_out_px(drawn))
        << "pixels, KERFLINE_SEED=" << seed << ": " << svg;
  }
  if (!trials.judges_shares()) return;
  EXPECT_GT(covered, 0U) << "all pictures were empty";
}

}  // namespace
}  // namespace sim::drawing
