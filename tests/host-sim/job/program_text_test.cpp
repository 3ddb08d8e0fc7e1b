#include "host-sim/job/program_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "firmware/link/line_check.hpp"
#include "host-sim/send/job_lines.hpp"

namespace sim {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string with_sum(const std::string& line) {
  unsigned sum = 0;
  for (const char c : line) sum ^= static_cast<unsigned char>(c);
  return line + "*" + std::to_string(sum);
}

std::string with_crc(const std::string& line) {
  std::string digits(8, '0');
  cnc::put_line_crc(line, digits.data());
  return line + "*" + digits;
}

std::vector<std::string> said(const std::vector<LineNote>& notes) {
  std::vector<std::string> texts;
  for (const LineNote& note : notes) texts.push_back(place_and_text("f", note));
  return texts;
}

std::vector<std::string> sent(const std::string& file) {
  std::vector<std::string> lines;
  const JobLines job = read_job(prepare_program(file).text);
  for (std::size_t index = 0; index < job.size(); ++index) lines.push_back(job[index].text);
  return lines;
}

TEST(ProgramText, IsTheFileWhereThereIsNothingToLeaveOut) {
  for (const std::string file : {"",
                                 "G21\nG1 X1 F100 (a*3, ünï! ?~)\n",
                                 "\r\n\r\nG0 X1 ; go! *12\r",
                                 "$J=G91 X1 F100\n$I=a*12\n",
                                 "N10 G1 X[2*5]\n",
                                 "G0 X1 *\n"}) {
    const ProgramText program = prepare_program(file);
    EXPECT_EQ(program.text, file);
    EXPECT_THAT(program.notes, IsEmpty()) << file;
    EXPECT_THAT(program.faults, IsEmpty()) << file;
  }
}

TEST(ProgramText, LeavesOutGoodChecksOfAnyForm) {
  const ProgramText program =
      prepare_program("N1 G21*27\nN2 G1 X5 F500*52 ; go\nN3 G1 X0*99 \t\n" +
                      with_crc("N4 G0 (a) X1") + "\n" + with_sum("G0 X2") + "\n");
  EXPECT_EQ(program.text,
            "N1 G21   \nN2 G1 X5 F500    ; go\nN3 G1 X0    \t\nN4 G0 (a) X1         \nG0 X2   \n");
  EXPECT_THAT(
      said(program.notes),
      ElementsAre("f:1:7: the checks of lines are correct, and are left out; 5 times in all"));
  EXPECT_THAT(program.faults, IsEmpty());
}

TEST(ProgramText, LeavesOutTheNumberOfAStatementWithItsCheck) {
  EXPECT_EQ(prepare_program(with_sum("N5 $G") + "\nN6 $G\n").text, "   $G   \nN6 $G\n");
}

TEST(ProgramText, NamesWrongChecksByLineAndKeepsThem) {
  const std::string file = "N1 G21*20\nN2 G1 X5 F500*52\nN3 G0*12345678\nG0 X1*0 ; no\n";
  const ProgramText program = prepare_program(file);
  EXPECT_THAT(said(program.faults),
              ElementsAre("f:1:7: the check does not match its line",
                          "f:3:6: the check does not match its line",
                          "f:4:6: the check does not match its line"));
  EXPECT_TRUE(program.text.starts_with("N1 G21*20\n")) << "for the controller to refuse";
  std::string full;
  for (int i = 0; i < 5000; ++i) full += "N1 G21*20\n";
  EXPECT_EQ(prepare_program(full).faults.size(), 1000U);
}

TEST(ProgramText, LeavesOutWhatCountsLinesAnew) {
  for (const std::string line :
       {"N0 M110*35", "N0 M110 N0*125", "M110*125", "m110 N5", "N-1 M110*15"}) {
    const ProgramText program = prepare_program(line + "\nG0 X1\n");
    EXPECT_EQ(program.text.substr(line.size()), "\nG0 X1\n") << line;
    EXPECT_EQ(program.text.find_first_not_of(' '), line.size()) << line;
    EXPECT_EQ(program.notes.size(), line.find('*') == std::string::npos ? 1U : 2U) << line;
    EXPECT_THAT(program.faults, IsEmpty()) << line;
  }
}

TEST(ProgramText, LeavesOutMarksControlBytesAndWhatActsAtOnce) {
  EXPECT_EQ(prepare_program("\xef\xbb\xbfG21\n").text, "G21\n");
  const ProgramText program = prepare_program(std::string(
      "G1\xc2\xa0 X5\nG1\xa0X6!\n\0G0 X1\x1a (\xc2\xa0!\x01)\nG0 X1\xc3\xa4\n\x18G0\n", 42));
  EXPECT_EQ(program.text,
            std::string("G1   X5\nG1 X6 \n G0 X1  (\xc2\xa0!\x01)\nG0 X1\xc3\xa4\n G0\n"));
  EXPECT_THAT(
      said(program.notes),
      ElementsAre("f:1:3: a no-break space (U+00A0) is read as a blank; 2 times in all",
                  "f:2:6: '!' is a command that acts immediately: it is left out of the program; "
                  "2 times in all",
                  "f:3:1: control byte 0x00 is left out; 2 times in all"));
}

TEST(ProgramText, EndsWhereTheProgramDoes) {
  const ProgramText program =
      prepare_program("G0 X1\nN5 m02 (end)\n%\n; no more\n\nM3 S1\nG1 X2\n");
  EXPECT_EQ(program.text.find_first_not_of(" \n", program.text.find("(end)") + 5),
            std::string::npos);
  EXPECT_EQ(std::ranges::count(program.text, '\n'), 7);
  EXPECT_THAT(said(program.notes),
              ElementsAre("f:6: the program ended in line 2: nothing from here on is driven; "
                          "2 times in all"));
  for (const char* end : {"M30", "M 2", "G0 X1 M30", "N1M2", "M02 ; end", "M30\r"}) {
    EXPECT_EQ(prepare_program(std::string(end) + "\n%\n").notes.size(), 0U) << end;
    EXPECT_EQ(prepare_program(std::string(end) + "\nG0 X2\n").notes.size(), 1U) << end;
  }
  for (const char* other : {"M3 S2", "M20", "(M2)", "; M30", "M2.5", "M2 X", "$N0=M2", "% M2"}) {
    const std::string file = std::string(other) + "\nG0 X2\n";
    EXPECT_EQ(prepare_program(file).text, file) << other;
  }
}

TEST(ProgramText, AnEndBehindASlashCountsWhereSuchLinesAreDriven) {
  const std::string file = "N10 /M30\nG0 X2\n";
  EXPECT_EQ(prepare_program(file).text, file);
  EXPECT_EQ(prepare_program(file, false).notes.size(), 2U);
  EXPECT_THAT(said(prepare_program(file).notes),
              ElementsAre("f:1:5: lines that begin with / are skipped ($890, $B)"));
  EXPECT_THAT(prepare_program("G1 X1 (a/b)\n").notes, IsEmpty());
}

TEST(ProgramText, RefusesWhatIsNotInBytes) {
  const ProgramText program =
      prepare_program(std::string("\xff\xfeG\0"
                                  "2\0",
                                  6));
  EXPECT_FALSE(program.readable);
  EXPECT_EQ(program.text, "");
  EXPECT_THAT(said(program.faults), ElementsAre("f:1: the file is UTF-16: save it as UTF-8"));
}

TEST(ProgramText, IsSentWithoutNames) {
  EXPECT_THAT(sent("%1001\nO0001 (BOX)\n:12\n% end\nN1 G21*27\n( text='" + std::string(300, '1') +
                   "' )\nN10 /G0 X7\nM30\n%\nG0 X1\n"),
              ElementsAre("N1G21", "N10/G0X7", "M30"));
  EXPECT_THAT(sent("%G0 X1\nO100 sub\n"), ElementsAre("%G0X1", "O100sub"))
      << "for it to be refused";
}

}  // namespace
}  // namespace sim
