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

/// The most values that S may have, `S0:120:300`: more than fit into most lines.
inline constexpr std::size_t kMostPowers = 64;

/// The words of one line, sorted: at most one G or M word of each modal group,
/// at most one value of each other letter. Knows what may stand together, not
/// what it means; remembers which values nobody has asked for.
class Block {
 public:
  /// Empties the block. A block is reused from line to line: its arrays are
  /// large, and the masks alone tell what in them is meant.
  void clear();

  /// Files a word, or says why it may not stand in this line: unknown,
  /// repeated, of a modal group or with a claim on axis words that the line
  /// already has, negative, or not whole.
  [[nodiscard]] Refusal add(const Word& word);
  /// Files another value of S, or says why it may not be one.
  [[nodiscard]] Refusal add_power(const Word& word);

  /// Checks an O word, the number of a program, which means nothing; all others are refused.
  [[nodiscard]] Refusal name_program(const Word& word, bool at_end) const;

  [[nodiscard]] bool empty() const { return groups_ == 0 && letters_ == 0; }

  [[nodiscard]] bool has(ModalGroup group) const { return (groups_ & bit_of(group)) != 0; }
  /// Of G and M words.
  [[nodiscard]] bool has_no_word_but_motion() const {
    return (groups_ & ~bit_of(ModalGroup::kMotion)) == 0;
  }
  /// @pre has(group)
  template <typename Meaning>
  [[nodiscard]] Meaning meaning(ModalGroup group) const {
    return static_cast<Meaning>(words_[index_of(group)]->meaning);
  }
  [[nodiscard]] NonModal non_modal() const;
  /// The claim of the G words on the axis words, whether or not there are any.
  [[nodiscard]] AxisUse axis_use() const { return axis_use_; }

  [[nodiscard]] bool has(char letter) const { return (letters_ & bit_of(letter)) != 0; }
  [[nodiscard]] bool has_axis_word() const;
  [[nodiscard]] bool has_arc_word() const;  ///< I, J, K or R.
  /// The value of a letter, which then counts as used; null if it is not there
  /// or another word of the line has taken it.
  [[nodiscard]] const Decimal* take(char letter);
  /// The same without using it. @pre has(letter)
  [[nodiscard]] const Decimal& value(char letter) const { return values_[index_of(letter)]; }
  /// All values of S, where it has several.
  [[nodiscard]] std::span<const float> powers() const {
    return std::span{powers_}.first(power_count_);
  }
  [[nodiscard]] bool is_free(char letter) const { return (unused_ & bit_of(letter)) != 0; }

  /// A fault that blames the value word with this letter. @pre has(letter)
  [[nodiscard]] Fault blame(FaultDetail detail, char letter) const;
  /// A fault that blames the G or M word of this group. @pre has(group)
  [[nodiscard]] Fault blame(FaultDetail detail, ModalGroup group) const;
  /// A fault that blames the first axis word, or of I J K where there is none.
  /// @pre has_axis_word() or one of those
  [[nodiscard]] Fault blame_first_axis_word(FaultDetail detail) const;
  /// kUnused for the leftmost value that nobody took, if there is one.
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

  std::uint32_t letters_ = 0;  ///< A bit for each letter with a value.
  std::uint32_t unused_ = 0;   ///< Those of them that were not taken.
  std::uint32_t groups_ = 0;   ///< A bit for each modal group with a word.
  AxisUse axis_use_ = AxisUse::kNone;
  std::array<Decimal, kLetterCount> values_{};
  std::array<std::uint16_t, kLetterCount> value_columns_{};
  std::array<float, kMostPowers> powers_{};
  std::size_t power_count_ = 0;
  std::array<const ModalWord*, kModalGroupCount> words_{};
  std::array<std::uint16_t, kModalGroupCount> word_columns_{};
};

/// Reads a whole line into `block`, which is cleared first.
[[nodiscard]] Refusal read_block(std::string_view line, bool block_delete, Block& block);

}  // namespace cnc::gcode
