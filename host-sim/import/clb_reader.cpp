#include "host-sim/import/clb_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <pugixml.hpp>
#include <stdexcept>
#include <string_view>

#include "host-sim/import/lbrn_settings.hpp"
#include "host-sim/import/line_table.hpp"
#include "host-sim/import/scanner.hpp"

namespace sim::drawing {
namespace {

constexpr std::string_view kLibraryRoot = "LightBurnLibrary";

/// Returns the text of the first of the named attributes that exists and is not empty.
std::string attribute_of(const pugi::xml_node& node, std::initializer_list<const char*> names) {
  for (const char* const name : names) {
    std::string text = node.attribute(name).value();
    if (!text.empty()) return text;
  }
  return {};
}

bool is_plain_text(std::string_view text) {
  constexpr unsigned char kDelete = 0x7F;
  return std::ranges::none_of(text, [](char letter) {
    const auto byte = static_cast<unsigned char>(letter);
    return byte < ' ' || byte == kDelete;
  });
}

class ClbReader {
 public:
  ClbReader(const std::string& text, const std::string& file)
      : text_{text}, file_{file}, lines_{text} {}

  MaterialLibrary read() {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text_.data(), text_.size());
    if (!parsed) {
      refuse(static_cast<std::size_t>(parsed.offset),
             fmt::format("broken XML: {}; export the library again", parsed.description()));
    }
    const pugi::xml_node root = document.document_element();
    if (root.name() != kLibraryRoot) {
      refuse(0, "it is no library of materials of LightBurn; export one as .clb");
    }
    library_.name = attribute_of(root, {"DisplayName"});
    for (const pugi::xml_node& material : root.children("Material")) read_material(material);
    if (library_.entries.empty()) refuse(0, "the library has no entry that can be used");
    return std::move(library_);
  }

 private:
  [[noreturn]] void refuse(std::size_t offset, const std::string& reason) const {
    const auto [line, column] = lines_.at(std::min(offset, text_.size()));
    throw std::invalid_argument(fmt::format("{}:{}:{}: {}", file_, line, column, reason));
  }

  static std::size_t offset_of(const pugi::xml_node& node) {
    const std::ptrdiff_t offset = node.offset_debug();
    return offset > 0 ? static_cast<std::size_t>(offset - 1) : 0;
  }

  void note(const pugi::xml_node& node, const std::string& reason) {
    const auto [line, column] = lines_.at(offset_of(node));
    library_.notes.push_back(fmt::format("{}:{}:{}: {}", file_, line, column, reason));
  }

  void read_material(const pugi::xml_node& material) {
    const std::string name = attribute_of(material, {"name", "Name"});
    if (name.empty() || name.size() > kLongestMaterialName || !is_plain_text(name)) {
      return note(material,
                  fmt::format("a material needs a name of 1 to {} bytes without line ends; its "
                              "entries are left out, give it a name",
                              kLongestMaterialName));
    }
    for (const pugi::xml_node& entry : material.children("Entry")) read_entry(entry, name);
  }

  void read_entry(const pugi::xml_node& entry, const std::string& material) {
    LibraryEntry found{.material = material,
                       .description = attribute_of(entry, {"Desc", "NoThickTitle"}),
                       .thickness_mm = thickness_of(entry)};
    if (!is_plain_text(found.description)) found.description.clear();
    std::size_t settings = 0;
    for (const pugi::xml_node& setting : entry.children()) {
      if (!std::string_view{setting.name()}.starts_with("CutSetting")) continue;
      ++settings;
      if (library_.entries.size() == kMaxLibraryEntries) {
        refuse(offset_of(setting),
               fmt::format("the library has more than {} entries", kMaxLibraryEntries));
      }
      found.settings = offered_by(setting);
      if (const auto offset = found.settings.kerf_offset_mm) {
        note(setting, note_of_kerf_offset(*offset));
      }
      std::tie(found.line, found.column) = lines_.at(offset_of(setting));
      library_.entries.push_back(found);
    }
    if (settings == 0) note(entry, "the entry has no CutSetting and is left out");
  }

  /// Returns the thickness of an entry; nothing if the entry has none. A library marks a missing
  /// thickness by -1.
  std::optional<double> thickness_of(const pugi::xml_node& entry) {
    const std::string text = attribute_of(entry, {"Thickness"});
    if (text.empty()) return {};
    Scanner scanner{text};
    const auto number = scanner.number();
    const bool is_number = number && scanner.at_end();
    if (is_number && *number <= 0.0) return {};
    if (is_number && *number <= kGreatestThicknessMm) return number;
    note(entry,
         fmt::format("Thickness {:.40} is no number up to {:g} mm; it counts as unknown",
                     is_plain_text(text) ? text : "?",
                     kGreatestThicknessMm));
    return {};
  }

  const std::string& text_;
  const std::string& file_;
  LineTable lines_;
  MaterialLibrary library_;
};

}  // namespace

MaterialLibrary read_clb(const std::string& text, const std::string& file) {
  return ClbReader{text, file}.read();
}

}  // namespace sim::drawing
