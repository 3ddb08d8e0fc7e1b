#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "host-sim/import/lbrn_path.hpp"
#include "tests/host-sim/import/support.hpp"

namespace sim::drawing {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string project_of(const std::string& content, const std::string& attributes = {}) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<LightBurnProject AppVersion=\"1.7.08\" "
         "FormatVersion=\"1\" " +
         attributes + ">" + content + "</LightBurnProject>";
}

std::string shape(const std::string& attributes, const std::string& content) {
  return "<Shape CutIndex=\"0\" " + attributes + ">" + content + "</Shape>";
}

const std::string kAtFive = "<XForm>1 0 0 1 5 5</XForm>";

TEST(Lbrn, RectanglesAndEllipsesLieAroundTheirPlace) {
  const Drawing drawn = read(project_of(shape("Type=\"Rect\" W=\"10\" H=\"4\" Cr=\"1\"", kAtFive) +
                                        shape("Type=\"Ellipse\" Rx=\"1\" Ry=\"1\"", kAtFive)));
  ASSERT_THAT(drawn.faults, IsEmpty());
  ASSERT_THAT(drawn.contours, SizeIs(2));
  EXPECT_NEAR(drawn.contours[0].area_mm2, 40.0 - 4.0 + std::numbers::pi, 1e-9);
  EXPECT_THAT(shapes_of(drawn.contours[0]),
              ElementsAre("line", "arc", "line", "arc", "line", "arc", "line", "arc"));
  EXPECT_THAT(shapes_of(drawn.contours[1]), ElementsAre("arc"));
  EXPECT_TRUE(drawn.contours[1].is_hole());
  EXPECT_NEAR(distance(std::get<Arc>(drawn.contours[1].shapes[0]).centre, {5, 5}), 0.0, 1e-12);
  const Drawing round =
      read(project_of(shape("Type=\"Rect\" W=\"10\" H=\"10\" Cr=\"7\"", kAtFive)));
  EXPECT_NEAR(round.contours.at(0).area_mm2, 25.0 * std::numbers::pi, 1e-9);
}

TEST(Lbrn, PathsShareListsAndGroupsTurnTheirChildren) {
  const std::string lists =
      "<VertList>V0 0c0x1c1x1V4 0c0x6c0y2c1x1SV4 4c0x1c1x6c1y2V0 4c0x1c1x1</VertList>"
      "<PrimList>L0 1B1 2L2 3L3 0</PrimList>";
  const std::string group = "<Shape Type=\"Group\"><XForm>0 2 -2 0 100 0</XForm><Children>" +
                            shape("Type=\"Path\" VertID=\"3\" PrimID=\"7\"", kAtFive) +
                            "</Children></Shape>";
  const Drawing drawn = read(
      project_of(shape("Type=\"Path\" VertID=\"3\" PrimID=\"7\"", lists) + group +
                 shape("Type=\"Path\" VertID=\"3\"", "<PrimList>LineClosed</PrimList>" + kAtFive)));
  ASSERT_THAT(drawn.faults, IsEmpty());
  ASSERT_THAT(drawn.contours, SizeIs(3));
  EXPECT_THAT(shapes_of(drawn.contours[0]), ElementsAre("line", "bezier", "line", "line"));
  EXPECT_NEAR(std::abs(drawn.contours[1].area_mm2), 4.0 * drawn.contours[0].area_mm2, 1e-9);
  EXPECT_NEAR(distance(start_of(drawn.contours[1].shapes[0]), {90, 10}), 0.0, 1e-12);
  EXPECT_THAT(shapes_of(drawn.contours[2]), ElementsAre("line", "line", "line", "line"));
}

TEST(Lbrn, OldProjectsHaveVerticesAsElements) {
  const std::string old =
      "<V vx=\"0\" vy=\"0\"/><V vx=\"8\" vy=\"0\" c0x=\"9\" c0y=\"3\"/><V vx=\"8\" vy=\"8\" "
      "c1x=\"9\" "
      "c1y=\"5\"/><P T=\"L\" p0=\"0\" p1=\"1\"/><P T=\"B\" p0=\"1\" p1=\"2\"/><P T=\"L\" "
      "p0=\"2\"/>";
  const Drawing drawn = read(project_of(shape("Type=\"Path\"", old)));
  ASSERT_THAT(drawn.faults, IsEmpty());
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_THAT(shapes_of(drawn.contours[0]), ElementsAre("line", "bezier", "line"));
  EXPECT_EQ(std::get<Bezier>(drawn.contours[0].shapes[1]).points[2], (Place{9, 5}));
}

TEST(Lbrn, LettersAreTheirOutlinesOrLeftOut) {
  const std::string outline = "<BackupPath Type=\"Path\">" + kAtFive +
                              "<VertList>V0 0V4 0V0 4</VertList><PrimList>LineClosed</PrimList>"
                              "</BackupPath>" +
                              kAtFive;
  const Drawing drawn = read(project_of(shape("Type=\"Text\" Str=\"A\"", outline)));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_EQ(start_of(drawn.contours[0].shapes[0]), (Place{5, 5}));
  EXPECT_EQ(drawn.contours[0].entity.name, "Text \"A\"");
  const Drawing none = read(project_of(shape("Type=\"Text\" Str=\"A\"", kAtFive)));
  EXPECT_THAT(kinds_of(none), ElementsAre(FaultKind::kIgnored));
}

TEST(Lbrn, LayersOfferTheirSettings) {
  const std::string settings =
      "<CutSetting type=\"Cut\"><index Value=\"2\"/><name Value=\"Edge\"/><minPower Value=\"20\"/>"
      "<maxPower Value=\"65.5\"/><speed Value=\"12.5\"/><numPasses Value=\"2\"/><priority "
      "Value=\"1\"/>"
      "</CutSetting><CutSetting type=\"Scan\"><index Value=\"3\"/><doOutput "
      "Value=\"0\"/></CutSetting>";
  const std::string rect = " Type=\"Rect\" W=\"9\" H=\"9\"/>";
  const Drawing drawn =
      read(project_of(settings + "<Shape CutIndex=\"2\"" + rect + "<Shape CutIndex=\"3\"" + rect));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  const Layer& layer = drawn.layers.at(drawn.contours[0].entity.layer);
  EXPECT_EQ(layer.name, "Edge");
  EXPECT_EQ(layer.colour, "#ff0000");
  ASSERT_TRUE(layer.offered);
  EXPECT_EQ(layer.offered->kind, "Cut");
  EXPECT_EQ(layer.offered->power_share, 0.655);
  EXPECT_EQ(layer.offered->min_power_share, 0.2);
  EXPECT_EQ(layer.offered->speed_mm_s, 12.5);
  EXPECT_EQ(layer.offered->passes, 2U);
  EXPECT_EQ(layer.offered->priority, 1);
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kIgnored));
  EXPECT_THAT(drawn.faults[0].reason, HasSubstr("layer C03 is not sent to the laser"));
}

TEST(Lbrn, AKerfOffsetIsNotedOnceForItsLayer) {
  const std::string setting =
      "<CutSetting type=\"Cut\"><index Value=\"2\"/><name Value=\"Edge\"/><kerf Value=\"-0.1\"/>"
      "</CutSetting>";
  const std::string rects =
      "<Shape CutIndex=\"2\" Type=\"Rect\" W=\"9\" H=\"9\"/>"
      "<Shape CutIndex=\"2\" Type=\"Rect\" W=\"4\" H=\"4\"/>";
  const Drawing drawn = read(project_of(setting + rects));
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kNote));
  EXPECT_THAT(drawn.faults[0].reason,
              HasSubstr("layer Edge: the kerf offset of -0.1 mm is not used: set --kerf 0.2"));
}

TEST(Lbrn, WhatIsNotReadIsNamed) {
  const auto first = [](const std::string& content) {
    return to_string(read(project_of(content)).faults.at(0), "f");
  };
  EXPECT_THAT(first(shape("Type=\"Polygon\" N=\"6\" Rx=\"5\" Ry=\"5\"", kAtFive)),
              AllOf(HasSubstr("f:2:"), HasSubstr("Polygon: this kind of shape is not read")));
  EXPECT_THAT(first(shape("Type=\"Bitmap\" W=\"5\" H=\"5\"", kAtFive)),
              HasSubstr("does not "
                        "contain its data"));
  EXPECT_THAT(first(shape("Type=\"Rect\" W=\"0\" H=\"5\"", "")), HasSubstr("not above 0"));
  EXPECT_THAT(first(shape("Type=\"Rect\" W=\"5\" H=\"5\" Cr=\"-1\"", "")), HasSubstr("inwards"));
  EXPECT_THAT(first(shape("Type=\"Rect\" W=\"5\" H=\"5\"", "<XForm>1 0 0</XForm>")),
              HasSubstr("not six numbers"));
  EXPECT_THAT(first(shape("Type=\"Path\"", "<VertList>V0 x</VertList>")), HasSubstr("vertices"));
  EXPECT_THAT(
      first(shape("Type=\"Path\"", "<VertList>V0 0V5 5</VertList><PrimList>L0 2</PrimList>")),
      HasSubstr("list of lines and curves is broken"));
  EXPECT_THAT(to_string(read("<LightBurnProject><Shape").faults.at(0), "f"),
              HasSubstr("broken XML"));
  EXPECT_THAT(
      kinds_of(read(project_of(shape("Type=\"Rect\" W=\"9\" H=\"9\"", ""), "MirrorY=\"True\""))),
      ElementsAre(FaultKind::kNote));
}

TEST(Lbrn, ListsThatManyShareAreBounded) {
  std::string vertices;
  for (int i = 0; i < 20'000; ++i) vertices += "V0 0V9 9";
  std::string text = shape("Type=\"Path\" VertID=\"1\"",
                           "<VertList>" + vertices +
                               "</VertList><PrimList>L0 1"
                               "</PrimList>");
  for (int i = 0; i < 2'000; ++i)
    text += shape("Type=\"Path\" VertID=\"1\"", "<PrimList>L0 1</PrimList>");
  const Drawing drawn = read_drawing("f", project_of(text), {.effort = 0.01});
  EXPECT_THAT(kinds_of(drawn), testing::Contains(FaultKind::kTooMuch));
}

TEST(OtherFormats, AreRefusedWithTheWayRound) {
  const auto refusal = [](const std::string& text) {
    const Drawing drawn = read(text);
    EXPECT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kUnreadable));
    return to_string(drawn.faults.at(0), "f");
  };
  EXPECT_THAT(refusal("%!PS-Adobe-3.0 EPSF-3.0\n"), AllOf(HasSubstr("EPS"), HasSubstr("Inkscape")));
  EXPECT_THAT(refusal("AC1032"), AllOf(HasSubstr("DWG"), HasSubstr("save it as DXF")));
  EXPECT_THAT(refusal("\x89PNG\r\n"), HasSubstr("trace it"));
}

}  // namespace
}  // namespace sim::drawing
