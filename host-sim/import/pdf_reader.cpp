#include "host-sim/import/pdf_reader.hpp"

#include <cairo-svg.h>
#include <fmt/format.h>
#include <poppler.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "host-sim/import/scanner.hpp"
#include "host-sim/import/svg_reader.hpp"

namespace sim::drawing {
namespace {

// Factor by which the page is enlarged before cairo draws it. cairo rounds coordinates to 1/256 of
// a unit, which would be 1.4 µm on a page that is not enlarged.
constexpr double kFinerPage = 64.0;
constexpr double kLargestPagePt = 200'000.0;

template <auto free>
struct Freed {
  void operator()(auto* object) const { free(object); }
};

using Surface = std::unique_ptr<cairo_surface_t, Freed<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Freed<cairo_destroy>>;
using Document = std::unique_ptr<PopplerDocument, Freed<g_object_unref>>;
using Page = std::unique_ptr<PopplerPage, Freed<g_object_unref>>;
using Bytes = std::unique_ptr<GBytes, Freed<g_bytes_unref>>;
using Failure = std::unique_ptr<GError, Freed<g_error_free>>;

cairo_status_t append_bytes(void* text, const unsigned char* bytes, unsigned int count) {
  auto& all = *static_cast<std::string*>(text);
  if (all.size() + count > kMaxBytes) return CAIRO_STATUS_WRITE_ERROR;
  all.append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

/// Returns a page as an SVG document; nothing if cairo cannot draw it.
std::optional<std::string> svg_of_page(PopplerPage* page, double width_pt, double height_pt) {
  std::string svg;
  const Surface surface{cairo_svg_surface_create_for_stream(
      &append_bytes, &svg, kFinerPage * width_pt, kFinerPage * height_pt)};
  const Context context{cairo_create(surface.get())};
  cairo_scale(context.get(), kFinerPage, kFinerPage);
  poppler_page_render_for_printing(page, context.get());
  cairo_surface_finish(surface.get());
  // Removes the id that cairo gives to the page, so that it does not become the name of a layer.
  constexpr std::string_view kPageName = " id=\"surface";
  if (const std::size_t at = svg.find(kPageName); at != std::string::npos) {
    const std::size_t end = svg.find('"', at + kPageName.size());
    if (end != std::string::npos) svg.erase(at, end + 1 - at);
  }
  const bool failed = cairo_status(context.get()) != CAIRO_STATUS_SUCCESS ||
                      cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS;
  if (failed) return {};
  return svg;
}

/// Returns the hexadecimal colour of a text that begins with `r%,g%,b%)`; nothing for any other
/// text. Sets `used` to the length of the text that was read.
std::optional<std::string> hex_of_percents(std::string_view text, std::size_t& used) {
  Scanner scanner{text};
  std::string hex = "#";
  for (const char end : {',', ',', ')'}) {
    const auto percent = scanner.number();
    if (!percent || !scanner.take('%') || !scanner.take(end)) return {};
    hex += fmt::format("{:02x}", std::lround(std::clamp(*percent, 0.0, 100.0) * 2.55));
  }
  used = scanner.column() - 1;
  return hex;
}

/// Returns an SVG document with each colour such as `rgb(100%,0%,0%)` replaced by the form
/// `#ff0000`, in which users write colours.
std::string with_hex_colours(const std::string& svg) {
  constexpr std::string_view kRgb = "rgb(";
  std::string out;
  std::size_t at = 0;
  for (std::size_t next = svg.find(kRgb); next != std::string::npos; next = svg.find(kRgb, at)) {
    out.append(svg, at, next - at);
    std::size_t used = 0;
    const std::size_t values = next + kRgb.size();
    const auto hex = hex_of_percents(std::string_view{svg}.substr(values), used);
    out += hex.value_or(std::string{kRgb});
    at = values + (hex ? used : 0);
  }
  out.append(svg, at);
  return out;
}

void read_page(PopplerPage* page, Sketch& sketch) {
  double width_pt = 0.0;
  double height_pt = 0.0;
  poppler_page_get_size(page, &width_pt, &height_pt);
  const auto is_size = [](double size) { return size > 0.0 && size <= kLargestPagePt; };
  if (!is_size(width_pt) || !is_size(height_pt)) {
    return sketch.refuse(0, 0, "its page has no size, or is larger than 70 m", "export it again");
  }
  const auto svg = svg_of_page(page, width_pt, height_pt);
  if (!svg) return sketch.refuse(0, 0, "its page cannot be drawn", "export it as SVG");
  read_svg(with_hex_colours(*svg), sketch);
  sketch.forget_lines();
  sketch.scale(1.0 / kFinerPage);
}

}  // namespace

bool is_pdf(std::string_view start) { return start.starts_with("%PDF"); }

void read_pdf(const std::string& text, Sketch& sketch) {
  const Bytes bytes{g_bytes_new_static(text.data(), text.size())};
  GError* raw_failure = nullptr;
  const Document document{poppler_document_new_from_bytes(bytes.get(), nullptr, &raw_failure)};
  const Failure failure{raw_failure};
  if (!document) {
    const bool locked =
        failure && g_error_matches(failure.get(), POPPLER_ERROR, POPPLER_ERROR_ENCRYPTED) != 0;
    return sketch.refuse(
        0,
        0,
        locked ? "it is a PDF file that a password protects" : "it is a broken PDF file",
        locked ? "save it without a password" : "export it again");
  }
  const int pages = poppler_document_get_n_pages(document.get());
  const Page page{pages > 0 ? poppler_document_get_page(document.get(), 0) : nullptr};
  if (!page) return sketch.refuse(0, 0, "it is a PDF file without pages", "export it again");
  if (pages > 1) {
    sketch.note(fmt::format("it has {} pages: only the first page is read", pages),
                {},
                "save the other pages as separate files");
  }
  read_page(page.get(), sketch);
}

}  // namespace sim::drawing
