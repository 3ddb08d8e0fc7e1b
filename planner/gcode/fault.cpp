#include "planner/gcode/fault.hpp"

#include <array>
#include <string_view>

#include "planner/base/truncate.hpp"

namespace cnc::gcode {

namespace {

struct Explanation {
  ErrorCode code;
  /// The explanation, with fields for the values of the fault. %w is the letter and number of the
  /// word, and %c only its letter. %v is the value and %l the limit, both with three decimals. %n
  /// is the limit without superfluous decimals.
  std::string_view sentence;
};

using enum ErrorCode;

/// Explanations in the order of FaultDetail.
constexpr std::array<Explanation, kFaultDetailCount> kExplanations{{
    {kExpectedLetter, "a word begins with a letter, not with '%c'"},
    {kExpectedLetter, "byte %w is only allowed in a comment"},
    {kExpectedLetter, "comment has no ')'"},
    {kExpectedLetter, "'(' inside a comment"},
    {kExpectedLetter, "'%' must be alone on its line, or begin a name"},
    {kExpectedLetter, "parameters and expressions are not supported"},
    {kBadNumber, "%c has no number"},
    {kBadNumber, "parameters and expressions are not supported"},
    {kBadNumber, "number after %c has more than 9 digits before its point"},
    {kNegativeValue, "%w is negative"},
    {kNegativeValue, "%w is less than 1"},
    {kLineTooLong, "line is longer than %n characters"},
    {kUnsupportedWord, "%w is not supported"},
    {kUnsupportedWord, "O-words are not supported"},
    {kModalGroupTwice, "%w belongs to a modal group already used in this line"},
    {kFeedUndefined, "F is missing: no feed is set"},
    {kFeedUndefined, "F is missing: G93 needs it on each line that moves"},
    {kNotAnInteger, "%w is not a whole number"},
    {kAxisWordsClaimedTwice, "%w and another word both use the axis words"},
    {kWordRepeated, "%c is given twice"},
    {kAxisWordsMissing, "%w needs axis words"},
    {kBadLineNumber, "%w is greater than %n"},
    {kValueWordMissing, "%c is missing"},
    {kNoSuchCoordinateSystem, "%w names no coordinate system"},
    {kG53NeedsStraightMotion, "G53 needs G0 or G1"},
    {kAxisWordsUnused, "nothing uses %w"},
    {kNoAxisWordInPlane, "arc has no axis word in its plane"},
    {kInvalidTarget, "%c would be %v, limit %l"},
    {kInvalidTarget, "offset of %c would be %v, limit %l"},
    {kInvalidTarget, "arc centre would be at %v mm, limit %l mm"},
    {kInvalidTarget, "arc centre is its start"},
    {kInvalidTarget, "arc end is %v mm off its circle, limit %l mm"},
    {kInvalidTarget, "arc with R ends where it starts"},
    {kInvalidTarget, "probe target is the present position"},
    {kInvalidRadius, "arc radius is zero"},
    {kInvalidRadius, "arc radius is %v mm, limit %l mm"},
    {kInvalidRadius, "arc end is %v mm farther from its start than the diameter, limit %l mm"},
    {kNoOffsetInPlane, "arc has neither R nor a centre in its plane"},
    {kNoOffsetInPlane, "%c is missing: G90.1 needs the whole centre"},
    {kWordUnused, "nothing uses %w"},
    {kToolOffsetAxis, "G43.1 needs Z and no other axis"},
    {kValueTooLarge, "%w is greater than %n"},
    {kValueTooLarge, "motion takes more than %n days: check F"},
    {kNotAJog, "%w is not permitted in a jog"},
    {kNoAxisWordInPlane, "a spline needs the plane of G17"},
    {kAxisWordsUnused, "a spline moves X and Y only, not %c"},
    {kValueWordMissing, "I and J are missing, and no G5 leads here"},
    {kInvalidTarget, "control point would be at %v mm, limit %l mm"},
    {kAxisWordsMissing, "no NURBS is open: G5.2 begins one"},
    {kUnsupportedWord, "%w is not permitted in a NURBS: G5.3 ends it, G80 drops it"},
    {kInvalidTarget, "the machine has moved since G5.2: G80 drops the NURBS"},
    {kAxisWordsMissing, "NURBS has fewer than %n control points"},
    {kValueTooLarge, "NURBS has more than %n control points"},
    {kValueTooLarge, "%w is no order of a NURBS: 3 to 6"},
    {kValueTooLarge, "%w is no weight of a NURBS: 0.001 to 1000"},
    {kValueTooLarge, "S has more than %n values"},
    {kUnsupportedWord, "S with several values needs laser mode, $32=1"},
    {kWordUnused, "S with several values needs a G1 that moves"},
    {kUnsupportedWord, "%w is not permitted from G41 or G42 to G40"},
    {kUnsupportedWord, "%w is not permitted before G40"},
    {kUnsupportedWord, "%w is not permitted before ~ ends the tool change"},
    {kInvalidTarget, "the target lies beyond the travel"},
    {kValueTooLarge, "%w is no width of a cut, limit %n"},
    {kValueTooLarge, "%w names no kerf table, the last is %n: $K lists them"},
    {kValueWordMissing, "%w needs a material, in a line before: M190 P(table) Q(thickness)"},
    {kValueWordMissing, "%w needs the radius of the tool: G10 L1 P(tool) R(radius)"},
    {kUnsupportedWord, "%w needs the beam's watts: $PC"},
    {kValueTooLarge, "%v mm is no thickness of the material, the nearest is %l mm"},
    {kValueTooLarge, "%v W does not cut the material, the nearest is %l W"},
    {kValueTooLarge, "%v mm/min does not cut the material, the nearest is %l mm/min"},
    {kValueTooLarge, "at %v W no speed cuts the material"},
    {kToolOffsetAxis, "G43.4 takes Z and no other axis"},
    {kUnsupportedWord, "%w needs five axes: $900"},
    {kUnsupportedWord, "%w is not permitted from G43.4 to G49"},
    {kAxisWordsUnused, "%w ends G43.4 and must be in a line without a motion"},
}};

constexpr const Explanation& explanation_of(FaultDetail detail) {
  return kExplanations[static_cast<std::size_t>(detail)];
}

/// Appends text to a buffer of fixed size. Text that does not fit is dropped.
class TextWriter {
 public:
  explicit TextWriter(std::span<char> out) : out_{out} {}

  [[nodiscard]] std::size_t size() const { return size_; }

  void put(char c) {
    if (size_ < out_.size()) out_[size_++] = c;
  }

  void put_whole(std::uint64_t number) {
    std::array<char, 20> digits{};
    std::size_t count = 0;
    do {
      digits[count++] = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number > 0 && count < digits.size());
    while (count > 0) put(digits[--count]);
  }

  /// Appends a number, rounded to thousandths. If `trimmed`, zeros at the end of the decimals are
  /// omitted.
  /// @pre |number| < 2^47, which holds for every value of a Fault
  void put_number(float number, bool trimmed) {
    if (number < 0.0F) put('-');
    const float magnitude = number < 0.0F ? -number : number;
    const auto whole = static_cast<std::uint64_t>(truncated(magnitude));
    const float rest = magnitude - static_cast<float>(whole);
    const auto thousandths = static_cast<std::uint32_t>(rest * 1000.0F + 0.5F);
    put_whole(whole + thousandths / 1000);
    put_decimals(thousandths % 1000, trimmed);
  }

 private:
  void put_decimals(std::uint32_t thousandths, bool trimmed) {
    if (trimmed && thousandths == 0) return;
    put('.');
    for (std::uint32_t weight = 100; weight > 0; weight /= 10) {
      put(static_cast<char>('0' + thousandths / weight % 10));
      if (trimmed && thousandths % weight == 0) return;
    }
  }

  std::span<char> out_;
  std::size_t size_ = 0;
};

/// Appends the value that the letter `field` stands for. Returns false if it stands for no value:
/// then the percent sign before it is part of the text.
bool put_field(TextWriter& text, char field, const Fault& fault) {
  switch (field) {
    case 'w':
      if (fault.letter != ' ') text.put(fault.letter);
      text.put_number(fault.value, true);
      return true;
    case 'c':
      text.put(fault.letter);
      return true;
    case 'v':
      text.put_number(fault.value, false);
      return true;
    case 'l':
      text.put_number(fault.limit, false);
      return true;
    case 'n':
      text.put_number(fault.limit, true);
      return true;
    default:
      return false;
  }
}

}  // namespace

ErrorCode Fault::code() const { return explanation_of(detail).code; }

std::size_t describe(const Fault& fault, std::span<char> out) {
  TextWriter text{out};
  const std::string_view sentence = explanation_of(fault.detail).sentence;
  for (std::size_t at = 0; at < sentence.size(); ++at) {
    const bool field = sentence[at] == '%' && at + 1 < sentence.size();
    if (field && put_field(text, sentence[at + 1], fault)) {
      ++at;
    } else {
      text.put(sentence[at]);
    }
  }
  return text.size();
}

}  // namespace cnc::gcode
