#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "tests/host-sim/import/support.hpp"

namespace sim::drawing {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

/// Builds the bytes of a binary DXF file, with codes of one byte (Release 12) or of two.
class BinaryDxf {
 public:
  explicit BinaryDxf(std::size_t code_bytes) : code_bytes_{code_bytes} {}

  BinaryDxf& text(int code, std::string_view value) {
    whole(static_cast<std::uint64_t>(code), code_bytes_);
    bytes_ += value;
    bytes_ += '\0';
    return *this;
  }
  BinaryDxf& real(int code, double value) {
    whole(static_cast<std::uint64_t>(code), code_bytes_);
    whole(std::bit_cast<std::uint64_t>(value), sizeof(double));
    return *this;
  }
  BinaryDxf& small(int code, std::int16_t value) {
    whole(static_cast<std::uint64_t>(code), code_bytes_);
    whole(static_cast<std::uint16_t>(value), sizeof(value));
    return *this;
  }
  BinaryDxf& extended_text(int code, std::string_view value) {
    if (code_bytes_ == 1) bytes_ += '\xFF';
    whole(static_cast<std::uint64_t>(code), 2);
    bytes_ += value;
    bytes_ += '\0';
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  void whole(std::uint64_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      bytes_ += static_cast<char>(value & 0xFFU);
      value >>= 8U;
    }
  }

  std::size_t code_bytes_;
  std::string bytes_{"AutoCAD Binary DXF\r\n\x1A\0", 22};
};

std::string binary_line(std::size_t code_bytes) {
  return BinaryDxf{code_bytes}
      .text(0, "SECTION")
      .text(2, "ENTITIES")
      .text(0, "LINE")
      .text(8, "Cut")
      .small(62, 3)
      .real(10, 0.1)
      .real(20, -2.5)
      .real(11, 30.0)
      .real(21, 40.0)
      .extended_text(1000, "note")
      .text(0, "ENDSEC")
      .text(0, "EOF")
      .bytes();
}

TEST(BinaryDxf, IsReadWithCodesOfOneByteAndOfTwo) {
  for (const std::size_t code_bytes : {1U, 2U}) {
    SCOPED_TRACE(code_bytes);
    const Drawing drawn = read(binary_line(code_bytes));
    ASSERT_THAT(drawn.contours, SizeIs(1));
    EXPECT_EQ(start_of(drawn.contours[0].shapes[0]), (Place{0.1, -2.5}));
    EXPECT_EQ(end_of(drawn.contours[0].shapes[0]), (Place{30.0, 40.0}));
    EXPECT_EQ(drawn.layers.at(0), (Layer{"Cut", "ACI 3"}));
  }
}

TEST(BinaryDxf, ThatIsCutOffSaysSo) {
  const std::string whole = binary_line(2);
  for (std::size_t bytes = 18; bytes + 4 < whole.size(); ++bytes) {
    const Drawing drawn = read(whole.substr(0, bytes));
    EXPECT_TRUE(drawn.has_errors()) << bytes;
  }
}

std::string in_header(const std::string& variables, const std::string& entities) {
  return "0\nSECTION\n2\nHEADER\n" + variables + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities +
         "0\nENDSEC\n0\nEOF\n";
}

std::string circle_on(const std::string& layer) {
  return "0\nCIRCLE\n8\n" + layer + "\n10\n0\n20\n0\n40\n9\n";
}

TEST(DxfText, NamesAreOfTheCodePageOrUtf8OrEscaped) {
  const std::string units = "9\n$INSUNITS\n70\n4\n";
  const auto layer = [&](const std::string& page, const std::string& name) {
    const std::string stated = page.empty() ? "" : "9\n$DWGCODEPAGE\n3\n" + page + "\n";
    return read(in_header(units + stated, circle_on(name)));
  };
  EXPECT_EQ(layer("ANSI_1252",
                  "Stra\xDF"
                  "e")
                .layers.at(0)
                .name,
            "Stra\u00DFe");
  EXPECT_EQ(layer("ansi_1251", "\xC4").layers.at(0).name, "\u0414");
  EXPECT_EQ(layer("ANSI_1252", "Stra\u00DFe").layers.at(0).name, "Stra\u00DFe");
  EXPECT_EQ(layer("ANSI_1252", "a\\U+00DFb\\U+D83D\\U+DE00").layers.at(0).name,
            "a\u00DFb\U0001F600");
  EXPECT_EQ(layer("ANSI_1252", "\\U+000A\\U+12").layers.at(0).name, "\\U+000A\\U+12");
  EXPECT_THAT(layer("ANSI_1252",
                    "Stra\xDF"
                    "e")
                  .faults,
              IsEmpty());
  const Drawing missing = layer("",
                                "Stra\xDF"
                                "e");
  EXPECT_EQ(missing.layers.at(0).name, "Stra\u00DFe");
  ASSERT_THAT(kinds_of(missing), ElementsAre(FaultKind::kNote));
  EXPECT_THAT(missing.faults[0].reason, HasSubstr("$DWGCODEPAGE is missing"));
  EXPECT_THAT(layer("ANSI_932", "\xDF\xFF\xFF").faults.at(0).reason, HasSubstr("2 bytes"));
}

TEST(DxfHeader, UnitsScaleAndMissingOnesAreTold) {
  const auto length = [](const std::string& unit, ImportOptions options = {}) {
    const std::string line = "0\nLINE\n10\n0\n20\n0\n11\n1\n21\n0\n";
    const Drawing drawn = read_drawing("f", in_header(unit, line), options);
    return drawn.contours.at(0).length_mm;
  };
  EXPECT_NEAR(length("9\n$INSUNITS\n70\n21\n"), 304.8006096, 1e-6);
  EXPECT_NEAR(length("9\n$INSUNITS\n70\n5\n"), 10.0, 1e-12);
  EXPECT_NEAR(length("9\n$INSUNITS\n70\n5\n", {.unit_mm = 25.4}), 25.4, 1e-12);
  const Drawing drawn = read(in_header("9\n$MEASUREMENT\n70\n0\n", circle_on("0")));
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kNote));
  EXPECT_THAT(drawn.faults[0].reason, HasSubstr("mm is assumed, though $MEASUREMENT says English"));
  EXPECT_FALSE(drawn.has_errors());
  const ImportOptions inches{.unit_mm = 25.4};
  EXPECT_THAT(read_drawing("f", in_header("", circle_on("0")), inches).faults, IsEmpty());
}

std::string layer_record(const std::string& name, const std::string& groups) {
  return "0\nLAYER\n2\n" + name + "\n" + groups;
}

std::string with_tables(const std::string& tables,
                        const std::string& blocks,
                        const std::string& entities) {
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n" + tables +
         "0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n" + blocks + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" +
         entities + "0\nENDSEC\n0\nEOF\n";
}

TEST(DxfLayers, WhatIsHiddenIsNamedAndNotDrawn) {
  const std::string tables = layer_record("Off", "62\n-3\n") + layer_record("Ice", "70\n1\n") +
                             layer_record("Plan", "290\n0\n") + layer_record("Seen", "62\n1\n");
  const Drawing drawn =
      read(with_tables(tables,
                       "",
                       circle_on("OFF") + circle_on("ice") + circle_on("Plan") + circle_on("SEEN") +
                           circle_on("Other\n60\n1") + circle_on("Other\n67\n1")));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_EQ(drawn.layers.at(drawn.contours[0].entity.layer), (Layer{"Seen", "ACI 1"}));
  std::string reasons;
  for (const Fault& fault : drawn.faults) reasons += fault.reason + "\n";
  EXPECT_THAT(reasons,
              AllOf(HasSubstr("layer Off is off"),
                    HasSubstr("layer Ice is frozen"),
                    HasSubstr("layer Plan is not plotted"),
                    HasSubstr("invisible entities"),
                    HasSubstr("entities in paper space")));
  EXPECT_FALSE(drawn.has_errors());
}

TEST(DxfLayers, AnInsertOnALayerThatIsOffBringsWhatIsOnOthers) {
  const std::string block = "0\nBLOCK\n2\nA\n" + circle_on("Seen") + circle_on("0") + "0\nENDBLK\n";
  const auto drawn_by = [&](const std::string& record) {
    return read(with_tables(layer_record("L", record), block, "0\nINSERT\n8\nL\n2\na\n"));
  };
  EXPECT_THAT(drawn_by("62\n-1\n").contours, SizeIs(1));
  EXPECT_THAT(drawn_by("70\n1\n").contours, IsEmpty());
}

TEST(DxfNotes, WidthsLineTypesAndTiltsAreTold) {
  const auto note = [](const std::string& entity) {
    const std::string tables = "0\nLTYPE\n2\nDASHED\n73\n2\n0\nLTYPE\n2\nPlain\n73\n0\n" +
                               layer_record("D", "6\nDASHED\n");
    const Drawing drawn = read(with_tables(tables, "", entity));
    EXPECT_FALSE(drawn.has_errors());
    EXPECT_THAT(drawn.contours, SizeIs(1));
    return drawn.faults.empty() ? std::string{} : drawn.faults[0].reason;
  };
  const std::string corners = "70\n1\n10\n0\n20\n0\n10\n9\n20\n0\n10\n9\n20\n9\n";
  EXPECT_EQ(note("0\nLWPOLYLINE\n8\n0\n43\n0\n" + corners), "");
  EXPECT_THAT(note("0\nLWPOLYLINE\n8\n0\n43\n2\n" + corners), HasSubstr("has a width"));
  EXPECT_THAT(note(circle_on("D")), HasSubstr("line type DASHED"));
  EXPECT_THAT(note(circle_on("0\n6\ndashed")), HasSubstr("line type DASHED"));
  EXPECT_EQ(note(circle_on("D\n6\nPLAIN")), "");
  EXPECT_EQ(note(circle_on("D\n6\nContinuous")), "");
  EXPECT_THAT(note(circle_on("0\n210\n1\n230\n1")), HasSubstr("is tilted"));
}

TEST(DxfKinds, LettersAndAnnotationsAreNotesAndUnreadLinesAreFaults) {
  const auto kind = [](const std::string& type) {
    return kinds_of(read(dxf_of("0\n" + type + "\n8\nN\n")));
  };
  EXPECT_THAT(kind("TEXT"), ElementsAre(FaultKind::kText));
  EXPECT_THAT(kind("DIMENSION"), ElementsAre(FaultKind::kIgnored));
  EXPECT_THAT(kind("HATCH"), ElementsAre(FaultKind::kIgnored));
  EXPECT_THAT(kind("REGION"), ElementsAre(FaultKind::kBadEntity));
  EXPECT_THAT(kind("MLINE"), ElementsAre(FaultKind::kBadEntity));
  EXPECT_THAT(kind("FUTURE"), ElementsAre(FaultKind::kBadEntity));
  EXPECT_EQ(read(dxf_of("0\nTEXT\n8\nN\n")).layers.at(0).name, "N") << "a layer to be named";
}

TEST(DxfFaces, SolidsTurnAndFacesHideEdges) {
  const std::string corners = "10\n0\n20\n0\n11\n9\n21\n0\n12\n0\n22\n9\n13\n9\n23\n9\n";
  const Drawing solid = read(dxf_of("0\nSOLID\n8\n0\n" + corners));
  ASSERT_THAT(solid.contours, SizeIs(1));
  EXPECT_THAT(solid.faults, IsEmpty());
  EXPECT_NEAR(solid.contours[0].area_mm2, 81.0, 1e-9);
  const std::string square = "10\n0\n20\n0\n11\n9\n21\n0\n12\n9\n22\n9\n13\n0\n23\n9\n";
  EXPECT_NEAR(read(dxf_of("0\n3DFACE\n8\n0\n" + square)).contours.at(0).area_mm2, 81.0, 1e-9);
  const Drawing hidden = read(dxf_of("0\n3DFACE\n8\n0\n70\n2\n" + square));
  ASSERT_THAT(hidden.contours, SizeIs(1));
  EXPECT_FALSE(hidden.contours[0].closed);
  EXPECT_NEAR(hidden.contours[0].length_mm, 27.0, 1e-9);
}

/// Returns a drawing of a block with lines, which the filter clips.
Drawing clipped_block(const std::string& filter, const std::string& insert = "10\n0\n20\n0\n") {
  const auto line = [](const std::string& from, const std::string& to, const std::string& y) {
    return "0\nLINE\n8\n0\n10\n" + from + "\n20\n" + y + "\n11\n" + to + "\n21\n" + y + "\n";
  };
  const std::string block = "0\nBLOCK\n2\nA\n" + line("1", "4", "5") + line("12", "15", "5") +
                            line("5", "15", "6") + "0\nENDBLK\n";
  std::string text = dxf_of("0\nINSERT\n5\n10\n2\nA\n" + insert, block);
  text.resize(text.size() - 6);
  return read(text +
              "0\nSECTION\n2\nOBJECTS\n0\nDICTIONARY\n5\n20\n330\n10\n0\nDICTIONARY\n5\n21"
              "\n330\n20\n0\nSPATIAL_FILTER\n5\n22\n330\n21\n" +
              filter + "0\nENDSEC\n0\nEOF\n");
}

/// Returns the two matrices of a boundary that lies `x` `y` from the block's origin.
std::string matrices_of(const std::string& x, const std::string& y) {
  const std::string one = "40\n1\n40\n0\n40\n0\n40\n";
  const std::string rest = "40\n0\n40\n1\n40\n0\n40\n";
  const std::string last = "40\n0\n40\n0\n40\n1\n40\n0\n";
  return one + x + "\n" + rest + y + "\n" + last + one + "0\n" + rest + "0\n" + last;
}

TEST(DxfClips, InsideIsKeptOutsideIsNotedAcrossIsAFault) {
  const std::string rectangle = "70\n2\n10\n0\n20\n0\n10\n10\n20\n10\n71\n1\n72\n0\n73\n0\n";
  const Drawing drawn = clipped_block(rectangle + matrices_of("0", "0"));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_NEAR(start_of(drawn.contours[0].shapes[0]).x(), 1.0, 1e-9);
  std::string all;
  for (const Fault& fault : drawn.faults) all += to_string(fault, "f") + "\n";
  EXPECT_THAT(all, HasSubstr("outside of the boundary of their block (XCLIP) are not visible"));
  EXPECT_THAT(all, HasSubstr("it crosses the boundary of INSERT 10 (XCLIP) and is left out"));
  EXPECT_THAT(clipped_block("70\n2\n10\n0\n20\n0\n10\n10\n20\n10\n71\n0\n").contours, SizeIs(3))
      << "it is off";
}

TEST(DxfClips, BoundariesGoWithTheBlockWhereverItIs) {
  // The boundary was set when the block was at 100 0; now the block is half as large.
  const std::string polygon =
      "70\n4\n10\n100\n20\n0\n10\n120\n20\n0\n10\n120\n20\n5.5\n10\n100\n20\n5.5\n71\n1\n";
  const Drawing drawn = clipped_block(polygon + matrices_of("-100", "0"),
                                      "10\n200\n20\n50\n41\n0.5\n42\n0.5\n50\n90\n");
  ASSERT_THAT(drawn.contours, SizeIs(2));
  const Place start = start_of(drawn.contours[0].shapes[0]);
  EXPECT_NEAR(start.x(), 200.0 - 2.5, 1e-9);
  EXPECT_NEAR(start.y(), 50.5, 1e-9);
  EXPECT_THAT(kinds_of(drawn), Not(Contains(FaultKind::kBadEntity)));
}

/// The boundary belongs to a dictionary of filters, which belongs to a dictionary of the entity,
/// which belongs to the entity.
TEST(DxfInserts, ClippedOnesAndThoseOfOtherFilesAreFaults) {
  const auto drawn_by = [](const std::string& is_on) {
    const std::string block = "0\nBLOCK\n2\nA\n" + circle_on("0") + "0\nENDBLK\n";
    std::string text = dxf_of("0\nINSERT\n5\n10\n2\nA\n0\nINSERT\n5\n11\n2\nA\n10\n50\n", block);
    text.resize(text.size() - 6);
    return read(
        text +
        "0\nSECTION\n2\nOBJECTS\n0\nDICTIONARY\n5\n20\n102\n{ACAD_REACTORS\n330\n99\n102\n}"
        "\n330\n10\n0\nDICTIONARY\n5\n21\n330\n20\n0\nSPATIAL_FILTER\n5\n22\n330\n21\n71\n" +
        is_on + "\n0\nENDSEC\n0\nEOF\n");
  };
  const Drawing clipped = drawn_by("1");
  EXPECT_THAT(clipped.contours, SizeIs(1));
  ASSERT_THAT(kinds_of(clipped), ElementsAre(FaultKind::kBadEntity));
  EXPECT_THAT(clipped.faults[0].reason,
              HasSubstr("is clipped (XCLIP) at a boundary that is not in the plan"));
  EXPECT_EQ(clipped.faults[0].entity.name, "INSERT 10");
  EXPECT_THAT(drawn_by("0").contours, SizeIs(2));
  const Drawing other = read(dxf_of("0\nINSERT\n2\nA\n", "0\nBLOCK\n2\nA\n70\n4\n0\nENDBLK\n"));
  ASSERT_THAT(kinds_of(other), ElementsAre(FaultKind::kBadEntity));
  EXPECT_THAT(other.faults[0].reason, HasSubstr("is in another file"));
}

}  // namespace
}  // namespace sim::drawing
