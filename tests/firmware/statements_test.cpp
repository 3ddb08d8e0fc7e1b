#include <algorithm>
#include <random>
#include <regex>

#include "firmware/protocol/identity.hpp"
#include "tests/firmware/controller_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

/// Statements that begin with `$`.
class StatementsTest : public ControllerTest {
 protected:
  /// Returns all lines that answer `line`, including its acknowledgement.
  std::vector<std::string> lines_of(std::string_view line) {
    link.outgoing.clear();
    send(line);
    return printed();
  }
  void restart() {
    stream("\x18");
    run(20);
  }
};

using Lines = std::vector<std::string>;

TEST_F(StatementsTest, Help) {
  EXPECT_EQ(
      lines_of("$"),
      (Lines{"[HLP:$$ $# $G $I $N $x=val $Nx=line $J=line $SLP $C $X $H ~ ! ? ctrl-x]", "ok"}));
}

TEST_F(StatementsTest, ListSettingsAsNumbers) {
  const SettingInfo watchdog = *find_setting(setting::kLinkWatchdog);
  EXPECT_TRUE(machine.change_setting(watchdog.number, watchdog.standard).ok());
  const Lines lines = lines_of("$$");
  ASSERT_EQ(lines.size(), setting_table().size() + 1);
  EXPECT_EQ(lines[0], "$0=5.000");
  EXPECT_EQ(lines.back(), "ok");
  for (std::size_t i = 0; i < setting_table().size(); ++i) {
    const std::string begin = "$" + std::to_string(setting_table()[i].number) + "=";
    ASSERT_TRUE(lines[i].starts_with(begin)) << lines[i];
    EXPECT_EQ(std::stof(lines[i].substr(begin.size())), setting_table()[i].standard) << lines[i];
  }
  EXPECT_EQ(lines_of("$110"), (Lines{"$110=12000.000", "ok"}));
  EXPECT_EQ(lines_of("$ 110 "), (Lines{"$110=12000.000", "ok"}));
}

TEST_F(StatementsTest, ShowParametersInTheirUnits) {
  send_all({"G10 L2 P1 X1.5 Y-2", "G92 X3", "G43.1 Z-4", "G28.1"});
  Lines lines = lines_of("$#");
  ASSERT_EQ(lines.size(), 15U);
  EXPECT_EQ(lines[0], "[G54:1.500,-2.000,0.000]");
  EXPECT_EQ(lines[8], "[G59.3:0.000,0.000,0.000]");
  EXPECT_EQ(lines[9], "[G28:0.000,0.000,0.000]");
  EXPECT_EQ(lines[11], "[G92:-4.500,0.000,0.000]");
  EXPECT_EQ(lines[12], "[TLO:-4.000]");
  EXPECT_EQ(lines[13], "[PRB:0.000,0.000,0.000:0]");
  send("$13=1");
  EXPECT_EQ(lines_of("$#")[0], "[G54:0.0591,-0.0787,0.0000]");
}

TEST_F(StatementsTest, ShowModesThatAreAcceptedBackInOneLine) {
  const char* const modes[]{"G1 F1500 S100",
                            "G20 F10.5 G91",
                            "G2 X1 R5 F100",
                            "G3 X1 R5 F100",
                            "G18 G55 M3 S1000",
                            "G59.3 M4 G93",
                            "M7",
                            "M8",
                            "M9 T12 G80",
                            "G19 G94 G0 M5 S0",
                            "G20 G1 X0.1 F33.333",
                            "M2"};
  for (const char* line : modes) {
    ASSERT_EQ(send(line), "ok") << line;
    const std::string state = lines_of("$G")[0];
    ASSERT_TRUE(state.starts_with("[GC:") && state.ends_with("]")) << state;
    EXPECT_EQ(state.find('-'), std::string::npos) << state;
    EXPECT_NE(state[state.size() - 2], ' ') << state;
    ASSERT_EQ(send(state.substr(4, state.size() - 5)), "ok") << state << link.outgoing;
    EXPECT_EQ(lines_of("$G")[0], state);
  }
}

TEST_F(StatementsTest, TellWhatTheControllerIs) {
  const std::string kerfline = "[KERFLINE:" + std::string{identity::version()} + "]";
  EXPECT_EQ(lines_of("$I"),
            (Lines{"[VER:1.1h.20261121:]", "[OPT:VNMPH+2,128,1024]", kerfline, "ok"}));
  EXPECT_EQ(send("$I=left of the door"), "ok");
  const Lines lines = lines_of("$I+");
  ASSERT_EQ(lines.size(), 9U);
  EXPECT_EQ(lines[0], "[VER:1.1h.20261121:left of the door]");
  EXPECT_EQ(lines[2], kerfline);
  EXPECT_EQ(lines[3], "[AXS:3:XYZ]");
  EXPECT_EQ(lines[4], "[NEWOPT:ENUMS,RT+,HOME]");
  EXPECT_EQ(lines[5], "[FIRMWARE:Kerfline]");
  EXPECT_EQ(lines[6], "[STORE WEAR:0,0]");
  EXPECT_EQ(lines[7], "[LATE TURNS:0]");
  for (const char* text : {"$I=it is OK", "$I=no Error", "$I=a[b", "$I=a]b"}) {
    EXPECT_EQ(send(text), "error:3") << text;
  }
  EXPECT_EQ(send("$I=" + std::string(97, 'x')), "error:14");
}

TEST(Identity, VersionIsThatOfTheProjectAndTheCommit) {
  const std::regex shape{R"(\d+\.\d+\.\d+(\+[0-9a-f]{7}(-dirty)?)?)"};
  EXPECT_TRUE(std::regex_match(std::string{identity::version()}, shape)) << identity::version();
}

TEST_F(StatementsTest, KeepWhatTheyStoreForTheNextStart) {
  send_all({"$110=6000", "$N1=G91", "$I=mine", "G10 L2 P2 X7", "G0 X5", "G30.1"});
  run_until_idle();
  run(5);
  MemoryLink other_link;
  hal::host::RecordingPort other_port;
  Application<hal::host::RecordingPort> other{
      other_port, other_port, other_port, store, other_link};
  other_link.incoming = "$110\n$N\n$I\n$#\n";
  for (std::uint32_t k = 0; k < 50; ++k) other.poll(hal::TickCount{1000 * k});
  for (const char* line : {">G91\r\n",
                           "$110=6000.000\r\n",
                           "$N1=G91\r\n",
                           ":mine]\r\n",
                           "[G55:7.000,0.000,0.000]\r\n",
                           "[G30:5.000,0.000,0.000]\r\n"}) {
    EXPECT_NE(other_link.outgoing.find(line), std::string::npos) << line << other_link.outgoing;
  }
}

TEST_F(StatementsTest, RestoreTheDeliveredState) {
  const std::vector<std::string_view> changes{"$110=6000", "$N1=G91", "$I=mine", "G10 L2 P2 X7"};
  send_all(changes);
  EXPECT_EQ(send("$RST=x"), "error:3");
  EXPECT_EQ(lines_of("$RST=#")[0], "[MSG:Restoring defaults]");
  run(20);
  EXPECT_EQ(lines_of("$#")[1], "[G55:0.000,0.000,0.000]");
  EXPECT_EQ(lines_of("$110")[0], "$110=6000.000");
  EXPECT_EQ(send("$RST=$"), "ok");
  run(20);
  EXPECT_EQ(lines_of("$110")[0], "$110=12000.000");
  send_all(changes);
  EXPECT_EQ(send("$RST=*"), "ok");
  run(20);
  EXPECT_EQ(printed().back(), "Grbl 1.1h ['$' for help]");
  EXPECT_TRUE(store.records().empty());
}

TEST_F(StatementsTest, CheckModeMovesNothingAndEndsWithAReset) {
  EXPECT_EQ(lines_of("$C"), (Lines{"[MSG:Enabled]", "ok"}));
  EXPECT_EQ(send("G0 X5"), "ok");
  EXPECT_EQ(send("G0 X5 X6"), "error:25");
  link.outgoing.clear();
  send("$C");
  run(20);
  EXPECT_EQ(printed(), (Lines{"[MSG:Disabled]", "ok", "Grbl 1.1h ['$' for help]"}));
  EXPECT_EQ(port.position[0], 0);
  EXPECT_EQ(send("G0 X5"), "ok");
  EXPECT_EQ(send("$C"), "error:8");
}

TEST_F(StatementsTest, SleepUntilAReset) {
  EXPECT_EQ(lines_of("$SLP"), (Lines{"[MSG:Sleeping]", "ok"}));
  EXPECT_EQ(machine.state(), MachineState::kSleep);
  EXPECT_EQ(send("G0 X5"), "error:9");
  restart();
  EXPECT_EQ(machine.state(), MachineState::kIdle);
}

TEST_F(StatementsTest, NameTheRangeOfASetting) {
  EXPECT_EQ(
      lines_of("$43=200"),
      (Lines{"[MSG:5: value is above the range of this setting: 1 to 128 passes]", "error:2"}));
}

TEST_F(StatementsTest, SettingsThatDependOnEachOther) {
  const std::string waiting = "[MSG:Soft limits ($20) wait for homing ($22)]";
  EXPECT_EQ(lines_of("$20=1"), (Lines{waiting, "ok"})) << "a backup has this line before $22";
  EXPECT_EQ(lines_of("$22=1"), Lines{"ok"});
  EXPECT_EQ(lines_of("$20")[0], "$20=1");
  EXPECT_EQ(lines_of("$22=0"), (Lines{waiting, "ok"}));
  EXPECT_EQ(lines_of("$20")[0], "$20=1") << "soft limits are never switched off silently";
}

// Whatever the order of the settings in a backup, restoring it gives the same settings.
TEST_F(StatementsTest, SettingsOfABackupInAnyOrder) {
  std::vector<std::string> backup;
  for (const SettingInfo& info : setting_table()) {
    const float value = info.is_whole() ? info.most : 0.5F * (info.least + info.most);
    if (info.number == setting::kReportInches) continue;
    backup.push_back("$" + std::to_string(info.number) + "=" + std::to_string(value));
  }
  const auto restore_backup = [&] {
    EXPECT_EQ(send("$RST=$"), "ok");
    run(20);
    send("$X");
    for (const std::string& line : backup) EXPECT_EQ(send(line), "ok") << line;
    return lines_of("$$");
  };
  const Lines expected = restore_backup();
  std::mt19937_64 random{proof::test_seed()};
  for (int order = 0; order < 5; ++order) {
    std::shuffle(backup.begin(), backup.end(), random);
    EXPECT_EQ(restore_backup(), expected) << "KERFLINE_SEED=" << proof::test_seed();
  }
}

// The requests correspond to the homing that is configured: $22 without bit 1 homes all axes or
// none.
TEST_F(StatementsTest, SingleAxesAreHomedOnlyWhereTheirBitAllowsIt) {
  for (const char* line : {"$HX", "$HXY", "$hx", "$H X", "$HZYXABC"}) {
    EXPECT_EQ(send(line), "error:5") << line;
    send("$22=1");
    EXPECT_EQ(lines_of(line), (Lines{"[MSG:1: $22=3 allows homing of single axes]", "error:5"}));
    send("$22=0");
  }
  send_all({"$22=3", "$26=0"});
  stream("$HX\n");
  run(10);
  EXPECT_EQ(machine.state(), MachineState::kHome);
}

TEST_F(StatementsTest, TakeNamesInLowerCaseAndWithBlanks) {
  for (const char* line : {"$g", "$ $", " $i", "$es", "$x", "$ I +", "$rst=#"}) {
    EXPECT_EQ(send(line), "ok") << line;
    run(20);
  }
  for (const char* line : {"$Q", "$HQ", "$ESX", "$12345678901234567890", "$110=", "$J", "$RST"}) {
    EXPECT_EQ(send(line), "error:3") << line;
  }
}

TEST_F(StatementsTest, AnswerWhileMovingAndHeld) {
  send_all({"G1 X5 F300"});
  for (const char* line : {"$G", "$#", "$I", "$$", "$N", "$ES"})
    EXPECT_EQ(send(line), "ok") << line;
  EXPECT_FALSE(machine.idle());
  for (const char* line : {"$110=1", "$N0=G21", "$I=a", "$RST=$", "$H", "$SLP"}) {
    EXPECT_EQ(send(line), "error:8") << line;
  }
  stream("!");
  run(200);
  for (const char* line : {"", "$G", "(comment)"}) EXPECT_EQ(send(line), "ok") << line;
}

TEST_F(StatementsTest, TellWhatTheStoreCannotKeep) {
  class BrokenStore final : public hal::RecordStore {
   public:
    std::size_t load(std::uint16_t, std::span<std::byte>) override { return 0; }
    bool save(std::uint16_t, std::span<const std::byte>) override { return false; }
    hal::StoreWear wear() const override { return {}; }
  } broken;
  MemoryLink other_link;
  hal::host::RecordingPort other_port;
  Application<hal::host::RecordingPort> other{
      other_port, other_port, other_port, broken, other_link};
  other_link.incoming = "$110=6000\n$I=a\n$N0=G21\nG10 L2 P1 X1\n";
  for (std::uint32_t k = 0; k < 50; ++k) other.poll(hal::TickCount{1000 * k});
  std::size_t failures = 0;
  for (std::size_t at = 0; (at = other_link.outgoing.find("error:7", at)) != std::string::npos;
       ++at) {
    ++failures;
  }
  EXPECT_EQ(failures, 3U) << other_link.outgoing;
  EXPECT_NE(other_link.outgoing.find("[MSG:The store cannot keep the offsets]"), std::string::npos);
}

}  // namespace
}  // namespace cnc
