#pragma once

#include <cairo.h>
#include <librsvg/rsvg.h>

#include <memory>
#include <string>
#include <string_view>

namespace sim {

/// Frees an object of a C library when the smart pointer that owns it is destroyed.
template <auto Release>
struct Releaser {
  template <typename Object>
  void operator()(Object* object) const {
    Release(object);
  }
};
using SvgHandle = std::unique_ptr<RsvgHandle, Releaser<g_object_unref>>;
using CairoSurface = std::unique_ptr<cairo_surface_t, Releaser<cairo_surface_destroy>>;
using CairoContext = std::unique_ptr<cairo_t, Releaser<cairo_destroy>>;

/// Throws std::runtime_error with the message `cannot draw FILE: REASON`.
[[noreturn]] void fail_to_draw(const std::string& file, std::string_view reason);

/// Reads an SVG document. Throws the exception of fail_to_draw() if the document is not valid.
/// @param file name of the file, for messages
[[nodiscard]] SvgHandle load_svg(const std::string& file, std::string_view svg);

/// Draws a document over the complete surface. Throws the exception of fail_to_draw() if the
/// document cannot be drawn.
void render_svg(const std::string& file,
                RsvgHandle& handle,
                cairo_surface_t& surface,
                double width,
                double height);

/// Appends bytes to the std::string to which `text` points. It is a write function for cairo
/// streams.
cairo_status_t append_to_text(void* text, const unsigned char* bytes, unsigned int count);

}  // namespace sim
