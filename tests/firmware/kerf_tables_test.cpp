#include "firmware/store/kerf_tables.hpp"

#include <gmock/gmock.h>

#include <array>
#include <string>
#include <vector>

#include "firmware/store/flash_log.hpp"
#include "hal/host/flash_model.hpp"
#include "planner/kerf/csp_1n.hpp"
#include "planner/kerf/table_check.hpp"
#include "tests/firmware/controller_test.hpp"
#include "tests/planner/kerf/random_table.hpp"

namespace cnc {
namespace {

using kerf::OwnedTable;
using testing::HasSubstr;

/// Returns a table with `thicknesses` rows of one power, all with the kerf `kerf_mm`.
OwnedTable<float> flat_table(const std::string& name, std::size_t thicknesses, float kerf_mm) {
  OwnedTable<float> table{.name = name};
  for (std::size_t i = 0; i < thicknesses; ++i) {
    const auto n = static_cast<std::uint16_t>(i);
    table.rows.push_back({1000U + 500U * n, {0.0F, kerf_mm}, false, n, 1});
    table.bands.push_back({1'000'000, 2'000'000, 4'000'000, 0, 0});
  }
  return table;
}

std::vector<std::byte> image_bytes(const OwnedTable<float>& table) {
  std::array<std::byte, kerf::table_image::kMaxBytes> image{};
  const std::size_t size = kerf::write_image(table.view(), image).value();
  return {image.begin(), image.begin() + static_cast<std::ptrdiff_t>(size)};
}

std::vector<std::string> lines_of(const std::vector<std::byte>& image) {
  std::vector<std::string> lines;
  constexpr char kDigits[] = "0123456789ABCDEF";
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (i % 96 == 0) lines.push_back("$KW=" + std::to_string(i / 96) + ":");
    const auto value = std::to_integer<unsigned>(image[i]);
    lines.back() += kDigits[value >> 4];
    lines.back() += kDigits[value & 15U];
  }
  lines.emplace_back("$KS");
  return lines;
}

class KerfStatements : public ControllerTest {
 protected:
  std::string write(const OwnedTable<float>& table) {
    std::string answer = "nothing";
    for (const std::string& line : lines_of(image_bytes(table))) {
      answer = send(line);
      if (answer != "ok") break;
    }
    return answer;
  }
  /// Returns all answers to a line, joined to one line.
  std::string said_to(std::string_view line) {
    link.outgoing.clear();
    send(line);
    std::string all;
    for (const std::string& row : printed()) all += row + "\n";
    return all;
  }
};

TEST_F(KerfStatements, ListsWhatIsBuiltIn) {
  EXPECT_EQ(said_to("$K"),
            "[KERF:CSP 1N|W/(mm/min)|T 0.5-2|P 1200-1800|built in]\n"
            "[KERF:CSP 1N J/mm|J/mm|T 0.5-2|P 1200-1800|built in]\n"
            "[KERFROOM:0 of 4 stored]\nok\n");
}

TEST_F(KerfStatements, AnswersTheWorkedExample) {
  EXPECT_EQ(said_to("$KQ=CSP 1N,2.0,1800,4000"), "[KERF:CSP 1N|0.562745 mm]\nok\n");
  EXPECT_EQ(said_to("$kq = CSP 1N J/mm, 2, 1800, 4000"), "[KERF:CSP 1N J/mm|0.7247 mm]\nok\n");
}

TEST_F(KerfStatements, SaysWhatIsPermissible) {
  EXPECT_THAT(said_to("$KQ=CSP 1N,2,1800,5000.001"),
              HasSubstr("speeds from 3000 to 5000 mm/min are permissible]\nerror:2"));
  EXPECT_THAT(said_to("$KQ=CSP 1N,2,1800.5,4000"), HasSubstr("powers from 1200 to 1800 W"));
  EXPECT_THAT(said_to("$KQ=CSP 1N,0.499,1800,4000"), HasSubstr("thicknesses from 0.5 to 2 mm"));
  EXPECT_THAT(said_to("$KQ=CSP 2N,2,1800,4000"), HasSubstr("no such kerf table"));
  for (const char* line : {"$KQ=",
                           "$KQ=CSP 1N",
                           "$KQ=CSP 1N,2,1800",
                           "$KQ=CSP 1N,2,1800,nan",
                           "$KQ=CSP 1N,2,1800,4000,1",
                           "$KQ=CSP 1N,-2,1800,4000",
                           "$KQ=CSP 1N,2.0001,1800,4000",
                           "$KQ=CSP 1N,2,1800,4294967296"}) {
    EXPECT_THAT(said_to(line), HasSubstr("not of the form name,mm,W,mm/min")) << line;
  }
}

TEST_F(KerfStatements, KeepsATableThroughPowerAndReadsItBack) {
  const OwnedTable<float> table = flat_table("plate", 3, 0.25F);
  EXPECT_EQ(write(table), "ok");
  EXPECT_THAT(said_to("$K"), HasSubstr("[KERF:plate|W/(mm/min)|T 1-2|P 1000|stored]"));
  EXPECT_EQ(said_to("$KQ=plate,1.25,1000,3000"), "[KERF:plate|0.250 mm]\nok\n");
  std::string written;
  for (const std::string& line : lines_of(image_bytes(table))) written += line + "\n";
  EXPECT_EQ(said_to("$KR=plate"), written + "ok\n");
  MemoryLink other;
  Application<hal::host::RecordingPort> again{port, port, port, store, other};
  other.incoming = "$KQ=plate,1.25,1000,3000\n";
  for (std::uint32_t turn = 0; turn < 20; ++turn) again.poll(hal::TickCount{1000 * turn});
  EXPECT_THAT(other.outgoing, HasSubstr("[KERF:plate|0.250 mm]\r\nok"));
}

TEST_F(KerfStatements, ATableTakesThePlaceOfTheOneOfItsName) {
  for (const float width : {0.25F, 0.3F, 0.35F}) {
    EXPECT_EQ(write(flat_table("plate", 8, width)), "ok");
  }
  EXPECT_THAT(said_to("$KQ=plate,1,1000,3000"), HasSubstr("|0.350 mm]"));
  EXPECT_THAT(said_to("$K"), HasSubstr("[KERFROOM:1 of 4 stored]"));
}

TEST_F(KerfStatements, HasRoomForFourAndForgets) {
  for (const char* name : {"a", "b", "c", "d"}) EXPECT_EQ(write(flat_table(name, 8, 0.2F)), "ok");
  link.outgoing.clear();
  EXPECT_EQ(write(flat_table("e", 1, 0.2F)), "error:2");
  EXPECT_THAT(link.outgoing, HasSubstr("no room for another kerf table, 4 are kept"));
  EXPECT_EQ(write(flat_table("c", 8, 0.3F)), "ok") << "one of them can be replaced";
  EXPECT_EQ(send("$KE=b"), "ok");
  EXPECT_EQ(write(flat_table("e", 8, 0.4F)), "ok");
  for (const auto& [name, width] : std::vector<std::pair<std::string, std::string>>{
           {"a", "0.2"}, {"c", "0.3"}, {"d", "0.2"}, {"e", "0.4"}}) {
    EXPECT_THAT(said_to("$KQ=" + name + ",4.5,1000,2000"), HasSubstr("|" + width));
  }
  EXPECT_EQ(send("$KE=b"), "error:2");
  EXPECT_EQ(send("$KE=CSP 1N"), "error:2");
  EXPECT_EQ(send("$KE=*"), "ok");
  EXPECT_TRUE(store.records().empty());
}

TEST_F(KerfStatements, GoesWithAllTheRest) {
  EXPECT_EQ(write(flat_table("plate", 8, 0.25F)), "ok");
  EXPECT_EQ(send("$RST=$"), "ok");
  run(100);
  EXPECT_EQ(send("$KQ=plate,1,1000,3000"), "ok");
  EXPECT_EQ(send("$RST=*"), "ok");
  run(100);
  EXPECT_EQ(send("$KQ=plate,1,1000,3000"), "error:2");
  EXPECT_TRUE(store.records().empty());
}

TEST_F(KerfStatements, RefusesWhatIsNoTable) {
  EXPECT_THAT(said_to("$KS"), HasSubstr("no kerf table was written; begin with $KW=0:"));
  for (const char* line :
       {"$KW=", "$KW=0", "$KW=:00", "$KW=x:00", "$KW=0:0", "$KW=0:0G", "$KW=100:00"}) {
    EXPECT_THAT(said_to(line), HasSubstr("not a part of the form n:hex digits")) << line;
  }
  EXPECT_THAT(said_to("$KW=1:00"), HasSubstr("parts come in order"));
  auto lines = lines_of(image_bytes(flat_table("plate", 8, 0.25F)));
  EXPECT_EQ(send(lines[0]), "ok");
  EXPECT_THAT(said_to(lines[2]), HasSubstr("parts come in order"));
  EXPECT_EQ(send("$KS"), "error:2");
  EXPECT_EQ(send(lines[0]), "ok");
  EXPECT_THAT(said_to("$KS"), HasSubstr("is not as long as its header says"));
  lines[1].back() = lines[1].back() == '0' ? '1' : '0';
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) EXPECT_EQ(send(lines[i]), "ok");
  EXPECT_THAT(said_to("$KS"), HasSubstr("CRC-32 is wrong"));
  EXPECT_EQ(store.records().count(0x6000), 0U) << "no table counts";
}

TEST_F(KerfStatements, SaysAtOnceWhatDoesNotFit) {
  auto image = image_bytes(flat_table("plate", 8, 0.25F));
  image[7] = std::byte{9};
  EXPECT_THAT(said_to(lines_of(image)[0]),
              HasSubstr("kerf table has 9 thicknesses, capacity 8]\nerror:2"));
  image[3] = std::byte{2};
  EXPECT_THAT(said_to(lines_of(image)[0]), HasSubstr("of another version"));
}

TEST_F(KerfStatements, RefusesNamesThatAreTakenOrMisread) {
  link.outgoing.clear();
  EXPECT_EQ(write(flat_table("CSP 1N", 1, 0.2F)), "error:2");
  EXPECT_THAT(link.outgoing, HasSubstr("built in"));
  EXPECT_EQ(write(flat_table("smoked glass", 1, 0.2F)), "error:2");
  EXPECT_THAT(said_to("$KR=CSP 1N"), HasSubstr("built in"));
}

TEST_F(KerfStatements, AreRefusedWhileAnythingMoves) {
  EXPECT_EQ(write(flat_table("plate", 1, 0.25F)), "ok");
  const int before = store.saves;
  send_all({"G1 X5 F300"});
  run(20);
  for (const char* line :
       {"$K", "$KS", "$KW=0:00", "$KE=plate", "$KR=plate", "$KQ=plate,1,1000,3000"}) {
    EXPECT_EQ(send(line), "error:8") << line;
  }
  EXPECT_EQ(store.saves, before);
}

TEST_F(KerfStatements, ADamagedTableIsNeverBelieved) {
  EXPECT_EQ(write(flat_table("plate", 8, 0.25F)), "ok");
  for (const auto& [number, record] : hal::host::MemoryStore::Records{store.records()}) {
    if (number < 0x6100) continue;
    for (std::size_t i = 0; i < record.size(); ++i) {
      auto damaged = record;
      damaged[i] ^= std::byte{0x10};
      ASSERT_TRUE(store.save(number, damaged));
      KerfTables tables{store};
      EXPECT_FALSE(tables.table(KerfTables::built_in()).ok()) << number << ' ' << i;
    }
    ASSERT_TRUE(store.save(number, {}));
    EXPECT_THAT(said_to("$K"), HasSubstr("[KERF:?|damaged]"));
    ASSERT_TRUE(store.save(number, record));
  }
  EXPECT_EQ(send("$KQ=plate,1,1000,3000"), "ok");
  ASSERT_TRUE(store.save(0x6000, std::vector<std::byte>(12, std::byte{0xFF})));
  EXPECT_THAT(said_to("$K"), HasSubstr("[KERFROOM:0 of 4 stored]"));
}

bool keep(KerfTables& tables, const OwnedTable<float>& table) {
  const auto image = image_bytes(table);
  for (std::size_t part = 0; part * 96 < image.size(); ++part) {
    const auto rest = std::span{image}.subspan(part * 96);
    if (tables.take_part(part, rest.first(std::min<std::size_t>(96, rest.size())))) return false;
  }
  return !tables.check() && !tables.keep();
}

/// Returns the width in mm, or -1 if the table does not exist.
float width_of(KerfTables& tables, std::string_view name) {
  const auto index = tables.find(name);
  if (!index.ok()) return -1.0F;
  const auto table = tables.table(index.value());
  EXPECT_TRUE(table.ok()) << name << " is damaged";
  if (!table.ok()) return -2.0F;
  return kerf::kerf_width(table.value(), {1000, 1'000'000, 3'000'000}).value();
}

/// Replaces, deletes and rewrites one of two tables, and cuts the power at each flash operation in
/// between. Afterwards the table is the complete old or the complete new one, and the other table
/// is unchanged.
TEST(KerfTablesInFlash, AreOldOrNewWhereverThePowerGoes) {
  using hal::host::CutKind;
  for (const CutKind kind :
       {CutKind::kBefore, CutKind::kAfter, CutKind::kTorn, CutKind::kMarginal}) {
    hal::host::FlashModel flash{2, 600};
    FlashLog log{flash};
    KerfTables tables{log};
    ASSERT_TRUE(keep(tables, flat_table("rest", 4, 0.5F)));
    float old_width = -1.0F;
    float new_width = -1.0F;
    int cuts = 0;
    int erases = 0;
    flash.watch([&](const hal::host::FlashModel& before, const hal::host::FlashOperation& next) {
      hal::host::FlashModel cut = before;
      cut.watch(nullptr);
      if (next.kind == hal::host::FlashOperation::Kind::kErase) ++erases;
      const auto seed = static_cast<std::uint64_t>(++cuts);
      cut.cut_at(next, kind, seed);
      cut.power_up(seed, hal::host::Unsteadiness::kEachPowerUp);
      FlashLog log_after{cut};
      KerfTables after{log_after};
      const float width = width_of(after, "plate");
      EXPECT_TRUE(width == old_width || width == new_width) << "cut " << cuts << ": " << width;
      EXPECT_EQ(width_of(after, "rest"), 0.5F) << "cut " << cuts;
      EXPECT_TRUE(keep(after, flat_table("plate", 2, 0.9F))) << "cut " << cuts;
      EXPECT_EQ(width_of(after, "plate"), 0.9F) << "cut " << cuts;
    });
    for (const float width :
         {0.1F, 0.2F, -1.0F, 0.3F, 0.4F, 0.5F, 0.6F, -1.0F, 0.7F, 0.8F, 0.1F, 0.2F, 0.3F}) {
      new_width = width;
      if (width < 0.0F) {
        EXPECT_FALSE(tables.forget("plate"));
      } else {
        EXPECT_TRUE(keep(tables, flat_table("plate", 5, width)));
      }
      EXPECT_EQ(width_of(tables, "plate"), width);
      old_width = width;
    }
    EXPECT_GT(cuts, 300);
    EXPECT_GT(erases, 0) << "or no compaction was cut";
    std::printf("%d cuts, %d of them in an erase\n", cuts, erases);
  }
}

TEST(KerfTablesInFlash, AFullStoreRefusesAndKeepsWhatWasThere) {
  hal::host::FlashModel flash{2, 128};
  FlashLog log{flash};
  KerfTables tables{log};
  ASSERT_TRUE(keep(tables, flat_table("a", 2, 0.1F)));
  ASSERT_TRUE(keep(tables, flat_table("b", 2, 0.2F)));
  EXPECT_FALSE(keep(tables, flat_table("c", 8, 0.3F))) << "half a KiB holds no third";
  EXPECT_EQ(width_of(tables, "a"), 0.1F);
  EXPECT_EQ(width_of(tables, "b"), 0.2F);
  EXPECT_EQ(width_of(tables, "c"), -1.0F);
}

}  // namespace
}  // namespace cnc
