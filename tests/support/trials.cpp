#include "tests/support/trials.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "tests/support/seed_file.hpp"

namespace proof {
namespace {

using Wide = unsigned long long;

std::optional<std::string> variable(const char* name) {
  const char* const value = std::getenv(name);
  if (value == nullptr || *value == '\0') return std::nullopt;
  return std::string{value};
}

const testing::TestInfo& running_test() {
  return *testing::UnitTest::GetInstance()->current_test_info();
}

std::string name_of(const testing::TestInfo& test) {
  return std::string{test.test_suite_name()} + '.' + test.name();
}

/// Prints, once for each seed that failed, the command that repeats it.
class Repeater : public testing::EmptyTestEventListener {
 public:
  void take(std::uint64_t seed) { seed_ = seed; }
  /// Stores the name of the running test. A report cannot query it, because it holds GoogleTest's
  /// lock.
  void begin() { test_ = name_of(running_test()); }

  void OnTestStart(const testing::TestInfo& /*test*/) override {
    seed_.reset();
    printed_.reset();
  }

  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (!result.failed() || !seed_ || printed_ == seed_) return;
    printed_ = seed_;
    std::printf("to repeat: KERFLINE_SEED=%llu %s --gtest_filter='%s'\n",
                static_cast<Wide>(*seed_),
                program_invocation_name,
                test_.c_str());
  }

 private:
  std::string test_;
  std::optional<std::uint64_t> seed_;
  std::optional<std::uint64_t> printed_;
};

/// GoogleTest owns the listener, which lives as long as the program.
Repeater& repeater() {
  static Repeater* const listener = [] {
    auto* const made = new Repeater;
    testing::UnitTest::GetInstance()->listeners().Append(made);
    return made;
  }();
  return *listener;
}

std::uint64_t first_seed_of_running_test(Trials::Range range) {
  if (const auto seed = variable("KERFLINE_SEED")) return std::stoull(*seed);
  const bool new_seeds = variable("KERFLINE_TIER") == "seeds";
  const bool fixed =
      range == Trials::Range::kFixed || (range == Trials::Range::kKnownFault && !new_seeds);
  const std::string base = fixed ? "" : variable("KERFLINE_SEED_BASE").value_or("");
  return first_seed_of(base, name_of(running_test()));
}

/// Prints where the seeds of the running test come from.
void print_seeds(std::uint64_t first, std::uint64_t count, std::size_t once_failed) {
  std::printf("seeds of base '%s': %llu from %llu, %zu that once failed\n",
              variable("KERFLINE_SEED_BASE").value_or("").c_str(),
              static_cast<Wide>(count),
              static_cast<Wide>(first),
              once_failed);
}

/// A section that names no test of the file would never run.
void expect_tests(const SeedFile& file, const std::string& source, const std::string& path) {
  std::vector<std::string> names;
  const testing::UnitTest& unit = *testing::UnitTest::GetInstance();
  for (int i = 0; i < unit.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *unit.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count(); ++k) {
      const testing::TestInfo& test = *suite.GetTestInfo(k);
      if (source == test.file()) names.push_back(name_of(test));
    }
  }
  for (const auto& [section, seeds] : file.seeds) {
    if (std::count(names.begin(), names.end(), section) == 0) {
      ADD_FAILURE() << path << ": no test of " << source << " is called " << section;
    }
  }
}

/// Returns the seeds of the running test that once failed.
std::vector<std::uint64_t> seeds_that_once_failed() {
  const std::string source = running_test().file();
  std::filesystem::path path = std::filesystem::path{KERFLINE_SOURCES} / source;
  EXPECT_TRUE(std::filesystem::exists(path)) << path << ": the tests' sources are not there";
  path.replace_extension(".seeds");
  if (!std::filesystem::exists(path)) return {};
  std::ifstream stream{path};
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_TRUE(stream.good() && text.good()) << path << ": cannot be read";
  SeedFile file = read_seeds(text.str());
  for (const std::string& fault : file.faults) ADD_FAILURE() << path << ": " << fault;
  expect_tests(file, source, path);
  const auto found = file.seeds.find(name_of(running_test()));
  return found == file.seeds.end() ? std::vector<std::uint64_t>{} : found->second;
}

}  // namespace

std::uint64_t trials_wanted(std::uint64_t usual) {
  if (const auto count = variable("KERFLINE_TRIALS")) return std::stoull(*count);
  const auto most = variable("KERFLINE_MOST_TRIALS");
  return most ? std::min<std::uint64_t>(usual, std::stoull(*most)) : usual;
}

std::uint64_t first_seed_of(std::string_view base, std::string_view test) {
  if (base.empty()) return 1;
  constexpr std::uint64_t kSeedCount = 4'000'000'000;
  std::uint64_t hash = 0xCBF2'9CE4'8422'2325U;
  for (const std::string_view text : {base, std::string_view{" "}, test}) {
    for (const char character : text) {
      hash = (hash ^ static_cast<unsigned char>(character)) * 0x100'0000'01B3U;
    }
  }
  hash = (hash ^ (hash >> 30)) * 0xBF58'476D'1CE4'E5B9U;
  hash = (hash ^ (hash >> 27)) * 0x94D0'49BB'1331'11EBU;
  return 1 + (hash ^ (hash >> 31)) % kSeedCount;
}

Trials::Trials(std::uint64_t usual, Range range)
    : usual_{usual}, first_{first_seed_of_running_test(range)} {
  const bool chosen = variable("KERFLINE_SEED").has_value();
  random_count_ = trials_wanted(chosen ? 1 : usual);
  repeater().begin();
  if (!chosen) once_failed_ = seeds_that_once_failed();
  if (range == Range::kKnownFault) std::printf("a known fault violates some new seeds\n");
  print_seeds(first_, random_count_, once_failed_.size());
}

std::uint64_t Trials::Iterator::operator*() const {
  const std::size_t known = trials_->once_failed_.size();
  const std::uint64_t seed =
      index_ < known ? trials_->once_failed_[index_] : trials_->first_ + index_ - known;
  repeater().take(seed);
  return seed;
}

bool Trials::Iterator::operator==(std::default_sentinel_t /*end*/) const {
  return index_ == trials_->count() || too_many_failures();
}

std::uint64_t test_seed() {
  const std::uint64_t seed = first_seed_of_running_test(Trials::Range::kFromBase);
  print_seeds(seed, 1, 0);
  repeater().begin();
  repeater().take(seed);
  return seed;
}

bool is_in_share(std::size_t index, std::size_t stride) {
  if (variable("KERFLINE_TIER") != "test") return true;
  return (index + test_seed()) % stride == 0;
}

bool too_many_failures() {
  static const int kEnough = std::stoi(variable("KERFLINE_FAILURES").value_or("20"));
  return running_test().result()->total_part_count() >= kEnough;
}

}  // namespace proof
