#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "planner/gcode/fault.hpp"
#include "planner/gcode/line_reader.hpp"
#include "planner/gcode/modal_words.hpp"

namespace cnc::gcode {

/// Greatest number of values of S in one line, as in `S0:120:300`. Most lines are too short for
/// more.
inline constexpr std::size_t kMaxPowers = 64;

/// The words of one line, sorted: at most one G or M word of each modal group, and at most one
/// value of each other letter. The block checks which words may be in one line, but does not know
/// their meaning. It records which values have not been used yet.
class Block {
 public:
  /// Empties the block. One block is used for all lines. Only the masks are cleared, because the
  /// arrays are large and the masks show which entries are valid.
  void clear();

  /// Adds a word. Returns a fault if the word is unknown or repeated, or if its letter does not
  /// permit a negative or fractional number. Returns a fault, too, if an earlier word of the line
  /// is of the same modal group, or if the word and an earlier word both use the axis words.
  [[nodiscard]] Refusal add(const Word& word);
  /// Adds another value of S. Returns a fault if the value is refused.
  [[nodiscard]] Refusal add_power(const Word& word);

  /// Checks an O word. An O word that only gives the number of a program has no effect. All other O
  /// words are refused.
  /// @param at_end whether the line ends after the word
  [[nodiscard]] Refusal name_program(const Word& word, bool at_end) const;

  [[nodiscard]] bool empty() const { return groups_ == 0 && letters_ == 0; }

  [[nodiscard]] bool has(ModalGroup group) const { return (groups_ & bit_of(group)) != 0; }
  /// Returns whether the line has no G or M word other than a motion word.
  [[nodiscard]] bool has_no_word_but_motion() const {
    return (groups_ & ~bit_of(ModalGroup::kMotion)) == 0;
  }
  /// Returns the meaning of the word of a group. @pre has(group)
  template <typename Meaning>
  [[nodiscard]] Meaning meaning(ModalGroup group) const {
    return static_cast<Meaning>(words_[index_of(group)]->meaning);
  }
  [[nodiscard]] NonModal non_modal() const;
  /// Returns the use of axis words that the G words of the line require, even if the line has no
  /// axis words.
  [[nodiscard]] AxisUse axis_use() const { return axis_use_; }

  [[nodiscard]] bool has(char letter) const { return (letters_ & bit_of(letter)) != 0; }
  [[nodiscard]] bool has_axis_word() const;
  [[nodiscard]] bool has_arc_word() const;  ///< True if the line has I, J, K or R.
  /// Returns the value of a letter and marks it as used. Returns null if the line does not have the
  /// letter or if the value is already used.
  [[nodiscard]] const Decimal* take(char letter);
  /// Returns the value of a letter without marking it as used. @pre has(letter)
  [[nodiscard]] const Decimal& value(char letter) const { return values_[index_of(letter)]; }
  /// Returns all values of S; empty unless S has several values.
  [[nodiscard]] std::span<const float> powers() const {
    return std::span{powers_}.first(power_count_);
  }
  [[nodiscard]] bool is_free(char letter) const { return (unused_ & bit_of(letter)) != 0; }

  /// Returns a fault at the value word with this letter. @pre has(letter)
  [[nodiscard]] Fault blame(FaultDetail detail, char letter) const;
  /// Returns a fault at the G or M word of this group. @pre has(group)
  [[nodiscard]] Fault blame(FaultDetail detail, ModalGroup group) const;
  /// Returns a fault at the first axis word or, if there is none, at the first of the words I J K.
  /// @pre has_axis_word(), or the line has I, J or K
  [[nodiscard]] Fault blame_first_axis_word(FaultDetail detail) const;
  /// Returns kUnused for the leftmost value that is not used, or nothing if all values are used.
  [[nodiscard]] Refusal unused_word() const;

 private:
  static constexpr std::size_t kLetterCount = 26;

  static constexpr std::size_t index_of(char letter) {
    return static_cast<std::size_t>(letter - 'A');
  }
  static constexpr std::size_t index_of(ModalGroup group) {
    return static_cast<std::size_t>(group);
  }
  static constexpr std::uint32_t bit_of(char letter) { return 1U << index_of(letter); }
  static constexpr std::uint32_t bit_of(ModalGroup group) { return 1U << index_of(group); }
  static constexpr std::uint32_t mask_of(std::string_view letters);
  static constexpr std::uint32_t axis_letters();

  [[nodiscard]] Refusal add_modal(const Word& word,
                                  const Result<const ModalWord*, FaultDetail>& found);
  [[nodiscard]] Refusal add_value(const Word& word);
  [[nodiscard]] char leftmost(std::uint32_t letters) const;

  std::uint32_t letters_ = 0;  ///< Set of the letters that have a value, one bit each.
  std::uint32_t unused_ = 0;   ///< Set of the letters whose value is not used yet, one bit each.
  std::uint32_t groups_ = 0;   ///< Set of the modal groups that have a word, one bit each.
  AxisUse axis_use_ = AxisUse::kNone;
  std::array<Decimal, kLetterCount> values_{};
  std::array<std::uint16_t, kLetterCount> value_columns_{};
  std::array<float, kMaxPowers> powers_{};
  std::size_t power_count_ = 0;
  std::array<const ModalWord*, kModalGroupCount> words_{};
  std::array<std::uint16_t, kModalGroupCount> word_columns_{};
};

/// Reads a line into `block`, which is cleared first.
/// @param block_delete see LineReader::begin()
[[nodiscard]] Refusal read_block(std::string_view line, bool block_delete, Block& block);

}  // namespace cnc::gcode
