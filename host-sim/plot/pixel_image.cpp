#include "host-sim/plot/pixel_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "host-sim/picture/base64.hpp"
#include "host-sim/plot/svg_render.hpp"

namespace sim {

PixelImage::PixelImage(int width, int height)
    : width_{width},
      height_{height},
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

std::string PixelImage::png(const std::string& file) const {
  const CairoSurface surface{cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width_, height_)};
  unsigned char* const bytes = cairo_image_surface_get_data(surface.get());
  if (bytes == nullptr) fail_to_draw(file, "it has too many pixels");
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int row = 0; row < height_; ++row) {
    auto* const target = reinterpret_cast<std::uint32_t*>(bytes + std::ptrdiff_t{row} * stride);
    std::copy_n(pixels_.begin() + std::ptrdiff_t{row} * width_, width_, target);
  }
  cairo_surface_mark_dirty(surface.get());
  std::string png;
  const cairo_status_t status =
      cairo_surface_write_to_png_stream(surface.get(), append_to_text, &png);
  if (status != CAIRO_STATUS_SUCCESS) fail_to_draw(file, cairo_status_to_string(status));
  return png;
}

void add_image(std::string& out, const std::string& file, const PixelImage& image, const Box& box) {
  add_png(out, image.png(file), box);
}

void add_png(std::string& out, const std::string& png, const Box& box, Blend blend) {
  fmt::format_to(std::back_inserter(out),
                 R"(<image x="{:.3f}" y="{:.3f}" width="{:.3f}" height="{:.3f}" )"
                 R"(preserveAspectRatio="none"{} href="data:image/png;base64,{}"/>)"
                 "\n",
                 box.left_px,
                 box.top_px,
                 box.width_px,
                 box.height_px,
                 blend == Blend::kDarken ? R"( style="mix-blend-mode:multiply")" : "",
                 picture::base64_encoded(png));
}

}  // namespace sim
