#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "host-sim/import/clb_reader.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::drawing {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string clb_of(const std::string& materials) {
  return "<?xml version=\"1.0\"?>\n<LightBurnLibrary DisplayName=\"Shop\">" + materials +
         "</LightBurnLibrary>\n";
}

std::string entry_of(const std::string& attributes, const std::string& settings) {
  return fmt::format(
      "<Material name=\"Birch\"><Entry {}>{}</Entry></Material>", attributes, settings);
}

std::string fault_of_clb(const std::string& text) {
  try {
    static_cast<void>(read_clb(text, "shop.clb"));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(Clb, EntriesHaveMaterialThicknessAndSettings) {
  const MaterialLibrary library = read_clb(
      clb_of(entry_of("Thickness=\"3.0000\" Desc=\"Clean cut\" NoThickTitle=\"\"",
                      "<CutSetting type=\"Cut\"><maxPower Value=\"65\"/><speed Value=\"10\"/>"
                      "<numPasses Value=\"2\"/></CutSetting>") +
             entry_of("Thickness=\"-1.0000\" Desc=\"\" NoThickTitle=\"Fill\"",
                      "<CutSetting type=\"Scan\"><interval Value=\"0.08\"/></CutSetting>")),
      "shop.clb");
  EXPECT_EQ(library.name, "Shop");
  EXPECT_THAT(library.notes, IsEmpty());
  ASSERT_THAT(library.entries, SizeIs(2));
  const LibraryEntry& cut = library.entries[0];
  EXPECT_EQ(cut.material, "Birch");
  EXPECT_EQ(cut.description, "Clean cut");
  EXPECT_EQ(cut.thickness_mm, 3.0);
  EXPECT_EQ(cut.settings.kind, "Cut");
  EXPECT_EQ(cut.settings.power_share, 0.65);
  EXPECT_EQ(cut.settings.speed_mm_s, 10.0);
  EXPECT_EQ(cut.settings.passes, 2U);
  EXPECT_EQ(cut.line, 2U);
  const LibraryEntry& fill = library.entries[1];
  EXPECT_EQ(fill.description, "Fill");
  EXPECT_EQ(fill.thickness_mm, std::nullopt);
  EXPECT_EQ(fill.settings.interval_mm, 0.08);
  EXPECT_EQ(fill.settings.power_share, std::nullopt) << "what is not said is not known";
  EXPECT_EQ(fill.settings.passes, std::nullopt);
}

TEST(Clb, AKerfOffsetIsNoted) {
  const MaterialLibrary library =
      read_clb(clb_of(entry_of("Thickness=\"3\" Desc=\"Cut\"",
                               "<CutSetting type=\"Cut\"><kerf Value=\"0.07\"/></CutSetting>")),
               "shop.clb");
  ASSERT_THAT(library.notes, SizeIs(1));
  EXPECT_THAT(library.notes[0], testing::StartsWith("shop.clb:"));
  EXPECT_THAT(library.notes[0],
              testing::EndsWith("the kerf offset of 0.07 mm is not used: set --kerf 0.14, the full "
                                "width of the kerf, instead"));
}

TEST(Clb, WhatIsNoLibraryIsRefusedWithItsPlace) {
  EXPECT_EQ(fault_of_clb(""),
            "shop.clb:1:1: broken XML: No document element found; export the "
            "library again");
  EXPECT_THAT(fault_of_clb("<LightBurnLibrary>\n<Material"), HasSubstr("shop.clb:2:"));
  EXPECT_THAT(fault_of_clb("<svg/>"), HasSubstr("it is no library of materials of LightBurn"));
  EXPECT_THAT(fault_of_clb(clb_of("")), HasSubstr("has no entry that can be used"));
}

TEST(Clb, WhatIsLeftOutIsANote) {
  const std::string good = entry_of("Thickness=\"2\"", "<CutSetting type=\"Cut\"/>");
  const auto note_of = [&good](const std::string& other) {
    const MaterialLibrary library = read_clb(clb_of("\n" + other + good), "shop.clb");
    return library.notes.empty() ? "none" : library.notes.front();
  };
  EXPECT_THAT(note_of("<Material><Entry/></Material>"),
              AllOf(HasSubstr("shop.clb:3:1: "), HasSubstr("needs a name of 1 to 100 bytes")));
  EXPECT_THAT(note_of("<Material name=\"" + std::string(101, 'x') + "\"/>"),
              HasSubstr("100 bytes"));
  EXPECT_THAT(note_of("<Material name=\"a&#10;b\"/>"), HasSubstr("without line ends"));
  EXPECT_THAT(note_of(entry_of("Thickness=\"3\"", "")), HasSubstr("has no CutSetting"));
  for (const char* const wrong : {"thin", "101", "3mm", "nan", "1e9"}) {
    EXPECT_THAT(note_of(entry_of(fmt::format("Thickness=\"{}\"", wrong), "<CutSetting/>")),
                HasSubstr(fmt::format("Thickness {} is no number up to 100 mm", wrong)));
  }
  EXPECT_EQ(note_of(entry_of("Desc=\"any\"", "<CutSetting type=\"Cut\"/>")), "none");
}

TEST(Clb, ManyEntriesAreRefused) {
  std::string settings;
  for (std::size_t i = 0; i <= kMaxLibraryEntries; ++i) settings += "<CutSetting/>";
  EXPECT_THAT(fault_of_clb(clb_of(entry_of("", settings))), HasSubstr("more than 20000 entries"));
}

TEST(Clb, AnyNumberIsReadAsWrittenOrNotKnown) {
  proof::Trials trials{200};
  std::size_t known = 0;
  for (const auto seed : trials) {
    proof::Random random{seed};
    const double power = random.between(-20.0, 120.0);
    const double speed = std::pow(10.0, random.between(-3.0, 7.0)) - 0.01;
    const double thickness = random.between(-5.0, 120.0);
    const double passes = random.between(-2.0, 1200.0);
    const MaterialLibrary library =
        read_clb(clb_of(entry_of(fmt::format("Thickness=\"{}\"", thickness),
                                 fmt::format("<CutSetting type=\"Cut\"><maxPower Value=\"{}\"/>"
                                             "<speed Value=\"{}\"/><numPasses Value=\"{}\"/>"
                                             "</CutSetting>",
                                             power,
                                             speed,
                                             passes))),
                 "shop.clb");
    ASSERT_THAT(library.entries, SizeIs(1));
    const LibraryEntry& entry = library.entries[0];
    const bool has_power = power >= 0.0 && power <= 100.0;
    ASSERT_EQ(entry.settings.power_share.has_value(), has_power);
    if (has_power) {
      EXPECT_NEAR(100.0 * *entry.settings.power_share, power, 1e-12 * power);
    }
    const bool has_speed = speed > 0.0 && speed <= 1.0e5;
    ASSERT_EQ(entry.settings.speed_mm_s.has_value(), has_speed);
    if (has_speed) {
      EXPECT_EQ(*entry.settings.speed_mm_s, speed);
    }
    const bool has_thickness = thickness > 0.0 && thickness <= 100.0;
    ASSERT_EQ(entry.thickness_mm.has_value(), has_thickness);
    if (has_thickness) {
      EXPECT_EQ(*entry.thickness_mm, thickness);
    }
    const bool has_passes = passes >= 1.0 && passes <= 1000.0;
    ASSERT_EQ(entry.settings.passes.has_value(), has_passes);
    if (has_passes) {
      EXPECT_EQ(*entry.settings.passes, static_cast<std::size_t>(passes));
    }
    known += has_power && has_speed && has_thickness && has_passes ? 1 : 0;
  }
  if (trials.judges_shares()) {
    EXPECT_GT(known, 0U);
  }
}

}  // namespace
}  // namespace sim::drawing
