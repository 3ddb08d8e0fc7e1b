#include "host-sim/text/font.hpp"

#include <fmt/format.h>
#include <freetype/freetype.h>
#include <freetype/ftoutln.h>
#include <freetype/tttables.h>
#include <harfbuzz/hb.h>

#include <memory>
#include <utility>

namespace sim::text {
namespace {

using drawing::Place;

struct CloseFace {
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};
struct CloseLibrary {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
template <auto destroy>
struct Destroy {
  template <typename T>
  void operator()(T* object) const {
    destroy(object);
  }
};
using Face = std::unique_ptr<FT_FaceRec, CloseFace>;
using FreeType = std::unique_ptr<FT_LibraryRec_, CloseLibrary>;
using HbFont = std::unique_ptr<hb_font_t, Destroy<hb_font_destroy>>;
using HbFace = std::unique_ptr<hb_face_t, Destroy<hb_face_destroy>>;
using HbBlob = std::unique_ptr<hb_blob_t, Destroy<hb_blob_destroy>>;
using HbBuffer = std::unique_ptr<hb_buffer_t, Destroy<hb_buffer_destroy>>;

/// Converts an outline of FreeType to rows of curves, in em.
class OutlinePen {
 public:
  explicit OutlinePen(double em) : em_{em} {}

  void move_to(const FT_Vector& to) {
    close();
    strokes.emplace_back();
    at_ = start_ = place(to);
  }
  void line_to(const FT_Vector& to) { line_to(place(to)); }
  void conic_to(const FT_Vector& control, const FT_Vector& to) {
    const Place c = place(control);
    const Place end = place(to);
    add(drawing::Bezier{{at_, at_ + (c - at_) * (2.0 / 3.0), end + (c - end) * (2.0 / 3.0), end}});
  }
  void cubic_to(const FT_Vector& first, const FT_Vector& second, const FT_Vector& to) {
    add(drawing::Bezier{{at_, place(first), place(second), place(to)}});
  }
  void close() {
    if (!strokes.empty() && at_ != start_) line_to(start_);
  }

  Strokes strokes;

 private:
  [[nodiscard]] Place place(const FT_Vector& at) const {
    return {static_cast<double>(at.x) / em_, static_cast<double>(at.y) / em_};
  }
  void line_to(const Place& to) {
    if (to != at_) add(drawing::Line{at_, to});
  }
  void add(drawing::Shape shape) {
    at_ = end_of(shape);
    strokes.back().push_back(std::move(shape));
  }

  double em_;
  Place at_{0.0, 0.0};
  Place start_{0.0, 0.0};
};

FT_Outline_Funcs pen_functions() {
  FT_Outline_Funcs functions{};
  functions.move_to = [](const FT_Vector* to, void* pen) {
    static_cast<OutlinePen*>(pen)->move_to(*to);
    return 0;
  };
  functions.line_to = [](const FT_Vector* to, void* pen) {
    static_cast<OutlinePen*>(pen)->line_to(*to);
    return 0;
  };
  functions.conic_to = [](const FT_Vector* control, const FT_Vector* to, void* pen) {
    static_cast<OutlinePen*>(pen)->conic_to(*control, *to);
    return 0;
  };
  functions.cubic_to =
      [](const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* pen) {
        static_cast<OutlinePen*>(pen)->cubic_to(*first, *second, *to);
        return 0;
      };
  return functions;
}

class SystemFont final : public Font {
 public:
  SystemFont(FreeType library, Face face, HbFont shaper)
      : library_{std::move(library)}, face_{std::move(face)}, shaper_{std::move(shaper)} {
    const char* const family = face_->family_name;
    const char* const style = face_->style_name;
    name_ = family == nullptr ? "a font without a name" : family;
    if (style != nullptr) name_ += fmt::format(" {}", style);
    measure();
  }

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] const FontFigures& figures() const override { return figures_; }
  [[nodiscard]] bool has(char32_t letter) const override {
    return FT_Get_Char_Index(face_.get(), letter) != 0;
  }

  [[nodiscard]] std::vector<PlacedGlyph> shape(std::string_view words) override {
    const HbBuffer buffer{hb_buffer_create()};
    const int size = static_cast<int>(words.size());
    hb_buffer_add_utf8(buffer.get(), words.data(), size, 0, size);
    hb_buffer_guess_segment_properties(buffer.get());
    hb_shape(shaper_.get(), buffer.get(), nullptr, 0);
    unsigned count = 0;
    const hb_glyph_info_t* const infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* const places = hb_buffer_get_glyph_positions(buffer.get(), &count);
    std::vector<PlacedGlyph> glyphs;
    for (unsigned i = 0; i < count; ++i) {
      glyphs.push_back({.glyph = infos[i].codepoint,
                        .byte = infos[i].cluster,
                        .offset{places[i].x_offset / em(), places[i].y_offset / em()},
                        .advance = places[i].x_advance / em()});
    }
    return glyphs;
  }

  [[nodiscard]] const Strokes& outline(std::uint32_t glyph) override {
    const auto [found, is_new] = outlines_.try_emplace(glyph);
    if (!is_new) return found->second;
    if (FT_Load_Glyph(face_.get(), glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) != 0) {
      return found->second;
    }
    OutlinePen pen{em()};
    const FT_Outline_Funcs functions = pen_functions();
    FT_Outline_Decompose(&face_->glyph->outline, &functions, &pen);
    pen.close();
    std::erase_if(pen.strokes, [](const auto& shapes) { return shapes.empty(); });
    found->second = std::move(pen.strokes);
    return found->second;
  }

 private:
  [[nodiscard]] double em() const { return static_cast<double>(face_->units_per_EM); }

  void measure() {
    figures_.ascent = face_->ascender / em();
    figures_.descent = -face_->descender / em();
    figures_.capital = height_of(U'H', figures_.capital);
    figures_.small = height_of(U'x', figures_.small);
  }

  double height_of(char32_t letter, double otherwise) {
    double height = 0.0;
    const FT_UInt glyph = FT_Get_Char_Index(face_.get(), letter);
    if (glyph == 0) return otherwise;
    for (const auto& shapes : outline(glyph)) {
      for (const drawing::Shape& shape : shapes) height = std::max(height, end_of(shape).y());
    }
    return height > 0.0 ? height : otherwise;
  }

  FreeType library_;
  Face face_;
  HbFont shaper_;
  std::string name_;
  FontFigures figures_;
  std::map<std::uint32_t, Strokes> outlines_;
};

}  // namespace

std::unique_ptr<Font> Font::open(const std::string& file, int index) {
  FT_Library opened = nullptr;
  if (FT_Init_FreeType(&opened) != 0) return {};
  FreeType library{opened};
  FT_Face face = nullptr;
  if (FT_New_Face(library.get(), file.c_str(), index, &face) != 0) return {};
  Face owned{face};
  if (!FT_IS_SCALABLE(face) || face->units_per_EM == 0) return {};
  const HbBlob blob{hb_blob_create_from_file(file.c_str())};
  const HbFace shaped{hb_face_create(blob.get(), static_cast<unsigned>(index) & 0xFFFFU)};
  HbFont shaper{hb_font_create(shaped.get())};
  const int em = face->units_per_EM;
  hb_font_set_scale(shaper.get(), em, em);
  return std::make_unique<SystemFont>(std::move(library), std::move(owned), std::move(shaper));
}

}  // namespace sim::text
