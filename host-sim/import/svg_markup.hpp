#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host-sim/import/line_table.hpp"
#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// An XML document whose entities are expanded. It maps positions in the expanded text back to
/// positions in the file.
///
/// Entities of the internal subset are expanded, including those that contain elements. A reference
/// to an entity that is not declared, or that is in another file, is reported and stays as it is
/// written. Expansion is bounded in depth and size.
class SvgMarkup {
 public:
  SvgMarkup(const std::string& source, Sketch& sketch);

  /// Returns the expanded document without its DOCTYPE.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Returns the line and the column, both from 1, in the file for a byte of text().
  [[nodiscard]] std::pair<std::size_t, std::size_t> at(std::size_t offset) const;
  /// Returns whether the bound on size ended the expansion. A fault reports this.
  [[nodiscard]] bool is_too_long() const { return too_long_; }

 private:
  struct Stretch {
    std::size_t out;  ///< Start of the stretch in `text_`.
    std::size_t in;   ///< Position in `source_` from which the stretch comes.
    /// True if the stretch is copied byte by byte; false if all of it comes from one reference.
    bool is_verbatim;
  };

  void read_prologue();
  void read_subset();
  void read_declaration();
  void read_entity(std::string_view declaration, std::size_t at);
  void expand_all();
  void copy(std::size_t from, std::size_t to);
  /// Writes the expansion of the reference at the position `at` of the source. Returns the position
  /// after the reference.
  std::size_t put_reference(std::size_t at, bool in_tag);
  void put(std::string_view text, bool in_tag, std::size_t depth, std::size_t at);
  void undeclared(std::string_view name, std::size_t at);
  void put_character(char c, bool in_tag);

  std::string_view source_;
  Sketch& sketch_;
  LineTable lines_;
  std::size_t max_bytes_;
  std::map<std::string, std::string, std::less<>> entities_;
  std::map<std::string, bool, std::less<>> undeclared_;
  std::string text_;
  std::vector<Stretch> stretches_;
  std::size_t at_ = 0;
  bool too_long_ = false;
};

}  // namespace sim::drawing
