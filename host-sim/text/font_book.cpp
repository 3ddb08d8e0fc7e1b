#include <fontconfig/fontconfig.h>

#include <memory>
#include <string_view>

#include "host-sim/text/font.hpp"

namespace sim::text {
namespace {

struct DestroyPattern {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
};
struct DestroyCharSet {
  void operator()(FcCharSet* set) const { FcCharSetDestroy(set); }
};
using Pattern = std::unique_ptr<FcPattern, DestroyPattern>;

const FcChar8* bytes_of(const std::string& text) {
  return reinterpret_cast<const FcChar8*>(text.c_str());
}

/// Adds the names of a CSS list of font families to a pattern, without their quotes.
void add_families(FcPattern* pattern, std::string_view list) {
  constexpr std::string_view kAround = " \t\r\n'\"";
  while (!list.empty()) {
    const std::size_t comma = std::min(list.size(), list.find(','));
    std::string_view one = list.substr(0, comma);
    list.remove_prefix(std::min(list.size(), comma + 1));
    const std::size_t from = one.find_first_not_of(kAround);
    if (from == std::string_view::npos) continue;
    one = one.substr(from, one.find_last_not_of(kAround) - from + 1);
    FcPatternAddString(pattern, FC_FAMILY, bytes_of(std::string{one}));
  }
}

Pattern pattern_of(const FontWish& wish, char32_t letter) {
  Pattern pattern{FcPatternCreate()};
  add_families(pattern.get(), wish.family);
  FcPatternAddInteger(
      pattern.get(), FC_WEIGHT, FcWeightFromOpenType(static_cast<int>(wish.weight)));
  FcPatternAddInteger(pattern.get(), FC_SLANT, wish.is_slanted ? FC_SLANT_ITALIC : FC_SLANT_ROMAN);
  FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  const std::unique_ptr<FcCharSet, DestroyCharSet> letters{FcCharSetCreate()};
  FcCharSetAddChar(letters.get(), letter);
  FcPatternAddCharSet(pattern.get(), FC_CHARSET, letters.get());
  return pattern;
}

}  // namespace

/// The configuration of fontconfig with the fonts of the system. fontconfig loads its configuration
/// files by itself.
struct FontBook::Library {
  FcConfig* config = FcInitLoadConfigAndFonts();
  Library() = default;
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() {
    if (config != nullptr) FcConfigDestroy(config);
  }
};

FontBook::FontBook() = default;
FontBook::~FontBook() = default;

Font* FontBook::find(const FontWish& wish, char32_t letter) {
  const auto [known, is_new] = found_.try_emplace({wish, letter}, nullptr);
  if (!is_new) return known->second;
  if (!library_) library_ = std::make_unique<Library>();
  if (library_->config == nullptr) return nullptr;
  const Pattern wanted = pattern_of(wish, letter);
  FcConfigSubstitute(library_->config, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern match{FcFontMatch(library_->config, wanted.get(), &result)};
  FcChar8* file = nullptr;
  int index = 0;
  if (!match || FcPatternGetString(match.get(), FC_FILE, 0, &file) != FcResultMatch) return nullptr;
  FcPatternGetInteger(match.get(), FC_INDEX, 0, &index);
  const std::string name{reinterpret_cast<const char*>(file)};
  auto& font = fonts_[{name, index}];
  if (!font) font = Font::open(name, index);
  known->second = font.get();
  return font.get();
}

}  // namespace sim::text
