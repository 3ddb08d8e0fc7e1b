#include "host-sim/plot/png.hpp"

#include <cairo.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

template <auto Release>
struct Releaser {
  template <typename Object>
  void operator()(Object* object) const {
    Release(object);
  }
};
using Handle = std::unique_ptr<RsvgHandle, Releaser<g_object_unref>>;
using Surface = std::unique_ptr<cairo_surface_t, Releaser<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Releaser<cairo_destroy>>;
using Error = std::unique_ptr<GError, Releaser<g_error_free>>;

[[noreturn]] void fail(const std::string& file, std::string_view reason) {
  throw std::runtime_error{fmt::format("cannot draw {}: {}", file, reason)};
}

Handle load(const std::string& file, std::string_view svg) {
  GError* error = nullptr;
  const auto* bytes = reinterpret_cast<const guint8*>(svg.data());
  Handle handle{rsvg_handle_new_from_data(bytes, svg.size(), &error)};
  const Error owned_error{error};
  if (!handle) fail(file, owned_error->message);
  return handle;
}

/// Height for the width that keeps the shape of the document.
int height_for(const std::string& file, RsvgHandle& handle, int width_px) {
  gdouble width = 0.0;
  gdouble height = 0.0;
  if (rsvg_handle_get_intrinsic_size_in_pixels(&handle, &width, &height) == 0 || width <= 0.0) {
    fail(file, "the document has no size");
  }
  return static_cast<int>(std::lround(height * width_px / width));
}

void render(const std::string& file, RsvgHandle& handle, cairo_surface_t& surface) {
  const Context context{cairo_create(&surface)};
  const RsvgRectangle viewport{.x = 0.0,
                               .y = 0.0,
                               .width = cairo_image_surface_get_width(&surface) * 1.0,
                               .height = cairo_image_surface_get_height(&surface) * 1.0};
  GError* error = nullptr;
  const bool is_drawn = rsvg_handle_render_document(&handle, context.get(), &viewport, &error) != 0;
  const Error owned_error{error};
  if (!is_drawn) fail(file, owned_error->message);
  const cairo_status_t status = cairo_status(context.get());
  if (status != CAIRO_STATUS_SUCCESS) fail(file, cairo_status_to_string(status));
}

cairo_status_t append(void* png, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(png)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

void write_png(const std::string& file, std::string_view svg, int width_px) {
  const Handle handle = load(file, svg);
  const int height_px = height_for(file, *handle, width_px);
  const Surface surface{cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px)};
  render(file, *handle, *surface);
  std::string png;
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), append, &png);
  if (status != CAIRO_STATUS_SUCCESS) fail(file, cairo_status_to_string(status));
  write_file(file, png);
}

}  // namespace sim
