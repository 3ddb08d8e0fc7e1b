#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/outline_box.hpp"
#include "tests/host-sim/import/support.hpp"

namespace sim::drawing {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

constexpr const char* kStyle =
    "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nSTYLE\n0\nSTYLE\n2\nS\n3\nDejaVuSans.ttf\n41\n1\n"
    "1001\nACAD\n1000\nDejaVu Sans\n0\nSTYLE\n2\nOLD\n3\ntxt.shx\n41\n0.5\n71\n2\n"
    "0\nENDTAB\n0\nENDSEC\n";

Drawing dxf_lettered(const std::string& entities, TextMode mode = TextMode::kOutline) {
  return read_drawing("f", kStyle + dxf_of(entities), {.text = mode});
}

/// Returns a TEXT of 10 mm height at 100 50 in the style S, with the groups in `more`.
std::string text_of(const std::string& words, const std::string& more = {}) {
  return "0\nTEXT\n8\n0\n7\nS\n40\n10\n10\n100\n20\n50\n1\n" + words + "\n" + more;
}
std::string mtext_of(const std::string& words, const std::string& more = {}) {
  return "0\nMTEXT\n8\n0\n7\nS\n40\n10\n10\n100\n20\n50\n1\n" + words + "\n" + more;
}

OutlineBox box_of(const Drawing& drawn) {
  OutlineBox box;
  for (const DrawnContour& contour : drawn.contours) {
    for (const Place& place : outline_of(contour.shapes, 0.0005)) box.include(place);
  }
  return box;
}

std::string notes_of_dxf(const Drawing& drawn) {
  std::string all;
  for (const Fault& fault : drawn.faults) all += to_string(fault, "f") + "\n";
  return all;
}

void expect_box(const OutlineBox& box, const Place& least, const Place& most, double within) {
  EXPECT_NEAR(box.least.x(), least.x(), within);
  EXPECT_NEAR(box.least.y(), least.y(), within);
  EXPECT_NEAR(box.most.x(), most.x(), within);
  EXPECT_NEAR(box.most.y(), most.y(), within);
}

TEST(DxfLetters, HeightIsThatOfCapitals) {
  const Drawing drawn = dxf_lettered(text_of("HI"));
  EXPECT_FALSE(drawn.has_errors());
  EXPECT_THAT(drawn.contours, SizeIs(2));
  const OutlineBox box = box_of(drawn);
  EXPECT_NEAR(box.least.y(), 50.0, 0.01);
  EXPECT_NEAR(box.height(), 10.0, 0.01);
  EXPECT_GT(box.least.x(), 100.0);
  EXPECT_THAT(notes_of_dxf(drawn), HasSubstr("letters are drawn in DejaVu Sans"));
  EXPECT_THAT(notes_of_dxf(drawn), Not(HasSubstr("wishes")));
}

TEST(DxfLetters, TurnLeanAndWidthAreFollowed) {
  const OutlineBox plain = box_of(dxf_lettered(text_of("H")));
  const OutlineBox turned = box_of(dxf_lettered(text_of("H", "50\n90\n")));
  EXPECT_NEAR(turned.width(), plain.height(), 1e-6);
  EXPECT_NEAR(turned.least.y() - 50.0, plain.least.x() - 100.0, 1e-6);
  const OutlineBox wide = box_of(dxf_lettered(text_of("H", "41\n2\n")));
  EXPECT_NEAR(wide.width(), 2.0 * plain.width(), 1e-6);
  const OutlineBox leaning = box_of(dxf_lettered(text_of("H", "51\n45\n")));
  EXPECT_NEAR(leaning.width(), plain.width() + 10.0, 0.01);
  EXPECT_NEAR(leaning.height(), 10.0, 0.01);
}

TEST(DxfLetters, AlignmentsAreAtTheSecondPlace) {
  const std::string second = "11\n200\n21\n80\n";
  const OutlineBox plain = box_of(dxf_lettered(text_of("H")));
  const double before = plain.least.x() - 100.0;
  const auto aligned = [&](const std::string& how) {
    return box_of(dxf_lettered(text_of("H", second + how)));
  };
  const OutlineBox right = aligned("72\n2\n");
  EXPECT_NEAR(200.0 - right.most.x(), before, 0.2);
  EXPECT_NEAR(right.least.y(), 80.0, 0.01);
  const OutlineBox centre = aligned("72\n1\n73\n2\n");
  EXPECT_NEAR(0.5 * (centre.least.x() + centre.most.x()), 200.0, 0.1);
  EXPECT_NEAR(0.5 * (centre.least.y() + centre.most.y()), 80.0, 0.01);
  EXPECT_NEAR(aligned("72\n4\n").least.y(), 75.0, 0.01);
  EXPECT_NEAR(aligned("73\n3\n").most.y(), 80.0, 0.01);
  EXPECT_NEAR(aligned("73\n3\n").least.x(), 200.0 + before, 1e-6);
  EXPECT_GT(aligned("73\n1\n").least.y(), 81.0);
  expect_box(aligned("72\n0\n73\n0\n"), plain.least, plain.most, 1e-9);
}

TEST(DxfLetters, FittedOnesReachBothPlaces) {
  const std::string to = "11\n140\n21\n50\n";
  const OutlineBox fit = box_of(dxf_lettered(text_of("HIH", to + "72\n5\n")));
  EXPECT_NEAR(fit.height(), 10.0, 0.01);
  EXPECT_NEAR(0.5 * (fit.least.x() + fit.most.x()), 120.0, 0.01);
  EXPECT_GT(fit.width(), 33.0);
  EXPECT_LT(fit.width(), 40.0);
  const OutlineBox aligned = box_of(dxf_lettered(text_of("HIH", to + "72\n3\n")));
  EXPECT_NEAR(aligned.width(), fit.width(), 1e-6);
  EXPECT_GT(aligned.height(), 12.0);
  const OutlineBox up = box_of(dxf_lettered(text_of("HIH", "11\n100\n21\n90\n72\n5\n")));
  EXPECT_NEAR(up.height(), fit.width(), 1e-6);
}

TEST(DxfLetters, CodesOfTwoPercentSignsAreCharacters) {
  const auto of = [](const std::string& words) { return box_of(dxf_lettered(text_of(words))); };
  const OutlineBox degrees = of("5\u00B0 \u00B11 \u00D83 %A");
  const OutlineBox coded = of("5%%d %%p1 %%C3 %%%%%065");
  expect_box(coded, degrees.least, degrees.most, 1e-9);
  EXPECT_THAT(notes_of_dxf(dxf_lettered(text_of("%%uA"))),
              HasSubstr("lines under or over its letters"));
  EXPECT_THAT(notes_of_dxf(dxf_lettered(text_of("A%%233B%%065"))),
              HasSubstr("characters (%%nnn) that are not in ASCII: they are left out"));
}

TEST(DxfLetters, BackwardsUpsideDownAndSeenFromBehind) {
  const OutlineBox plain = box_of(dxf_lettered(text_of("F")));
  const Place least = plain.least;
  const Place most = plain.most;
  const OutlineBox back = box_of(dxf_lettered(text_of("F", "71\n2\n")));
  expect_box(back, {200.0 - most.x(), least.y()}, {200.0 - least.x(), most.y()}, 1e-9);
  const OutlineBox down = box_of(dxf_lettered(text_of("F", "71\n4\n")));
  expect_box(down, {least.x(), 100.0 - most.y()}, {most.x(), 100.0 - least.y()}, 1e-9);
  const OutlineBox behind = box_of(dxf_lettered(text_of("F", "210\n0\n220\n0\n230\n-1\n")));
  expect_box(behind, {-most.x(), least.y()}, {-least.x(), most.y()}, 1e-9);
}

TEST(DxfLetters, StylesGiveWidthFlagsAndTheNameOfTheirFont) {
  const std::string text = "0\nTEXT\n8\n0\n7\nold\n40\n10\n10\n100\n20\n50\n1\nH\n";
  const Drawing drawn = dxf_lettered(text);
  const OutlineBox box = box_of(drawn);
  EXPECT_LT(box.most.x(), 100.0) << "backwards";
  EXPECT_NEAR(box.width(), 0.5 * box_of(dxf_lettered(text_of("H"))).width(), 0.5);
  EXPECT_THAT(notes_of_dxf(drawn), HasSubstr("style old names the font txt.shx: "));
  EXPECT_THAT(notes_of_dxf(dxf_lettered(text, TextMode::kStroke)), Not(HasSubstr("wishes")));
}

TEST(DxfParagraphs, LinesHangFromTheAttachment) {
  const OutlineBox one = box_of(dxf_lettered(mtext_of("H")));
  EXPECT_NEAR(one.most.y(), 50.0, 0.01);
  const OutlineBox two = box_of(dxf_lettered(mtext_of("H\\PH")));
  EXPECT_NEAR(two.most.y(), 50.0, 0.01);
  EXPECT_NEAR(two.least.y(), 50.0 - 10.0 - 10.0 * 5.0 / 3.0, 0.01);
  EXPECT_NEAR(box_of(dxf_lettered(mtext_of("H\\PH", "71\n7\n"))).least.y(), 50.0, 0.01);
  const OutlineBox middle = box_of(dxf_lettered(mtext_of("H\\PH", "71\n5\n44\n1.5\n")));
  EXPECT_NEAR(0.5 * (middle.least.y() + middle.most.y()), 50.0, 0.01);
  EXPECT_NEAR(0.5 * (middle.least.x() + middle.most.x()), 100.0, 0.1);
  EXPECT_NEAR(middle.height(), 35.0, 0.01);
  EXPECT_LT(box_of(dxf_lettered(mtext_of("H", "71\n3\n"))).most.x(), 100.0);
}

TEST(DxfParagraphs, DirectionIsAnAngleOrAWay) {
  const OutlineBox turned = box_of(dxf_lettered(mtext_of("HH", "50\n90\n")));
  const OutlineBox way = box_of(dxf_lettered(mtext_of("HH", "11\n0\n21\n1\n31\n0\n")));
  expect_box(way, turned.least, turned.most, 1e-9);
  EXPECT_GT(turned.height(), turned.width());
}

TEST(DxfParagraphs, WrapAtTheirWidth) {
  const OutlineBox free = box_of(dxf_lettered(mtext_of("HHH HHH HHH")));
  const OutlineBox wrapped = box_of(dxf_lettered(mtext_of("HHH HHH HHH", "41\n60\n")));
  EXPECT_GT(free.width(), 60.0);
  EXPECT_LT(wrapped.width(), 60.0);
  EXPECT_NEAR(wrapped.height(), 10.0 + 20.0 * 5.0 / 3.0, 0.01);
  const OutlineBox held = box_of(dxf_lettered(mtext_of("HHH\\~HHH", "41\n40\n")));
  EXPECT_NEAR(held.height(), 10.0, 0.01) << "this blank breaks no line";
}

TEST(DxfParagraphs, CodesBeforeTheFirstLetterAreFollowedAndOthersNoted) {
  const Drawing set = dxf_lettered(mtext_of("{\\fDejaVu Sans Mono|b0|i0|c0|p34;\\H2x;\\W0.5;HI}"));
  EXPECT_NEAR(box_of(set).height(), 20.0, 0.01);
  EXPECT_THAT(notes_of_dxf(set), Not(HasSubstr("format codes")));
  EXPECT_THAT(notes_of_dxf(set), HasSubstr("drawn in DejaVu Sans Mono"));
  const Drawing later = dxf_lettered(mtext_of("H\\H2x;I\\S1/2; \\C1;x \\Lu\\l"));
  EXPECT_THAT(notes_of_dxf(later), HasSubstr("codes that are ignored: \\H \\S \\C \\L"));
  EXPECT_NEAR(box_of(later).most.y(), 50.0, 0.2);
  EXPECT_THAT(notes_of_dxf(dxf_lettered(mtext_of("{\\H2x;H}I"))),
              HasSubstr("codes that are ignored: {}"));
  const OutlineBox literal = box_of(dxf_lettered(mtext_of("\\{\\\\\\}")));
  const OutlineBox plain = box_of(dxf_lettered(text_of("{\\}")));
  EXPECT_NEAR(literal.width(), plain.width(), 1e-9);
}

TEST(DxfParagraphs, LongOnesAreOneOfTheirParts) {
  const Drawing whole = dxf_lettered(mtext_of("HI HI"));
  const Drawing parts =
      dxf_lettered("0\nMTEXT\n8\n0\n7\nS\n40\n10\n10\n100\n20\n50\n3\nHI \n1\nHI\n");
  expect_box(box_of(parts), box_of(whole).least, box_of(whole).most, 1e-9);
}

TEST(DxfAttributes, AreDrawnUnlessTheyAreInvisible) {
  const std::string attribute =
      "0\nATTRIB\n8\n0\n7\nS\n40\n10\n10\n100\n20\n50\n1\nH\n2\nTAG\n74\n3\n11\n0\n21\n0\n";
  EXPECT_NEAR(box_of(dxf_lettered(attribute)).most.y(), 0.0, 0.01);
  const Drawing hidden = dxf_lettered(attribute + "70\n1\n");
  EXPECT_THAT(hidden.contours, IsEmpty());
  EXPECT_THAT(notes_of_dxf(hidden), HasSubstr("invisible attributes are not drawn"));
}

TEST(DxfLetters, WrongOnesAreFaultsAndEmptyOnesNotes) {
  EXPECT_THAT(notes_of_dxf(dxf_lettered("0\nTEXT\n8\n0\n1\nA\n")),
              HasSubstr("its height is not above 0"));
  EXPECT_THAT(notes_of_dxf(dxf_lettered("0\nMTEXT\n8\n0\n1\nA\n")),
              HasSubstr("its height is not above 0"));
  const Drawing empty = dxf_lettered(mtext_of(""));
  EXPECT_FALSE(empty.has_errors());
  EXPECT_THAT(notes_of_dxf(empty), HasSubstr("MTEXT has no letters"));
  EXPECT_THAT(notes_of_dxf(dxf_lettered(text_of("A", "210\n1\n220\n0\n230\n0\n"))),
              HasSubstr("its plane is upright"));
}

TEST(DxfLetters, SkippedOnesAreNotesWithTheWayToDrawThem) {
  const Drawing drawn = dxf_lettered(text_of("A"), TextMode::kSkip);
  EXPECT_THAT(drawn.contours, IsEmpty());
  EXPECT_THAT(notes_of_dxf(drawn), HasSubstr("--text outline or --text stroke draws them"));
}

}  // namespace
}  // namespace sim::drawing
