#include "host-sim/plot/svg_render.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace sim {
namespace {

using Error = std::unique_ptr<GError, Releaser<g_error_free>>;

}  // namespace

void fail_to_draw(const std::string& file, std::string_view reason) {
  throw std::runtime_error{fmt::format("cannot draw {}: {}", file, reason)};
}

SvgHandle load_svg(const std::string& file, std::string_view svg) {
  GError* error = nullptr;
  const auto* bytes = reinterpret_cast<const guint8*>(svg.data());
  SvgHandle handle{rsvg_handle_new_from_data(bytes, svg.size(), &error)};
  const Error owned_error{error};
  if (!handle) fail_to_draw(file, owned_error->message);
  return handle;
}

void render_svg(const std::string& file,
                RsvgHandle& handle,
                cairo_surface_t& surface,
                double width,
                double height) {
  const CairoContext context{cairo_create(&surface)};
  const RsvgRectangle viewport{.x = 0.0, .y = 0.0, .width = width, .height = height};
  GError* error = nullptr;
  const bool is_drawn = rsvg_handle_render_document(&handle, context.get(), &viewport, &error) != 0;
  const Error owned_error{error};
  if (!is_drawn) fail_to_draw(file, owned_error->message);
  const cairo_status_t status = cairo_status(context.get());
  if (status != CAIRO_STATUS_SUCCESS) fail_to_draw(file, cairo_status_to_string(status));
}

cairo_status_t append_to_text(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace sim
