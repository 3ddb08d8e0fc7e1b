#include "tests/support/trials.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/seed_file.hpp"

namespace proof {
namespace {

using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Sets the variables of the seeds for one test and restores them.
class TrialsTest : public testing::Test {
 protected:
  TrialsTest() {
    for (Variable& variable : variables_) {
      if (const char* const value = std::getenv(variable.name)) variable.before = value;
      unsetenv(variable.name);
    }
  }
  ~TrialsTest() override {
    for (const Variable& variable : variables_) {
      unsetenv(variable.name);
      if (!variable.before.empty()) setenv(variable.name, variable.before.c_str(), 1);
    }
  }

  static std::vector<std::uint64_t> seeds_of(const Trials& trials) {
    std::vector<std::uint64_t> seeds;
    for (const std::uint64_t seed : trials) seeds.push_back(seed);
    return seeds;
  }

 private:
  struct Variable {
    const char* name;
    std::string before = {};
  };
  std::array<Variable, 5> variables_{{{"KERFLINE_SEED"},
                                      {"KERFLINE_SEED_BASE"},
                                      {"KERFLINE_TIER"},
                                      {"KERFLINE_TRIALS"},
                                      {"KERFLINE_MOST_TRIALS"}}};
};

TEST_F(TrialsTest, BeginAtOneWithoutABase) {
  EXPECT_THAT(seeds_of(Trials{3}), ElementsAre(1, 2, 3));
  EXPECT_EQ(test_seed(), 1U);
}

TEST_F(TrialsTest, BeginAtASeedOfBaseAndTest) {
  setenv("KERFLINE_SEED_BASE", "2789883", 1);
  const std::uint64_t first = first_seed_of("2789883", "TrialsTest.BeginAtASeedOfBaseAndTest");
  EXPECT_THAT(seeds_of(Trials{3}), ElementsAre(first, first + 1, first + 2));
  EXPECT_EQ(test_seed(), first);
}

TEST_F(TrialsTest, RunTheSeedsThatOnceFailedFirstAndInEveryTier) {
  EXPECT_THAT(seeds_of(Trials{2}), ElementsAre(4711, 815, 1, 2));
  setenv("KERFLINE_MOST_TRIALS", "1", 1);
  EXPECT_THAT(seeds_of(Trials{2}), ElementsAre(4711, 815, 1));
  setenv("KERFLINE_TIER", "seeds", 1);
  EXPECT_THAT(seeds_of(Trials{0}), ElementsAre(4711, 815));
  setenv("KERFLINE_SEED", "7", 1);
  EXPECT_THAT(seeds_of(Trials{1000}), ElementsAre(7));
}

TEST_F(TrialsTest, OfAKnownFaultTakeNewSeedsInTheLastStepOfProveOnly) {
  setenv("KERFLINE_SEED_BASE", "2789883", 1);
  const Trials::Range known = Trials::Range::kKnownFault;
  EXPECT_THAT(seeds_of(Trials(1, known)), ElementsAre(1));
  setenv("KERFLINE_TIER", "test", 1);
  EXPECT_THAT(seeds_of(Trials(1, known)), ElementsAre(1));
  setenv("KERFLINE_TIER", "seeds", 1);
  EXPECT_GT(seeds_of(Trials(1, known)).front(), 1U);
  EXPECT_THAT(seeds_of(Trials(1, Trials::Range::kFixed)), ElementsAre(1));
}

TEST_F(TrialsTest, JudgeSharesOfTheUsualNumberOnly) {
  EXPECT_TRUE(Trials{3}.judges_shares());
  setenv("KERFLINE_MOST_TRIALS", "2", 1);
  EXPECT_FALSE(Trials{3}.judges_shares());
  EXPECT_TRUE(Trials{2}.judges_shares());
}

TEST_F(TrialsTest, TakeAShareOfATableInTestOnlyAndAllOfItInTime) {
  const auto share_of = [](const char* base) {
    setenv("KERFLINE_SEED_BASE", base, 1);
    std::vector<std::size_t> share;
    for (std::size_t i = 0; i < 6; ++i) {
      if (is_in_share(i, 3)) share.push_back(i);
    }
    return share;
  };
  EXPECT_THAT(share_of("a"), SizeIs(6));
  setenv("KERFLINE_TIER", "test", 1);
  std::set<std::size_t> tried;
  for (const char* base : {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l"}) {
    const std::vector<std::size_t> share = share_of(base);
    ASSERT_THAT(share, SizeIs(2));
    EXPECT_EQ(share[1], share[0] + 3);
    tried.insert(share.begin(), share.end());
  }
  EXPECT_THAT(tried, SizeIs(6));
}

TEST_F(TrialsTest, GoOnFromASeedWithSoManyTrials) {
  setenv("KERFLINE_SEED", "5", 1);
  setenv("KERFLINE_TRIALS", "2", 1);
  EXPECT_THAT(seeds_of(Trials{1000}), ElementsAre(5, 6));
}

/// Runs this test once more by itself, with a fault planted at its second seed; returns the output.
std::string output_with_planted_fault() {
  const std::string command =
      "KERFLINE_PLANTED_FAULT=2 " + std::filesystem::read_symlink("/proc/self/exe").string() +
      " --gtest_filter=" + "TrialsTest.AFailurePrintsTheCommandThatRepeatsIt 2>&1";
  std::string output;
  FILE* const pipe = popen(command.c_str(), "r");
  for (int byte = 0; pipe != nullptr && (byte = std::fgetc(pipe)) != EOF;) {
    output.push_back(static_cast<char>(byte));
  }
  EXPECT_NE(pclose(pipe), 0) << "the planted fault passed";
  return output;
}

TEST_F(TrialsTest, AFailurePrintsTheCommandThatRepeatsIt) {
  if (const char* const planted = std::getenv("KERFLINE_PLANTED_FAULT")) {
    for (const std::uint64_t seed : Trials{3}) EXPECT_NE(seed, std::stoull(planted));
    return;
  }
  const std::string output = output_with_planted_fault();
  EXPECT_THAT(output, HasSubstr("seeds of base '': 3 from 1, 0 that once failed"));
  EXPECT_THAT(output,
              ContainsRegex("to repeat: KERFLINE_SEED=2 .*--gtest_filter='TrialsTest.AFail"));
}

TEST(FirstSeed, DiffersByBaseAndTestAndFits32Bits) {
  std::set<std::uint64_t> seeds;
  for (int base = 0; base < 100; ++base) {
    for (int test = 0; test < 100; ++test) {
      const auto seed = first_seed_of("b" + std::to_string(base), "T." + std::to_string(test));
      EXPECT_GE(seed, 1U);
      EXPECT_LE(seed, 4'000'000'000U);
      seeds.insert(seed);
    }
  }
  EXPECT_GT(seeds.size(), 9'990U);
  EXPECT_EQ(first_seed_of("2789883", "FirstSeed.IsAsInPython"), 2'943'632'798U);
}

TEST(SeedFile, HasSeedsByTestWithTheirReasons) {
  const SeedFile file =
      read_seeds("# Note.\n\n[A.B]\n3  # Edges late.\n4 # Stuck.\n[A/C.D/0]\n9 # x");
  EXPECT_THAT(file.faults, IsEmpty());
  ASSERT_THAT(file.seeds, SizeIs(2));
  EXPECT_THAT(file.seeds.at("A.B"), ElementsAre(3, 4));
  EXPECT_THAT(file.seeds.at("A/C.D/0"), ElementsAre(9));
}

TEST(SeedFile, ReportsEveryLineThatItCannotRead) {
  for (const char* const text : {"3 # Seed before any section.",
                                 "[A.B]\n3",
                                 "[A.B]\n3 #",
                                 "[A.B]\nthree # No number.",
                                 "[A.B]\n-3 # No number.",
                                 "[A.B]\n3 4 # Two numbers.",
                                 "[A.B]\n3 # Once.\n3 # Twice.",
                                 "[A.B]\n3 # Once.\n[A.B]\n4 # Second section.",
                                 "[A.B]",
                                 "[A.B]\n[C.D]\n3 # First section is empty.",
                                 "[A.B\n3 # No section.",
                                 "[AB]\n3 # No section.",
                                 "[A.B]\n99999999999999999999 # Too large."}) {
    EXPECT_FALSE(read_seeds(text).faults.empty()) << text;
  }
  EXPECT_THAT(read_seeds("[A.B]\n3 # x\n\nfour # y").faults, ElementsAre(HasSubstr("line 4")));
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream{path};
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_TRUE(stream.good()) << path;
  return text.str();
}

/// Returns the body of the test that a section names, or an empty text. The name of a parameter is
/// removed first.
std::string body_of(const std::string& section, const std::string& source, bool python) {
  const std::regex name{R"((?:\w+/)?(\w+)\.(\w+)(?:/.+)?)"};
  std::smatch parts;
  if (!std::regex_match(section, parts, name)) return {};
  const std::string head =
      python ? "\n    def " + parts[2].str() + "\\("
             : "\nTEST(?:_F|_P)?\\(" + parts[1].str() + ",\\s*" + parts[2].str() + "\\)";
  std::smatch found;
  if (!std::regex_search(source, found, std::regex{head})) return {};
  const std::string rest = found.suffix();
  return rest.substr(0, rest.find(python ? "\n    def " : "\n}"));
}

// A seed file that no test reads would go unnoticed.
TEST(SeedFiles, AllStandBesideATestThatTriesThem) {
  std::size_t sections = 0;
  const std::filesystem::path root = std::filesystem::path{KERFLINE_CONTOURS} / "../..";
  for (const auto& entry : std::filesystem::recursive_directory_iterator{root}) {
    if (entry.path().extension() != ".seeds") continue;
    std::filesystem::path source = entry.path();
    const bool python = std::filesystem::exists(source.replace_extension(".py"));
    if (!python) source.replace_extension(".cpp");
    const SeedFile file = read_seeds(text_of(entry.path()));
    EXPECT_THAT(file.faults, IsEmpty()) << entry.path();
    for (const auto& [section, seeds] : file.seeds) {
      const std::string body = body_of(section, text_of(source), python);
      EXPECT_THAT(body, HasSubstr(python ? "seeds_of(self" : "Trials")) << section;
      ++sections;
    }
  }
  EXPECT_GE(sections, 5U);
}

}  // namespace
}  // namespace proof
