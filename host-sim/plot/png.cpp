#include "host-sim/plot/png.hpp"

#include <cmath>

#include "host-sim/plot/svg_render.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

/// Returns the height of the image, px, at which the document keeps its proportions for the given
/// width.
int height_for(const std::string& file, RsvgHandle& handle, int width_px) {
  gdouble width = 0.0;
  gdouble height = 0.0;
  if (rsvg_handle_get_intrinsic_size_in_pixels(&handle, &width, &height) == 0 || width <= 0.0) {
    fail_to_draw(file, "the document has no size");
  }
  return static_cast<int>(std::lround(height * width_px / width));
}

}  // namespace

void write_png(const std::string& file, std::string_view svg, int width_px) {
  const SvgHandle handle = load_svg(file, svg);
  const int height_px = height_for(file, *handle, width_px);
  const CairoSurface surface{cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px)};
  render_svg(file, *handle, *surface, width_px, height_px);
  std::string png;
  const cairo_status_t status =
      cairo_surface_write_to_png_stream(surface.get(), append_to_text, &png);
  if (status != CAIRO_STATUS_SUCCESS) fail_to_draw(file, cairo_status_to_string(status));
  write_file(file, png);
}

}  // namespace sim
