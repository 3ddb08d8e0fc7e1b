#include <filesystem>
#include <fstream>
#include <set>

#include "firmware/machine/settings.hpp"
#include "firmware/protocol/code_texts.hpp"
#include "firmware/protocol/identity.hpp"
#include "tests/firmware/controller_test.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

/// Each line must have one answer, and a sender must not be able to take any other text for an
/// answer.
class AcknowledgementsTest : public ControllerTest {
 protected:
  /// bCNC, LaserGRBL, Candle and Grbl's own stream.py search for these words. `[ERRORCODE:` is
  /// excepted: only senders that request `$EE` receive it, and they require this form.
  static bool could_be_counted(std::string line) {
    if (line.rfind("[ERRORCODE:", 0) == 0) line.erase(0, 11);
    if (line == "ERRORCODE") return false;
    for (char& c : line) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return line.find("ok") != std::string::npos || line.find("error") != std::string::npos;
  }
  static bool is_answer(const std::string& line) {
    return line == "ok" || line.rfind("error:", 0) == 0;
  }
  void expect_only_answers_count() const {
    for (const std::string& line : printed()) {
      EXPECT_EQ(could_be_counted(line), is_answer(line)) << line;
    }
  }
};

TEST_F(AcknowledgementsTest, NoTextOfTheTablesCouldBeCounted) {
  for (const SettingInfo& info : setting_table()) {
    for (const char* text : {info.name, info.unit, info.format, info.help.text()}) {
      EXPECT_FALSE(could_be_counted(text)) << text;
      EXPECT_EQ(std::string_view{text}.find_first_of("|[]"), std::string_view::npos) << text;
    }
  }
  for (const auto texts : {error_texts(), alarm_texts()}) {
    for (const CodeText& code : texts) {
      EXPECT_FALSE(could_be_counted(code.text)) << code.text;
      EXPECT_EQ(std::string_view{code.text}.find_first_of("|[]"), std::string_view::npos);
    }
  }
  for (const SettingGroupInfo& group : setting_groups()) EXPECT_FALSE(could_be_counted(group.name));
  for (const SettingError error : {SettingError::kUnknown,
                                   SettingError::kBelowRange,
                                   SettingError::kAboveRange,
                                   SettingError::kNotWhole,
                                   SettingError::kPlaceLost}) {
    EXPECT_FALSE(could_be_counted(std::string{describe(error)}));
  }
}

TEST_F(AcknowledgementsTest, NoLineOfAnyListingCouldBeCountedOrIsCutOff) {
  for (const char* line : {"$",
                           "$$",
                           "$#",
                           "$G",
                           "$I",
                           "$I+",
                           "$N",
                           "$ES",
                           "$EG",
                           "$ESH",
                           "$EA",
                           "$EE",
                           "$110",
                           "?",
                           "\x87",
                           "\x83"}) {
    link.outgoing.clear();
    EXPECT_EQ(send(line), "ok");
    expect_only_answers_count();
    for (const std::string& printed_line : printed()) {
      EXPECT_LT(printed_line.size(), Reply::kCapacity - 2) << printed_line;
      EXPECT_TRUE(std::string_view{"[$<o"}.find(printed_line.front()) != std::string::npos);
      if (printed_line.front() == '[') {
        EXPECT_EQ(printed_line.find(']'), printed_line.size() - 1);
      }
    }
  }
}

// Checks every text between quotes in the sources that print.
TEST_F(AcknowledgementsTest, NoTextOfTheSourcesCouldBeCounted) {
  std::size_t texts = 0;
  for (const char* const folder : {"firmware", "planner/gcode"}) {
    const std::filesystem::path root{std::string{KERFLINE_SOURCES} + "/" + folder};
    for (const auto& entry : std::filesystem::recursive_directory_iterator{root}) {
      std::ifstream file{entry.path()};
      for (std::string line; std::getline(file, line);) {
        if (line.find("#include") != std::string::npos) continue;
        for (std::size_t at = line.find('"'); at != std::string::npos;
             at = line.find('"', at + 1)) {
          const std::size_t end = line.find('"', at + 1);
          if (end == std::string::npos) break;
          const std::string text = line.substr(at + 1, end - at - 1);
          at = end;
          ++texts;
          if (text == "ok" || text == "error:" || text == "error") continue;
          // These are complete answers of an image that refuses to run.
          if (text == R"(ok\r\n)" || text == R"(error:9\r\n)") continue;
          EXPECT_FALSE(could_be_counted(text)) << entry.path() << ": " << text;
        }
      }
    }
  }
  EXPECT_GT(texts, 400U);
}

// CR, LF and CR LF may end a line, and the link may divide the bytes into any chunks.
TEST_F(AcknowledgementsTest, EveryLineHasOneWhateverEndsItAndHoweverItArrives) {
  const char* const kinds[]{
      "", " ", "(comment)", "; ok?", "G21", "$G", "G1 X", "%", "$110", "$7=1"};
  const char* const ends[]{"\r", "\n", "\r\n"};
  for (const std::uint64_t seed : proof::Trials{3000}) {
    proof::Random random{seed};
    const std::string end = ends[random.below(3)];
    std::string text;
    for (int k = 0; k < 40; ++k) text += kinds[random.below(std::size(kinds))] + end;
    link.outgoing.clear();
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t size = 1 + random.below(24);
      link.incoming.append(text, at, size);
      at += size;
      application.poll(hal::TickCount{0});
    }
    for (int k = 0; k < 20; ++k) application.poll(hal::TickCount{0});
    ASSERT_EQ(answers().size(), 40U) << "KERFLINE_SEED=" << seed;
    // If a line ended with CR, an LF that ends the next line must not be dropped.
    link.incoming = "\r\n";
    application.poll(hal::TickCount{0});
  }
}

/// Senders may request the status at any time, even between CR and LF.
TEST_F(AcknowledgementsTest, ALineHasOneWhateverActsBetweenItsCrAndLf) {
  for (const std::string byte : {"?", "~", "\x83", "\x87", "\x91", "\xA3", "\xC2\x91", "?\x91~"}) {
    link.outgoing.clear();
    stream("G21\r" + byte + "\nG90\r\n");
    run(20);
    EXPECT_EQ(answers(), (std::vector<std::string>{"ok", "ok"})) << testing::PrintToString(byte);
  }
}

TEST_F(AcknowledgementsTest, TheProbeResultComesBeforeItsAnswer) {
  plate = [](const auto& position) { return position[2] <= -250; };
  send("G38.2 Z-5 F100");
  EXPECT_EQ(printed(), (std::vector<std::string>{"[PRB:0.000,0.000,-1.000:1]", "ok"}));
  link.outgoing.clear();
  plate = nullptr;
  port.probe = false;
  send("G38.3 Z-2 F100");
  EXPECT_EQ(printed(), (std::vector<std::string>{"[PRB:0.000,0.000,-2.000:0]", "ok"}));
}

TEST_F(AcknowledgementsTest, TheEndOfAProgramIsToldBeforeItsAnswer) {
  for (const char* line : {"M2", "M30", "M30"}) {
    link.outgoing.clear();
    send(line);
    EXPECT_EQ(printed(), (std::vector<std::string>{"[MSG:Pgm End]", "ok"}));
  }
}

TEST_F(AcknowledgementsTest, AFailedProbeIsAnsweredAfterItsAlarm) {
  send("G38.2 Z-1 F100");
  EXPECT_EQ(printed(), (std::vector<std::string>{"ALARM:5", "[PRB:0.000,0.000,-1.000:0]", "ok"}));
  send("$X");
  port.probe = true;
  run(20);
  link.outgoing.clear();
  send("G38.2 Z-2 F100");
  EXPECT_EQ(printed().front(), "ALARM:4");
}

/// Sends lines that are wrong, one for each error number.
TEST_F(AcknowledgementsTest, EveryNumberOfTheTableIsGiven) {
  std::set<int> given;
  const auto note = [&] {
    for (const std::string& line : answers()) {
      if (line.rfind("error:", 0) == 0) given.insert(std::stoi(line.substr(6)));
    }
    expect_only_answers_count();
    link.outgoing.clear();
  };
  const std::string long_line(300, 'X');
  for (const std::string_view line : {std::string_view{long_line},
                                      std::string_view{"=X"},
                                      std::string_view{"G1 X"},
                                      std::string_view{"$Q"},
                                      std::string_view{"$110=-1"},
                                      std::string_view{"$H"},
                                      std::string_view{"$0=0"},
                                      std::string_view{"$J=G91 M3"},
                                      std::string_view{"G6"},
                                      std::string_view{"G20 G21"},
                                      std::string_view{"G1 X1"},
                                      std::string_view{"G1.5"},
                                      std::string_view{"T1.5"},
                                      std::string_view{"G0 G1 X1"},
                                      std::string_view{"X1 X2"},
                                      std::string_view{"G92"},
                                      std::string_view{"N99999999"},
                                      std::string_view{"G4"},
                                      std::string_view{"G59.7"},
                                      std::string_view{"F100 G53 G2 X1 R5"},
                                      std::string_view{"G80 X1"},
                                      std::string_view{"F100 G2 Z1 K1"},
                                      std::string_view{"F100 G2 X1 Y1 I99"},
                                      std::string_view{"F100 G2 X1 R0"},
                                      std::string_view{"F100 G2 X1"},
                                      std::string_view{"G21 P1"},
                                      std::string_view{"G43.1 X1"},
                                      std::string_view{"T999"}}) {
    send(line);
    note();
  }
  send("$I=" + std::string(120, 'x'));
  send_all({"$22=1", "$20=1", "$25=3000", "$26=5"});
  plate = [&](const auto& position) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned bit = position[axis] > 500 ? 1U << axis : 0U;
      port.limits.first = static_cast<std::uint8_t>((port.limits.first & ~(1U << axis)) | bit);
    }
    return false;
  };
  EXPECT_EQ(send("$H"), "ok") << link.outgoing;
  send("$J=G91 X9999 F100");  // 15: the travel of the machine is known from here on.
  note();
  send("G1 X-50 F300");
  run(20);
  send("$22=0");  // 8: the machine moves.
  stream("\x18");
  run(50);
  port.panel.door = true;
  run(50);
  send("G0 X1");  // 9: after the reset the position is unknown.
  send("$X");     // 13: the door is open.
  note();
  port.panel.door = false;
  port.panel.emergency_stop = true;
  run(50);
  send("$X");  // 79: an emergency stop is pressed.
  note();
  given.insert(200);  // ToolChangeTest.AProbeThatMissesLosesNoJob causes error 200.
  given.insert(7);    // StatementsTest.TellWhatTheStoreCannotKeep causes error 7.
  for (const CodeText& code : error_texts()) {
    EXPECT_TRUE(given.contains(code.number)) << int{code.number} << ": " << code.text;
    given.erase(code.number);
  }
  EXPECT_TRUE(given.empty()) << "a number is missing in the table: " << *given.begin();
}

}  // namespace
}  // namespace cnc
