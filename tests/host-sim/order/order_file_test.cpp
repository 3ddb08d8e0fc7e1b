#include "host-sim/order/order_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host-sim/order/order_solver.hpp"
#include "planner/order/problem.hpp"

namespace {

using sim::order::Metric;
using sim::order::NoOrder;
using sim::order::OrderFileError;
using sim::order::OrderMethod;
using sim::order::OrderOptions;
using sim::order::OrderProblem;
using sim::order::OrderResult;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kTriangle =
    "NAME : three\nTYPE: TSP\nCOMMENT: of: no use\nDIMENSION : 3\nEDGE_WEIGHT_TYPE: EUC_2D\n"
    "NODE_COORD_SECTION\n1 0 0\n2 1.5 0\n3 0 2\nEOF\n";

/// Returns two contours with a hole each, on a line; the home is group 1.
std::string nested(const std::string& ordering, const std::string& more = "") {
  return fmt::format(
      "NAME : nested\nTYPE : PCGLNS\nDIMENSION : 6\nGTSP_SETS : 5\nEDGE_WEIGHT_TYPE : EXPLICIT\n"
      "EDGE_WEIGHT_FORMAT : FULL_MATRIX\nEDGE_WEIGHT_SECTION\n"
      "0 1 2 3 4 5\n1 0 1 2 3 4\n2 1 0 1 2 3\n3 2 1 0 1 2\n4 3 2 1 0 1\n5 4 3 2 1 0\n"
      "GTSP_SET_SECTION\n1 1 -1\n2 2 -1\n3 3 4 -1\n4 5 -1\n5 6 -1\n"
      "GTSP_SET_ORDERING\n{}{}EOF\n",
      ordering,
      more);
}

OrderProblem read(const std::string& text) { return sim::order::read_order_problem(text, "a.tsp"); }

std::string fault_of(const std::string& text) {
  try {
    static_cast<void>(read(text));
  } catch (const OrderFileError& error) {
    return error.what();
  }
  return "none";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

OrderResult solved(const OrderProblem& problem, OrderMethod method) {
  OrderOptions options;
  options.method = method;
  if (method == OrderMethod::kOurs) options.steps = 1000;
  return sim::order::solve_order(problem, options, {});
}

TEST(OrderFileTest, ReadsPlacesAndRoundsDistances) {
  const OrderProblem problem = read(kTriangle);
  EXPECT_EQ(problem.name, "three");
  EXPECT_EQ(problem.metric, Metric::kRoundedPlane);
  EXPECT_THAT(problem.first_candidate, ElementsAre(0, 1, 2, 3));
  // Costs are rounded as by TSPLIB's nint: 1.5 to 2, and 2.5 to 3.
  EXPECT_EQ(solved(problem, OrderMethod::kOurs).cost, 2.0 + 3.0 + 2.0);
  EXPECT_EQ(solved(read(replaced(kTriangle, "1.5", "1.4")), OrderMethod::kNearest).cost, 5.0);
  EXPECT_EQ(solved(read(replaced(kTriangle, "EUC_2D", "CEIL_2D")), OrderMethod::kFile).cost, 7.0);
}

TEST(OrderFileTest, ReadsGroupsMatrixAndPrecedence) {
  const OrderProblem problem = read(nested("3 2 -1\n5 4 -1\n"));
  EXPECT_THAT(problem.first_candidate, ElementsAre(0, 1, 2, 4, 5, 6));
  ASSERT_EQ(problem.pairs.size(), 2U);
  EXPECT_EQ(problem.pairs[0].first, 2U);
  EXPECT_EQ(problem.pairs[0].then, 1U);
  EXPECT_TRUE(problem.is_symmetric);
  for (const OrderMethod method : {OrderMethod::kOurs,
                                   OrderMethod::kExact,
                                   OrderMethod::kFile,
                                   OrderMethod::kNearest,
                                   OrderMethod::kAnneal}) {
    const OrderResult result = solved(problem, method);
    std::vector<std::size_t> at(result.order.size());
    for (std::size_t i = 0; i < at.size(); ++i) at[result.order[i]] = i;
    for (const auto& pair : problem.pairs) EXPECT_LT(at[pair.first], at[pair.then]);
    EXPECT_GE(result.cost, 10.0);
  }
  const OrderResult exact = solved(problem, OrderMethod::kExact);
  EXPECT_TRUE(exact.is_proven);
  EXPECT_EQ(exact.cost, 10.0);
}

TEST(OrderFileTest, HomeIsTheStartGroup) {
  const OrderProblem problem = read(nested("3 2 -1\n", "START_GROUP_SECTION\n4\n"));
  EXPECT_THAT(problem.group_numbers, ElementsAre(4, 1, 2, 3, 5));
  const OrderResult result = solved(problem, OrderMethod::kOurs);
  EXPECT_EQ(problem.vertex_numbers[result.candidates.front()], 5U);
}

TEST(OrderFileTest, ForbiddenLegsAreAvoided) {
  const std::string ring = replaced(nested(""), "0 1 2 3 4 5\n", "0 -1 2 -1 -1 5\n");
  const OrderProblem problem = read(ring);
  EXPECT_FALSE(problem.is_symmetric);
  EXPECT_TRUE(cnc::order::is_allowed(solved(problem, OrderMethod::kExact).cost));
  EXPECT_EQ(solved(problem, OrderMethod::kOurs).cost, solved(problem, OrderMethod::kExact).cost);
}

TEST(OrderFileTest, ALegForbiddenByPrecedenceLeavesTheProblemSymmetric) {
  const std::string text = replaced(nested("3 2 -1\n"), "1 0 1 2 3 4\n", "1 0 -1 -1 3 4\n");
  EXPECT_TRUE(read(text).is_symmetric);
  EXPECT_FALSE(read(replaced(text, "3 2 -1\n", "")).is_symmetric);
}

TEST(OrderFileTest, StepsGiveTheSameResultAgain) {
  const OrderProblem problem = read(nested("3 2 -1\n5 4 -1\n"));
  const OrderResult first = solved(problem, OrderMethod::kOurs);
  const OrderResult second = solved(problem, OrderMethod::kOurs);
  EXPECT_EQ(first.order, second.order);
  EXPECT_EQ(first.candidates, second.candidates);
  EXPECT_EQ(first.steps, second.steps);
}

TEST(OrderFileTest, ACycleNamesItsGroups) {
  const OrderProblem problem = read(nested("3 2 -1\n2 5 -1\n5 3 -1\n"));
  try {
    static_cast<void>(solved(problem, OrderMethod::kOurs));
    FAIL();
  } catch (const NoOrder& error) {
    EXPECT_THAT(error.what(), HasSubstr("cycle: "));
    for (const char* step : {"3 before 2", "2 before 5", "5 before 3"}) {
      EXPECT_THAT(error.what(), HasSubstr(step));
    }
  }
}

TEST(OrderFileTest, FaultsNameTheirLineAndReason) {
  const std::string good = nested("3 2 -1\n");
  const std::vector<std::pair<std::string, std::string>> faults{
      {"", "a.tsp:1: TYPE is missing"},
      {replaced(kTriangle, "TYPE: TSP\n", ""), "TYPE is missing"},
      {replaced(kTriangle, "TSP", "HCP"), "a.tsp:2: TYPE `HCP` is not supported"},
      {replaced(kTriangle, "EUC_2D", "GEO"), "a.tsp:5: EDGE_WEIGHT_TYPE `GEO` is not supported"},
      {replaced(kTriangle, "DIMENSION : 3\n", ""), "DIMENSION must come before NODE_COORD_SECTION"},
      {replaced(kTriangle, "DIMENSION : 3", "DIMENSION : 0"), "0 is out of range; write DIMENSION"},
      {replaced(kTriangle, "DIMENSION : 3", "DIMENSION 3"), "a colon is missing after `DIMENSION`"},
      {replaced(kTriangle, "2 1.5", "1 1.5"), "a.tsp:8: node 1 is listed twice"},
      {replaced(kTriangle, "1.5", "one"), "a.tsp:8: `one` is not a number; write x"},
      {replaced(kTriangle, "1.5", "nan"), "`nan` is not a number; write x"},
      {replaced(kTriangle, "1.5", "1e300"), "node 2 is farther than"},
      {replaced(kTriangle, "3 0 2\nEOF\n", ""), "the file ends where a node is required"},
      {replaced(kTriangle, "COMMENT", "CAPACITY"),
       "a.tsp:3: the entry `CAPACITY` is not supported"},
      {replaced(kTriangle, "NODE_COORD_SECTION", "DEMAND_SECTION"),
       "the section `DEMAND_SECTION` is not supported"},
      {replaced(good, "0 1 2 3 4 5", "0 1 2 3 4 -5"), "-5 is not a cost of the leg from 1 to 6"},
      {replaced(good, "FULL_MATRIX", "UPPER_ROW"),
       "EDGE_WEIGHT_FORMAT `UPPER_ROW` is not supported"},
      {replaced(good, "GTSP_SETS : 5\n", ""), "GTSP_SETS must come before"},
      {replaced(good, "3 3 4 -1", "3 -1"), "group 3 is empty"},
      {replaced(good, "3 3 4 -1", "3 3 3 -1"), "vertex 3 is in two groups, or in group 3 twice"},
      {replaced(good, "3 3 4 -1", "3 3 -1"), "vertex 4 is in no group"},
      {replaced(good, "3 3 4 -1", "2 3 4 -1"), "group 2 is in GTSP_SET_SECTION twice"},
      {replaced(good, "3 3 4 -1", "3 3 7 -1"), "7 is out of range; write a vertex or -1"},
      {nested("3 9 -1\n"), "9 is out of range; write a group or -1"},
      {nested("3 3 -1\n"), "group 3 must come before itself"},
      {nested("3 1 -1\n"), "group 3 must come before the start group 1"},
      {nested("3 2\n"), "whole number; write a group or -1"},
  };
  for (const auto& [text, reason] : faults) EXPECT_THAT(fault_of(text), HasSubstr(reason)) << text;
  EXPECT_EQ(fault_of(good), "none");
}

TEST(OrderFileTest, AProofThatIsTooLargeSaysSo) {
  std::string many = "TYPE: TSP\nDIMENSION: 100\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n";
  for (int i = 1; i <= 100; ++i) many += fmt::format("{} {} {}\n", i, i * 37 % 101, i * 53 % 97);
  EXPECT_THROW(static_cast<void>(solved(read(many), OrderMethod::kExact)), NoOrder);
}

TEST(OrderFileTest, OneAndTwoNodesAreTours) {
  for (const int nodes : {1, 2}) {
    std::string text = fmt::format(
        "TYPE: TSP\nDIMENSION: {}\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 0\n", nodes);
    if (nodes == 2) text += "2 3 4\n";
    for (const OrderMethod method : {OrderMethod::kOurs,
                                     OrderMethod::kExact,
                                     OrderMethod::kFile,
                                     OrderMethod::kNearest,
                                     OrderMethod::kAnneal}) {
      EXPECT_EQ(solved(read(text), method).cost, nodes == 1 ? 0.0 : 10.0);
    }
  }
}

}  // namespace
