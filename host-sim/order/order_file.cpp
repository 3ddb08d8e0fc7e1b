#include "host-sim/order/order_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host-sim/order/file_words.hpp"
#include "host-sim/order/symmetry.hpp"
#include "planner/order/problem.hpp"

namespace sim::order {
namespace {

using cnc::order::Index;

constexpr std::int64_t kMaxNodes = 10'000'000;
// Greatest number of vertices of a matrix; such a matrix takes 7 GB.
constexpr std::int64_t kMaxOfMatrix = 30'000;
constexpr double kGreatestCost =
    1.0e9;  // Greatest cost of an allowed leg: a thousandth of kForbidden.
constexpr double kFarthest = 1.0e9;

/// A group as the file lists it, with the numbers of its vertices, which count from 1.
struct Group {
  std::uint32_t number = 0;
  std::vector<std::uint32_t> vertices;
};

class OrderReader {
 public:
  OrderReader(std::string_view text, std::string_view file) : words_{text, file} {}

  OrderProblem read() {
    for (;;) {
      const std::string_view key = words_.next();
      if (key.empty() || key == "EOF") break;
      read_entry(key);
    }
    finish();
    return std::move(problem_);
  }

 private:
  void read_entry(std::string_view key);
  bool read_section(std::string_view key);
  void read_type(std::string_view type);
  void read_weight_type(std::string_view type);
  void read_matrix();
  void read_places();
  void read_groups();
  void read_ordering();
  void read_start();
  void finish();
  void number_groups();
  void sort_vertices();
  void check_matrix();

  FileWords words_;
  OrderProblem problem_;
  std::int64_t dimension_ = 0;
  std::int64_t group_count_ = 0;
  bool has_groups_ = false;  ///< Whether TYPE is PCGLNS or GTSP, so that the file must list groups.
  bool has_type_ = false;
  bool has_metric_ = false;
  std::uint32_t start_ = 1;
  std::vector<cnc::order::Place> places_;
  std::vector<double> matrix_;
  std::vector<Group> groups_;
  /// Pairs of group numbers; the first group of a pair must come before the second one.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
};

void OrderReader::read_entry(std::string_view key) {
  if (read_section(key)) return;
  if (words_.next() != ":")
    words_.fail(fmt::format("a colon is missing after `{}`; write one", key));
  if (key == "DIMENSION") {
    dimension_ = words_.whole_number("DIMENSION", 1, kMaxNodes);
  } else if (key == "GTSP_SETS") {
    group_count_ = words_.whole_number("GTSP_SETS", 1, kMaxNodes);
  } else if (key == "NAME") {
    problem_.name = words_.rest_of_line();
  } else if (key == "TYPE") {
    read_type(words_.rest_of_line());
  } else if (key == "EDGE_WEIGHT_TYPE") {
    read_weight_type(words_.rest_of_line());
  } else if (key == "EDGE_WEIGHT_FORMAT") {
    const std::string_view format = words_.rest_of_line();
    if (format != "FULL_MATRIX" && format != "FUNCTION") {
      words_.fail(
          fmt::format("EDGE_WEIGHT_FORMAT `{}` is not supported; write FULL_MATRIX", format));
    }
  } else if (key == "COMMENT" || key.starts_with("DISPLAY_") || key == "NODE_COORD_TYPE") {
    static_cast<void>(words_.rest_of_line());
  } else {
    words_.fail(fmt::format("the entry `{}` is not supported; leave it out", key));
  }
}

bool OrderReader::read_section(std::string_view key) {
  const std::size_t line = words_.line();
  if (!key.ends_with("_SECTION") && key != "GTSP_SET_ORDERING") return false;
  if (words_.peek() == ":") static_cast<void>(words_.next());
  if (dimension_ == 0) words_.fail_at(line, fmt::format("DIMENSION must come before {}", key));
  if (key == "EDGE_WEIGHT_SECTION") {
    read_matrix();
  } else if (key == "NODE_COORD_SECTION") {
    read_places();
  } else if (key == "GTSP_SET_SECTION") {
    read_groups();
  } else if (key == "GTSP_SET_ORDERING") {
    read_ordering();
  } else if (key == "START_GROUP_SECTION") {
    read_start();
  } else {
    words_.fail_at(line, fmt::format("the section `{}` is not supported; leave it out", key));
  }
  return true;
}

void OrderReader::read_type(std::string_view type) {
  has_type_ = true;
  has_groups_ = type == "PCGLNS" || type == "GTSP";
  if (!has_groups_ && type != "TSP" && type != "ATSP") {
    words_.fail(
        fmt::format("TYPE `{}` is not supported; it must be TSP, ATSP, GTSP or PCGLNS", type));
  }
}

void OrderReader::read_weight_type(std::string_view type) {
  has_metric_ = true;
  if (type == "EUC_2D") {
    problem_.metric = Metric::kRoundedPlane;
  } else if (type == "CEIL_2D") {
    problem_.metric = Metric::kCeiledPlane;
  } else if (type == "EXPLICIT") {
    problem_.metric = Metric::kMatrix;
  } else {
    words_.fail(fmt::format(
        "EDGE_WEIGHT_TYPE `{}` is not supported; it must be EUC_2D, CEIL_2D or EXPLICIT", type));
  }
}

void OrderReader::read_matrix() {
  if (dimension_ > kMaxOfMatrix) {
    words_.fail(fmt::format(
        "a matrix of {} vertices is too large; at most {} are possible", dimension_, kMaxOfMatrix));
  }
  const auto size = static_cast<std::size_t>(dimension_);
  matrix_.resize(size * size);
  for (std::size_t i = 0; i < matrix_.size(); ++i) {
    double cost = words_.number("a cost");
    if (cost == -1.0) cost = cnc::order::kForbidden;
    if (cost < 0.0 || (cost > kGreatestCost && cost != cnc::order::kForbidden)) {
      words_.fail(
          fmt::format("{:g} is not a cost of the leg from {} to {}; costs are 0 to {:g}, and -1 "
                      "for a forbidden leg",
                      cost,
                      i / size + 1,
                      i % size + 1,
                      kGreatestCost));
    }
    matrix_[i] = cost;
  }
}

void OrderReader::read_places() {
  const auto size = static_cast<std::size_t>(dimension_);
  places_.resize(size);
  std::vector<bool> is_read(size);
  for (std::size_t i = 0; i < size; ++i) {
    const auto number = static_cast<std::size_t>(words_.whole_number("a node", 1, dimension_)) - 1;
    if (is_read[number])
      words_.fail(fmt::format("node {} is listed twice; leave one out", number + 1));
    is_read[number] = true;
    places_[number].x = words_.number("x");
    places_[number].y = words_.number("y");
    if (std::max(std::abs(places_[number].x), std::abs(places_[number].y)) > kFarthest) {
      words_.fail(fmt::format(
          "node {} is farther than {:g} from zero; move it nearer", number + 1, kFarthest));
    }
  }
}

void OrderReader::read_groups() {
  if (group_count_ == 0) words_.fail("GTSP_SETS must come before GTSP_SET_SECTION");
  for (std::int64_t i = 0; i < group_count_; ++i) {
    Group group;
    group.number = static_cast<std::uint32_t>(words_.whole_number("a group", 1, group_count_));
    for (;;) {
      const std::int64_t vertex = words_.whole_number("a vertex or -1", -1, dimension_);
      if (vertex == -1) break;
      if (vertex == 0) words_.fail("there is no vertex 0; vertices are numbered from 1 on");
      group.vertices.push_back(static_cast<std::uint32_t>(vertex));
    }
    if (group.vertices.empty())
      words_.fail(fmt::format("group {} is empty; list its vertices", group.number));
    groups_.push_back(std::move(group));
  }
}

void OrderReader::read_ordering() {
  if (group_count_ == 0) words_.fail("GTSP_SETS must come before GTSP_SET_ORDERING");
  const auto starts_a_number = [](std::string_view word) {
    return !word.empty() && (word.front() == '-' || (word.front() >= '0' && word.front() <= '9'));
  };
  while (starts_a_number(words_.peek())) {
    const auto first = words_.whole_number("a group", 1, group_count_);
    for (;;) {
      const auto then = words_.whole_number("a group or -1", -1, group_count_);
      if (then == -1) break;
      if (then == 0) words_.fail("there is no group 0; groups are numbered from 1 on");
      pairs_.emplace_back(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(then));
    }
  }
}

void OrderReader::read_start() {
  start_ = static_cast<std::uint32_t>(
      words_.whole_number("the start group", 1, std::max<std::int64_t>(group_count_, 1)));
}

void OrderReader::finish() {
  if (!has_type_) words_.fail("TYPE is missing; it must be TSP, ATSP, GTSP or PCGLNS");
  if (!has_metric_)
    words_.fail("EDGE_WEIGHT_TYPE is missing; it must be EUC_2D, CEIL_2D or EXPLICIT");
  const bool is_matrix = problem_.metric == Metric::kMatrix;
  if (is_matrix && matrix_.empty()) words_.fail("EDGE_WEIGHT_SECTION is missing; list the costs");
  if (!is_matrix && places_.empty()) words_.fail("NODE_COORD_SECTION is missing; list the nodes");
  if (has_groups_ && groups_.empty()) words_.fail("GTSP_SET_SECTION is missing; list the groups");
  if (!has_groups_) {
    if (!groups_.empty() || !pairs_.empty())
      words_.fail("groups require TYPE GTSP or PCGLNS; change TYPE");
    for (std::uint32_t i = 1; i <= dimension_; ++i) groups_.push_back({i, {i}});
  }
  number_groups();
  sort_vertices();
  if (is_matrix) check_matrix();
}

/// Numbers the groups as sets: home first, then the other groups in the order of the file. Gives
/// the pairs of precedence these numbers.
void OrderReader::number_groups() {
  std::vector<Index> set_of(groups_.size() + 1, cnc::order::kNone);
  const auto home = std::find_if(
      groups_.begin(), groups_.end(), [&](const Group& group) { return group.number == start_; });
  if (home == groups_.end())
    words_.fail(fmt::format("the start group {} is missing; list it in GTSP_SET_SECTION", start_));
  std::rotate(groups_.begin(), home, home + 1);
  for (const Group& group : groups_) {
    Index& set = set_of[group.number];
    if (set != cnc::order::kNone) {
      words_.fail(
          fmt::format("group {} is in GTSP_SET_SECTION twice; leave one out", group.number));
    }
    set = static_cast<Index>(problem_.group_numbers.size());
    problem_.group_numbers.push_back(group.number);
  }
  for (const auto& [first, then] : pairs_) {
    if (first == then)
      words_.fail(fmt::format("group {} must come before itself; leave this pair out", first));
    if (set_of[first] == 0) continue;  // Home is always the first set, so the pair adds nothing.
    if (set_of[then] == 0) {
      words_.fail(fmt::format(
          "group {} must come before the start group {}; leave this pair out", first, then));
    }
    problem_.pairs.push_back({set_of[first], set_of[then]});
  }
}

void OrderReader::sort_vertices() {
  std::vector<bool> is_used(static_cast<std::size_t>(dimension_) + 1);
  problem_.first_candidate.push_back(0);
  for (const Group& group : groups_) {
    for (const std::uint32_t vertex : group.vertices) {
      if (is_used[vertex]) {
        words_.fail(fmt::format("vertex {} is in two groups, or in group {} twice; leave one out",
                                vertex,
                                group.number));
      }
      is_used[vertex] = true;
      problem_.vertex_numbers.push_back(vertex);
      if (!places_.empty()) problem_.entry.push_back(places_[vertex - 1]);
    }
    problem_.first_candidate.push_back(static_cast<Index>(problem_.vertex_numbers.size()));
  }
  const auto missing = std::find(is_used.begin() + 1, is_used.end(), false);
  if (missing != is_used.end()) {
    words_.fail(fmt::format("vertex {} is in no group; add it to one", missing - is_used.begin()));
  }
}

/// Arranges rows and columns of the matrix in the order of the candidates, and determines whether
/// the matrix is symmetric.
void OrderReader::check_matrix() {
  const std::size_t size = problem_.vertex_numbers.size();
  problem_.matrix.resize(size * size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t row = (problem_.vertex_numbers[i] - 1) * size;
    for (std::size_t k = 0; k < size; ++k) {
      problem_.matrix[i * size + k] = matrix_[row + problem_.vertex_numbers[k] - 1];
    }
  }
  problem_.is_symmetric = is_symmetric(problem_);
}

}  // namespace

OrderFileError::OrderFileError(std::string_view file, std::size_t line, std::string_view reason)
    : std::runtime_error{fmt::format("{}:{}: {}", file, line, reason)} {}

OrderProblem read_order_problem(std::string_view text, std::string_view file) {
  return OrderReader{text, file}.read();
}

}  // namespace sim::order
