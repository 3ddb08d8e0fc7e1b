#include "planner/gcode/block.hpp"

#include "planner/base/axes.hpp"
#include "planner/base/contract.hpp"

namespace cnc::gcode {

namespace {

Fault blame_word(FaultDetail detail, const Word& word) {
  return Fault{.detail = detail,
               .letter = word.letter,
               .column = word.column,
               .value = word.value.to_float()};
}

constexpr bool is_m_group(ModalGroup group) { return group >= ModalGroup::kStop; }

}  // namespace

constexpr std::uint32_t Block::mask_of(std::string_view letters) {
  std::uint32_t mask = 0;
  for (const char letter : letters) mask |= bit_of(letter);
  return mask;
}

constexpr std::uint32_t Block::axis_letters() {
  return mask_of({kAxisLetters.data(), kAxisLetters.size()});
}

void Block::clear() {
  letters_ = 0;
  unused_ = 0;
  groups_ = 0;
  power_count_ = 0;
  axis_use_ = AxisUse::kNone;
}

Refusal Block::add(const Word& word) {
  if (word.letter == 'G') return add_modal(word, find_g_word(word.value));
  if (word.letter == 'M') return add_modal(word, find_m_word(word.value));
  return add_value(word);
}

/// Adds a G or M word. Like Grbl, it checks the use of the axis words before the modal group. So G0
/// G1 has error number 24, and G17 G18 has number 21.
Refusal Block::add_modal(const Word& word, const Result<const ModalWord*, FaultDetail>& found) {
  if (!found.ok()) return blame_word(found.error(), word);
  const ModalWord* const modal = found.value();
  const AxisUse use = modal->axis_use();
  if (use != AxisUse::kNone) {
    if (axis_use_ != AxisUse::kNone) return blame_word(FaultDetail::kAxisWordsClaimedTwice, word);
    axis_use_ = use;
  }
  if (has(modal->group)) {
    const ModalWord* const both = combined(*words_[index_of(modal->group)], *modal);
    if (both == nullptr) return blame_word(FaultDetail::kModalGroupTwice, word);
    words_[index_of(modal->group)] = both;
    if (both == modal) word_columns_[index_of(modal->group)] = word.column;
    return std::nullopt;
  }
  groups_ |= bit_of(modal->group);
  words_[index_of(modal->group)] = modal;
  word_columns_[index_of(modal->group)] = word.column;
  return std::nullopt;
}

Refusal Block::add_value(const Word& word) {
  constexpr std::uint32_t kKnown = mask_of("ABCDEFIJKLNPQRSTXYZ");
  constexpr std::uint32_t kNeverNegative = mask_of("FNST");
  constexpr std::uint32_t kAlwaysWhole = mask_of("LNT");
  const std::uint32_t bit = bit_of(word.letter);
  if ((bit & kKnown) == 0) return blame_word(FaultDetail::kUnsupported, word);
  if ((bit & letters_) != 0) return blame_word(FaultDetail::kRepeated, word);
  if ((bit & kNeverNegative) != 0 && word.value.is_negative()) {
    return blame_word(FaultDetail::kNegative, word);
  }
  if ((bit & kAlwaysWhole) != 0 && !word.value.is_integer()) {
    return blame_word(FaultDetail::kNotAnInteger, word);
  }
  letters_ |= bit;
  unused_ |= bit;
  values_[index_of(word.letter)] = word.value;
  value_columns_[index_of(word.letter)] = word.column;
  return std::nullopt;
}

Refusal Block::add_power(const Word& word) {
  if (word.value.is_negative()) return blame_word(FaultDetail::kNegative, word);
  if (power_count_ == 0) powers_[power_count_++] = value('S').to_float();
  if (power_count_ == kMaxPowers) {
    Fault fault = blame_word(FaultDetail::kTooManyPowers, word);
    fault.limit = static_cast<float>(kMaxPowers);
    return fault;
  }
  powers_[power_count_++] = word.value.to_float();
  return std::nullopt;
}

/// Checks an O word. It must be the only word of its line, or follow N.
Refusal Block::name_program(const Word& word, bool at_end) const {
  const bool alone = groups_ == 0 && (letters_ & ~bit_of('N')) == 0 && at_end;
  if (alone && word.value.is_integer() && !word.value.is_negative()) return std::nullopt;
  return blame_word(FaultDetail::kOWord, word);
}

NonModal Block::non_modal() const {
  if (!has(ModalGroup::kNonModal)) return NonModal::kNothing;
  return meaning<NonModal>(ModalGroup::kNonModal);
}

bool Block::has_axis_word() const {
  constexpr std::uint32_t kAxes = axis_letters();
  return (letters_ & kAxes) != 0;
}

bool Block::has_arc_word() const { return has('I') || has('J') || has('K') || has('R'); }

const Decimal* Block::take(char letter) {
  if (!is_free(letter)) return nullptr;
  unused_ &= ~bit_of(letter);
  return &values_[index_of(letter)];
}

Fault Block::blame(FaultDetail detail, char letter) const {
  CNC_ASSERT(has(letter));
  return Fault{.detail = detail,
               .letter = letter,
               .column = value_columns_[index_of(letter)],
               .value = values_[index_of(letter)].to_float()};
}

Fault Block::blame(FaultDetail detail, ModalGroup group) const {
  CNC_ASSERT(has(group));
  return Fault{.detail = detail,
               .letter = is_m_group(group) ? 'M' : 'G',
               .column = word_columns_[index_of(group)],
               .value = static_cast<float>(words_[index_of(group)]->tenths) * 0.1F};
}

Fault Block::blame_first_axis_word(FaultDetail detail) const {
  constexpr std::uint32_t kOffsets = mask_of("IJK");
  const std::uint32_t axes = letters_ & axis_letters();
  return blame(detail, leftmost(axes != 0 ? axes : letters_ & kOffsets));
}

Refusal Block::unused_word() const {
  if (unused_ == 0) return std::nullopt;
  return blame(FaultDetail::kUnused, leftmost(unused_));
}

/// Returns the letter of the leftmost value word among those with a letter of the set `letters`.
/// @pre `letters` is not empty, and the line has a value of each of them
char Block::leftmost(std::uint32_t letters) const {
  char found = ' ';
  std::uint16_t found_column = kLongestLineWithComments + 1;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const std::uint16_t column = value_columns_[index_of(letter)];
    if ((letters & bit_of(letter)) == 0 || column > found_column) continue;
    found = letter;
    found_column = column;
  }
  return found;
}

Refusal read_block(std::string_view line, bool block_delete, Block& block) {
  block.clear();
  LineReader reader{line};
  if (const auto fault = reader.begin(block_delete)) return fault;
  while (!reader.at_end()) {
    Word word;
    const bool first = block.empty();
    if (const auto fault = reader.read(word)) return fault;
    if (word.letter == 'O') return block.name_program(word, reader.at_end());
    if (const auto fault = block.add(word)) return fault;
    if (first && word.letter == 'N') {
      if (const auto fault = reader.pass_slash_after_number(block_delete)) return fault;
    }
    while (word.letter == 'S' && reader.at_more_values()) {
      if (const auto fault = reader.read_more(word)) return fault;
      if (const auto fault = block.add_power(word)) return fault;
    }
  }
  return std::nullopt;
}

}  // namespace cnc::gcode
