#include "host-sim/surface/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::surface {
namespace {

/// Maximum number of elements and properties of a header.
constexpr std::size_t kMaxPlyNames = 1'000;

std::optional<PlyScalar> scalar_of(std::string_view word) {
  using enum PlyScalar;
  constexpr auto kNames = std::to_array<std::pair<std::string_view, PlyScalar>>({
      {"char", kInt8},
      {"int8", kInt8},
      {"uchar", kUint8},
      {"uint8", kUint8},
      {"short", kInt16},
      {"int16", kInt16},
      {"ushort", kUint16},
      {"uint16", kUint16},
      {"int", kInt32},
      {"int32", kInt32},
      {"uint", kUint32},
      {"uint32", kUint32},
      {"float", kFloat},
      {"float32", kFloat},
      {"double", kDouble},
      {"float64", kDouble},
  });
  const auto* const found =
      std::ranges::find(kNames, word, [](const auto& pair) { return pair.first; });
  if (found == kNames.end()) return {};
  return found->second;
}

class PlyHeaderReader {
 public:
  PlyHeaderReader(std::string_view bytes, const std::string& name) : name_{name}, lines_{bytes} {}

  PlyHeader read() {
    static_cast<void>(lines_.next());  // Skips the line `ply`.
    while (const auto line = lines_.next()) {
      TextWords words{*line, lines_.number()};
      const std::string_view word = words.next();
      if (word == "end_header") return finish();
      if (word == "format") {
        take_format(words);
      } else if (word == "element") {
        take_element(words);
      } else if (word == "property") {
        take_property(words);
      } else if (!word.empty() && word != "comment" && word != "obj_info") {
        refuse_line(fmt::format("`{}` is not a word of a PLY header", shown(word)));
      }
    }
    refuse_line("ends without end_header");
  }

 private:
  [[noreturn]] void refuse_line(const std::string& reason) const {
    refuse(name_, lines_.number(), reason, "export the mesh again");
  }

  void take_format(TextWords& words) {
    const std::string_view word = words.next();
    constexpr std::array<std::string_view, 3> kFormats{
        "ascii", "binary_little_endian", "binary_big_endian"};
    const auto* const found = std::ranges::find(kFormats, word);
    if (found == kFormats.end()) {
      refuse_line(fmt::format("`{}` is not a format of PLY", shown(word)));
    }
    header_.format = static_cast<PlyFormat>(found - kFormats.begin());
    has_format_ = true;
  }

  void count_name() {
    if (++names_ > kMaxPlyNames) refuse_line("too many elements or properties");
  }

  void take_element(TextWords& words) {
    count_name();
    PlyElement element{.name = std::string{words.next()}, .count = 0, .properties = {}};
    const std::string_view word = words.next();
    const auto count = parsed_count(word);
    if (!count) refuse_line(fmt::format("`{}` is not a number of elements", shown(word)));
    element.count = *count;
    header_.elements.push_back(std::move(element));
  }

  PlyScalar take_scalar(TextWords& words) const {
    const std::string_view word = words.next();
    const auto scalar = scalar_of(word);
    if (!scalar) refuse_line(fmt::format("`{}` is not a type of PLY", shown(word)));
    return *scalar;
  }

  void take_property(TextWords& words) {
    count_name();
    if (header_.elements.empty()) refuse_line("has a property before the first element");
    PlyProperty property;
    TextWords ahead = words;
    if (ahead.next() == "list") {
      words = ahead;
      property.list_count = take_scalar(words);
      if (*property.list_count == PlyScalar::kFloat || *property.list_count == PlyScalar::kDouble) {
        refuse_line("the length of a list is not a whole number");
      }
    }
    property.scalar = take_scalar(words);
    property.name = std::string{words.next()};
    header_.elements.back().properties.push_back(std::move(property));
  }

  /// Returns the minimum number of bytes of an element. In a text, each number takes at least two
  /// bytes: a digit and a blank.
  [[nodiscard]] std::uint64_t min_bytes(const PlyElement& element) const {
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties) {
      const bool is_text = header_.format == PlyFormat::kAscii;
      bytes += is_text ? 2 : size_of(property.list_count.value_or(property.scalar));
    }
    return bytes;
  }

  PlyHeader finish() {
    if (!has_format_) refuse_line("has no line `format`");
    header_.lines = lines_.number();
    header_.body = lines_.rest();
    // Adds one byte, because the last number of a text needs no blank after it.
    std::uint64_t left = header_.body.size() + 1;
    for (const PlyElement& element : header_.elements) {
      const std::uint64_t bytes = min_bytes(element);
      if (bytes == 0 && element.count > 0) {
        refuse(name_, 0, "has an element without properties", "export the mesh again");
      }
      if (bytes > 0 && element.count > left / bytes) {
        refuse(name_,
               0,
               fmt::format("announces {} of `{}`, but has bytes for {}",
                           element.count,
                           shown(element.name),
                           left / bytes),
               "the file is cut off; export it again");
      }
      left -= bytes * element.count;
    }
    return std::move(header_);
  }

  const std::string& name_;
  TextLines lines_;
  PlyHeader header_;
  bool has_format_ = false;
  std::size_t names_ = 0;
};

}  // namespace

std::size_t size_of(PlyScalar scalar) {
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(scalar)];
}

std::size_t PlyElement::index(std::string_view property) const {
  const auto found = std::ranges::find(properties, property, &PlyProperty::name);
  return static_cast<std::size_t>(found - properties.begin());
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name) {
  return PlyHeaderReader{bytes, name}.read();
}

}  // namespace sim::surface
