#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "host-sim/plot/cut_animation.hpp"
#include "host-sim/plot/cut_numbers.hpp"
#include "host-sim/plot/cut_picture.hpp"
#include "host-sim/plot/job_sheet.hpp"
#include "host-sim/plot/pdf.hpp"
#include "host-sim/plot/sheet_pages.hpp"
#include "host-sim/report/duration_text.hpp"
#include "tests/host-sim/cut/random_sheet.hpp"
#include "tests/host-sim/trace/scratch_file.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

/// A drawing with its plan and its times.
struct ViewedJob {
  drawing::Drawing drawn;
  cut::CutPlan plan;
  cut::Timeline timeline;
  [[nodiscard]] CutScene scene() const { return {drawn, plan, &timeline}; }
};

ViewedJob viewed_job_of(const std::string& content, const cut::LayerSettings& settings = {}) {
  ViewedJob job{drawing::read(drawing::svg_of(content)), {}, {}};
  job.plan = cut::plan_of(job.drawn, settings);
  job.timeline = cut::timeline_of(job.plan);
  return job;
}

pugi::xml_document parsed(const std::string& svg) {
  pugi::xml_document document;
  const auto result = document.load_string(svg.c_str());
  EXPECT_TRUE(result) << result.description();
  return document;
}

bool overlap(const Box& a, const Box& b) {
  return a.left_px < b.right_px() && b.left_px < a.right_px() && a.top_px < b.bottom_px() &&
         b.top_px < a.bottom_px();
}

TEST(CutNumbers, LieNeitherOnEachOtherNorOnPierces) {
  for (const std::uint64_t seed : proof::Trials{20}) {
    proof::Random random{seed};
    const std::size_t count = 101 + random.below(1500);
    std::vector<PicturePlace> pierces;
    for (std::size_t i = 0; i < count; ++i) {
      pierces.push_back({random.between(0.0, 1500.0), random.between(0.0, 900.0)});
    }
    const NumberLayout layout{.size_px = number_size_px(count), .dot_px = 2.5};
    const std::vector<PlacedNumber> numbers = placed_numbers(pierces, layout);
    EXPECT_EQ(numbers.front().number, 1U);
    EXPECT_EQ(numbers.back().number, count);
    EXPECT_GT(numbers.size(), std::min<std::size_t>(count, 400) / 4);
    EXPECT_LE(numbers.size(), layout.max_shown + 2);
    for (std::size_t i = 1; i + 1 < numbers.size(); ++i) {
      const Box box = box_of(numbers[i], layout);
      for (std::size_t j = 0; j < i; ++j) {
        ASSERT_FALSE(overlap(box, box_of(numbers[j], layout))) << numbers[i].number;
      }
      for (const PicturePlace& pierce : pierces) {
        ASSERT_FALSE(overlap(box, {pierce.x_px - 2.5, pierce.y_px - 2.5, 5.0, 5.0}));
      }
    }
  }
}

TEST(CutNumbers, AreAllThereForFewCutsEvenOnOnePlace) {
  const std::vector<PicturePlace> pierces(60, PicturePlace{100.0, 100.0});
  const std::vector<PlacedNumber> numbers = placed_numbers(pierces, {});
  ASSERT_EQ(numbers.size(), 60U);
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i].number, i + 1);
}

TEST(CutPicture, IsWellFormedWithRapidsPiercesHeatAndNumbers) {
  const ViewedJob job =
      viewed_job_of(R"(<rect x="5" y="5" width="30" height="30"/><circle cx="20" cy="20" r="9"/>)"
                    R"(<circle cx="20" cy="20" r="4"/>)");
  const std::string svg = draw_cuts(job.scene(), "a <b> & \u00e9.svg");
  EXPECT_TRUE(parsed(svg).child("svg"));
  for (const char* text :
       {"class=\"rapids\"", "class=\"pierces\"", "class=\"heat\"", ">3</text>"}) {
    EXPECT_THAT(svg, testing::HasSubstr(text));
  }
  const std::string cold = draw_cuts({job.drawn, job.plan}, "cold");
  EXPECT_THAT(cold, testing::Not(testing::HasSubstr("class=\"heat\"")));
}

TEST(CutPicture, HasEngravedContoursForLinesAndNotForEdges) {
  const std::string content = R"(<rect x="5" y="5" width="30" height="30"/>)"
                              R"(<rect x="10" y="10" width="20" height="20" stroke="blue"/>)";
  ViewedJob job{drawing::read(drawing::svg_of(content)), {}, {}};
  ASSERT_EQ(job.drawn.layers.size(), 2U);
  std::vector<cut::LayerPlan> layers = cut::layers_with(job.drawn, {});
  layers[job.drawn.contours[1].entity.layer].settings.side = cut::Side::kMark;
  const auto edges = [&](const std::vector<cut::LayerPlan>& plans) {
    job.plan = cut::plan_cuts(job.drawn, plans);
    const pugi::xml_document document = parsed(draw_cuts({job.drawn, job.plan}, "engraved"));
    const std::string data =
        document.select_node("//path[@fill-rule='evenodd']").node().attribute("d").value();
    return std::ranges::count(data, 'Z');
  };
  EXPECT_EQ(edges(layers), 1);
  layers[job.drawn.contours[1].entity.layer].settings.side = cut::Side::kOn;
  EXPECT_EQ(edges(layers), 2);
}

std::vector<double> numbers_in(const std::string& list) {
  std::vector<double> numbers;
  std::istringstream stream{list};
  for (std::string item; std::getline(stream, item, ';');) numbers.push_back(std::stod(item));
  return numbers;
}

/// Expects that in every animation of a document the times begin at 0, never decrease, and match
/// the number of values.
void expect_sound_animations(const pugi::xml_document& document, const std::string& duration) {
  std::size_t count = 0;
  for (const auto& found : document.select_nodes("//animate|//animateTransform")) {
    const pugi::xml_node node = found.node();
    ++count;
    EXPECT_EQ(node.attribute("dur").as_string(), duration);
    const std::string values = node.attribute("values").as_string();
    const std::vector<double> times = numbers_in(node.attribute("keyTimes").as_string());
    ASSERT_EQ(times.size(), 1U + static_cast<std::size_t>(std::ranges::count(values, ';')));
    EXPECT_EQ(times.front(), 0.0);
    EXPECT_EQ(times.back(), 1.0);
    EXPECT_TRUE(std::ranges::is_sorted(times));
  }
  EXPECT_GE(count, 3U);
}

TEST(CutAnimation, RunsForwardToTheEndOfTheJob) {
  for (const std::uint64_t seed : proof::Trials{20}) {
    proof::Random random{seed};
    cut::LayerSettings settings;
    settings.pierce_s = random.between(0.0, 3.0);
    settings.corner_dwell_s = random.chance(0.5) ? 0.2 : 0.0;
    const ViewedJob job = viewed_job_of(cut::random_sheet(random, 2, 2).content, settings);
    const double shown_s = random.between(1.0, 40.0);
    const std::string svg = animate_cuts(job.scene(), "job", {shown_s});
    const pugi::xml_document document = parsed(svg);
    const double total_s = job.timeline.total_s();
    expect_sound_animations(document, fmt::format("{:.3f}s", std::min(total_s, shown_s)));
    const pugi::xml_node clock = document.select_node("//g[@class='clock']").node();
    EXPECT_EQ(clock
                  .find_child([](const pugi::xml_node& node) {
                    return !node.next_sibling("text") && std::string{node.name()} == "text";
                  })
                  .text()
                  .as_string(),
              duration_text(total_s));
    EXPECT_EQ(document.select_nodes("//g[@class='cuts']/path").size(), job.plan.cuts.size());
    EXPECT_THAT(svg, testing::Not(testing::HasSubstr("script")));
  }
}

/// Returns squares in rows: a plan without a drawing, which takes little time to create at any
/// size.
ViewedJob many_squares(std::size_t count) {
  ViewedJob job;
  job.drawn.layers.push_back({"", "black"});
  job.plan.layers = {{{}, {{2000, 1'800'000, 4'000'000}, 0.6, 0.01}}};
  for (std::size_t i = 0; i < count; ++i) {
    const cut::Place corner{5.0 * static_cast<double>(i % 300), 5.0 * static_cast<double>(i / 300)};
    cut::Cut& cut = job.plan.cuts.emplace_back();
    const std::array<cut::Place, 5> places{{corner,
                                            corner + cut::Place{3.0, 0.0},
                                            corner + cut::Place{3.0, 3.0},
                                            corner + cut::Place{0.0, 3.0},
                                            corner}};
    for (std::size_t k = 0; k < 4; ++k) cut.strokes.push_back({places[k], places[k + 1]});
  }
  job.timeline = cut::timeline_of(job.plan);
  return job;
}

TEST(CutAnimation, StaysSmallForManyCuts) {
  const ViewedJob job = many_squares(20'000);
  const std::string svg = animate_cuts(job.scene(), "many", {30.0});
  EXPECT_LT(svg.size(), 4'000'000U);
  const pugi::xml_document document = parsed(svg);
  expect_sound_animations(document, "30.000s");
  EXPECT_LE(document.select_nodes("//g[@class='cuts']/path").size(), 2'000U);
}

struct SheetBench {
  ViewedJob job;
  MaterialRecord record{};
  std::vector<std::string> pages(const cut::PriceList& prices) {
    record.name = "birch & glue";
    const cut::CutJob cut_job{
        job.drawn, job.plan, record, {.full_power_w = 3000.0}, {}, {"a note"}};
    return job_sheet(cut_job,
                     cut::figures_of(job.plan),
                     cut::account_of(job.drawn, job.plan, job.timeline, 60.0, prices));
  }
};

std::string text_of_pages(const std::vector<std::string>& pages) {
  std::string text;
  for (const std::string& page : pages) {
    const pugi::xml_document document = parsed(page);
    for (const auto& found : document.select_nodes("//text")) {
      text += std::string{found.node().text().as_string()} + "\n";
    }
  }
  return text;
}

TEST(JobSheet, HasConditionsPartsCostsAndNotes) {
  SheetBench bench{viewed_job_of(R"(<rect id="gr&#xFC;n" x="5" y="5" width="30" height="30"/>)")};
  const std::string text = text_of_pages(bench.pages({60.0, 12.0, "CHF"}));
  for (const char* expected : {"Job sheet: test",
                               "birch & glue, 2 mm",
                               "rect \"gr\u00fcn\"",
                               "13.00 CHF in all: machine 1.00 CHF at 60.00 CHF an hour",
                               "CHF each",
                               "1 min 00.0 s in all",
                               "a note",
                               "page 1 of "}) {
    EXPECT_THAT(text, testing::HasSubstr(expected));
  }
  EXPECT_THAT(text_of_pages(bench.pages({})), testing::Not(testing::HasSubstr("Cost")));
}

TEST(JobSheet, HasEachPartOnOneOfItsPages) {
  std::string content;
  for (int i = 0; i < 130; ++i) {
    content += fmt::format(R"(<rect id="n{}" x="{}" y="{}" width="{:.3f}" height="4"/>)",
                           i,
                           1 + 9 * (i % 10),
                           1 + 7 * (i / 10),
                           4.0 + 0.01 * i);
  }
  SheetBench bench{viewed_job_of(content, {.lead_in = {cut::LeadKind::kLine, 0.5}})};
  const std::vector<std::string> pages = bench.pages({});
  EXPECT_GE(pages.size(), 3U);
  const std::string text = text_of_pages(pages);
  for (int i = 0; i < 130; ++i) {
    EXPECT_THAT(text, testing::HasSubstr(fmt::format("rect \"n{}\"\n", i)));
  }
  EXPECT_THAT(text, testing::HasSubstr(fmt::format("page {0} of {0}", pages.size())));
}

TEST(JobSheet, IsTheSameBytesEachTimeAndHasNoDate) {
  SheetBench bench{viewed_job_of(R"(<rect x="5" y="5" width="30" height="30"/>)")};
  const ScratchFile first{".first.pdf"};
  const ScratchFile second{".second.pdf"};
  write_pdf(first.path(), bench.pages({}), "title");
  write_pdf(second.path(), bench.pages({}), "title");
  EXPECT_TRUE(first.text().starts_with("%PDF"));
  EXPECT_EQ(first.text(), second.text());
  EXPECT_THAT(first.text(), testing::Not(testing::HasSubstr("CreationDate")));
}

TEST(JobSheet, CutsOffTextThatIsTooWideBetweenCharacters) {
  for (std::size_t length = 0; length < 40; ++length) {
    std::string text;
    for (std::size_t i = 0; i < length; ++i) text += "\u00fc";
    const std::string fitted = fitted_text(text, 100.0, 10.0);
    EXPECT_EQ(fitted == text, length <= 15) << length;
    if (fitted != text) {
      EXPECT_TRUE(fitted.ends_with("\u00fc\u2026"));
    }
  }
}

}  // namespace
}  // namespace sim
