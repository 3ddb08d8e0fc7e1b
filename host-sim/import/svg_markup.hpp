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

/// An XML document with its entities expanded, and a map from its bytes back to positions in the
/// file.
///
/// Entities of the internal subset are expanded, including those that contain elements. An entity
/// that is not declared, or lies in another file, becomes a fault and stays as it is written.
/// Expansion is bounded in depth and size.
class SvgMarkup {
 public:
  SvgMarkup(const std::string& source, Sketch& sketch);

  /// Returns the document without its DOCTYPE.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Returns the line and column in the file, both from 1, of a byte of text().
  [[nodiscard]] std::pair<std::size_t, std::size_t> at(std::size_t offset) const;
  /// Returns whether a bound ended the expansion; a fault reports it.
  [[nodiscard]] bool is_too_long() const { return too_long_; }

 private:
  struct Stretch {
    std::size_t out;  ///< Start of the stretch in the text.
    std::size_t in;   ///< Position in the source from which the stretch comes.
    /// True: copied byte by byte. False: the whole stretch comes from one reference.
    bool is_verbatim;
  };

  void read_prologue();
  void read_subset();
  void read_declaration();
  void read_entity(std::string_view declaration, std::size_t at);
  void expand_all();
  void copy(std::size_t from, std::size_t to);
  /// Writes the expansion of the reference at `at`. Returns the position at which the source
  /// continues.
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
