#include "host-sim/plot/pdf.hpp"

#include <cairo-pdf.h>

#include "host-sim/plot/svg_render.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {

void write_pdf(const std::string& file,
               const std::vector<std::string>& pages,
               const std::string& title) {
  std::string pdf;
  CairoSurface surface{
      cairo_pdf_surface_create_for_stream(append_to_text, &pdf, kPageWidthPt, kPageHeightPt)};
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
  // Without this empty text, cairo would write the present date.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  for (const std::string& page : pages) {
    const SvgHandle handle = load_svg(file, page);
    render_svg(file, *handle, *surface, kPageWidthPt, kPageHeightPt);
    cairo_surface_show_page(surface.get());
  }
  cairo_surface_finish(surface.get());
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS) fail_to_draw(file, cairo_status_to_string(status));
  write_file(file, pdf);
}

}  // namespace sim
