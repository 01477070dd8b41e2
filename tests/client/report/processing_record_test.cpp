#include "client/report/processing_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "client/report/length_text.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

ProcessingRecord record_of_head() {
  ProcessingRecord record;
  record.program = "burnish 1.2.3";
  record.unix_ms = 1'700'000'000'000;
  record.author = "anna";
  record.scan.id = std::string(64, 'a');
  record.scan.name = "head <of> \"a\" god";
  record.scan.unit = "mm";
  record.scan.statistics.triangles = 12;
  record.state.session.name = "work";
  record.state.settings.beta = 0.25;
  record.edits = {{1, "x", "anna", 1'700'000'000'000, EditKind::kGradientScale, "beta 0.25", true},
                  {2, "y", "", 1'700'000'001'000, EditKind::kStroke, "stroke & more", false}};
  record.file = "head.ply";
  record.result.sha256 = std::string(64, 'b');
  record.result.deviation = Deviation{.max = 0.5, .rms = 0.125, .histogram_range = 0.5};
  record.result.deviation->histogram[32] = 1;
  record.result.deviation->axes = std::array<AxisMoves, 3>{{{}, {}, {-0.25, 0.125, -0.0625, 0.1}}};
  return record;
}

TEST(ProcessingRecord, SaysAsJsonWhoDidWhat) {
  const auto json = nlohmann::json::parse(record_json(record_of_head()));
  EXPECT_EQ(json["burnish_record"], 1);
  EXPECT_EQ(json["author"], "anna");
  EXPECT_EQ(json["time"], "2023-11-14T22:13:20Z");
  EXPECT_EQ(json["input"]["sha256"], std::string(64, 'a'));
  EXPECT_EQ(json["output"]["sha256"], std::string(64, 'b'));
  EXPECT_EQ(json["deviation"]["max"], 0.5);
  EXPECT_EQ(json["deviation"]["histogram"]["area"].size(), size_t{Deviation::kBins});
  ASSERT_EQ(json["edits"].size(), 2u);
  EXPECT_EQ(json["edits"][0]["what"], "beta 0.25");
  EXPECT_EQ(json["edits"][1]["on"], false);
  EXPECT_EQ(json["edited_since"], false);
}

TEST(ProcessingRecord, SaysHowFarTheSurfaceMovedAlongEachAxis) {
  EXPECT_THAT(record_page(record_of_head()),
              HasSubstr("at most -0.25 mm, mean -0.0625 mm, rms 0.1 mm"));
  const auto axes = nlohmann::json::parse(record_json(record_of_head()))["deviation"]["axes"];
  EXPECT_EQ(axes["z"]["least"], -0.25);
  EXPECT_EQ(axes["x"]["most"], 0);
}

TEST(ProcessingRecord, HasEverySettingOfTheSession) {
  ProcessingRecord record = record_of_head();
  record.state.settings.edges.strength = 0.5;
  const auto method = nlohmann::json::parse(record_json(record))["method"];
  const std::string page = record_page(record);
  for (const SettingText& setting : texts_of(record.state.settings)) {
    EXPECT_TRUE(method.contains(setting.key)) << setting.key;
    EXPECT_THAT(page, HasSubstr(setting.label));
  }
  EXPECT_EQ(method["gradient_scale"], 0.25);
  EXPECT_THAT(method["edges"], HasSubstr("kept at strength 0.5"));
}

TEST(ProcessingRecord, PageShowsNamesAsTheyAreWritten) {
  const std::string page = record_page(record_of_head());
  EXPECT_THAT(page, HasSubstr("head &lt;of&gt; &quot;a&quot; god"));
  EXPECT_THAT(page, HasSubstr("stroke &amp; more"));
  EXPECT_THAT(page, Not(HasSubstr("<of>")));
  EXPECT_THAT(page, HasSubstr("0.5 mm"));
}

TEST(ProcessingRecord, NamesEditsForPeopleOnThePageAloneAndKeepsTheWordsOfPrograms) {
  ProcessingRecord record = record_of_head();
  record.edits[1].name = "Smooth stroke";
  record.edits[1].details = "β 0";
  record.edits[1].radius = 0.0046919;
  const std::string page = record_page(record);
  EXPECT_THAT(page, HasSubstr("Smooth stroke<br><small>radius 0.00469 mm, β 0</small>"));
  EXPECT_THAT(page, Not(HasSubstr("stroke &amp; more")));
  const auto json = nlohmann::json::parse(record_json(record));
  EXPECT_EQ(json["edits"][1]["what"], "stroke & more");
}

TEST(ProcessingRecord, PageMarksEntriesThatAreOff) {
  const std::string page = record_page(record_of_head());
  const size_t off = page.find("class=\"off\"><td>");
  ASSERT_NE(off, std::string::npos);
  EXPECT_LT(page.find("beta 0.25"), off);
  EXPECT_GT(page.find("stroke &amp; more"), off);
}

TEST(ProcessingRecord, PageHasABarForEachBin) {
  const std::string page = record_page(record_of_head());
  size_t bars = 0;
  for (size_t at = page.find("<rect"); at != std::string::npos; at = page.find("<rect", at + 1))
    ++bars;
  EXPECT_EQ(bars, size_t{Deviation::kBins});
}

TEST(ProcessingRecord, IsWrittenAsItsEndingSays) {
  const TemporaryFolder folder;
  for (const char* name : {"record.json", "record.html"}) {
    const auto file = folder / name;
    ASSERT_TRUE(check_record_name(file).is_ok());
    ASSERT_TRUE(write_record(record_of_head(), file).is_ok());
    EXPECT_GT(std::filesystem::file_size(file), 500u);
  }
  EXPECT_THAT(check_record_name("record.pdf").message(), HasSubstr("record.pdf"));
}

TEST(LengthText, HasAsManyDigitsAsItIsMeasuredAndItsUnit) {
  EXPECT_EQ(length_text(0.0123456, "mm"), "0.0123 mm");
  EXPECT_EQ(length_text(2, ""), "2");
  EXPECT_EQ(length_text(1513.2, "m"), "1513 m");
  EXPECT_EQ(length_text(44.1456, "m", kDeviationDigits), "44.15 m");
  EXPECT_EQ(length_text(4389.236, "m", kRulerDigits), "4389.2 m");
}

}  // namespace
}  // namespace burnish
