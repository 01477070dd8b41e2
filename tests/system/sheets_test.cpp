// A scan's pictures as a client gets them: sheets over its pages.

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "burnish/v1/library.pb.h"
#include "client/connection/connection.h"
#include "common/pages/directory_codec.h"
#include "common/sheets/chart_codec.h"
#include "common/sheets/sheet_codec.h"
#include "common/sheets/sheet_directory.h"
#include "common/wire/sheets_wire.h"
#include "tests/server/prepare/sheets/photo_archive.h"
#include "tests/system/fetched_pages.h"
#include "tests/system/server_process.h"
#include "tests/system/wire_call.h"

namespace burnish {
namespace {

using testing::HasSubstr;

std::vector<uint8_t> bytes_in(const std::string& text) {
  return {text.begin(), text.end()};
}

/// A server with a painted ball that came as an archive.
class SheetsOverTheWire : public testing::Test {
 protected:
  SheetsOverTheWire()
      : channel_(wire_channel(server_.address)),
        connection_(Connection::open(server_.address, kPatience).value()) {
    import("ball", ball_.zip());
  }

  void import(const std::string& name, const std::vector<uint8_t>& zip) {
    const auto file = server_.folder / (name + ".zip");
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(zip.data()), static_cast<std::streamsize>(zip.size()));
    const auto imported = connection_.import_scan(file, name, {5, 0}, {});
    EXPECT_TRUE(imported.is_ok()) << imported.status().to_string();
  }

  /// `session`: "" asks for the scan's own.
  WireAnswer ask(const std::string& scan, const std::string& session) {
    v1::DescribeSheetsRequest request;
    request.set_scan(scan);
    if (!session.empty()) request.set_session(session);
    return call(channel_, {"/burnish.v1.Library/DescribeSheets", {request.SerializeAsString()}});
  }

  SheetsDescription describe(const std::string& scan, const std::string& session = {}) {
    const WireAnswer answer = ask(scan, session);
    EXPECT_TRUE(answer.status.ok()) << answer.status.error_message();
    v1::DescribeSheetsEvent last;
    EXPECT_TRUE(!answer.messages.empty() && last.ParseFromString(answer.messages.back()));
    EXPECT_TRUE(last.has_done());
    return from_wire(last.done());
  }

  grpc::Status fetch(const SheetsWish& wish) {
    const WireAnswer answer =
        call(channel_, {"/burnish.v1.Library/FetchSheets", {to_wire(wish).SerializeAsString()}});
    events_.clear();
    for (const std::string& message : answer.messages)
      EXPECT_TRUE(events_.emplace_back().ParseFromString(message));
    return answer.status;
  }

  const PaintedBall ball_ = {.quads_per_side = 24, .face_texels = 126};
  ServerProcess server_;
  std::shared_ptr<grpc::Channel> channel_;
  Connection connection_;
  std::vector<v1::FetchSheetsEvent> events_;
};

/// Fetches all blocks, and returns the entries by page.
struct SheetDirectory {
  std::vector<ChartEntry> charts;
  Groups<SheetEntry> sheets;

  void add(const SheetBlock& block) {
    charts.insert(charts.end(), block.charts.begin(), block.charts.end());
    for (size_t i = 0; i < block.sheets.count(); ++i) sheets.add(block.sheets[i]);
  }
};

TEST_F(SheetsOverTheWire, AllOfThemFitThePagesAndShowThePicture) {
  const FetchedPages pages = fetch_all_pages(connection_, "ball");
  const SheetHead head = decode_sheet_head(describe("ball").head, pages.head).value();
  EXPECT_EQ(head.pages_fingerprint, pages.fingerprint);
  SheetDirectory directory;
  for (uint32_t block = 0; block < head.blocks.size(); ++block) {
    ASSERT_TRUE(fetch({"ball", {block}, {}, {}}).ok());
    directory.add(
        decode_sheet_block(bytes_in(events_.at(0).block().data()), head, pages.head, block)
            .value());
  }
  double squares = 0;
  size_t places = 0;
  for (PageId id = 0; id < pages.head.page_count(); ++id) {
    const Page& page = *pages.pages[id];
    SheetsWish wish{"ball", {}, {id}, {}};
    for (uint32_t halving = 0; halving < directory.sheets[id].size(); ++halving)
      wish.sheets.push_back({id, halving});
    ASSERT_TRUE(fetch(wish).ok());
    ASSERT_EQ(events_.size(), 1 + wish.sheets.size());
    const PageCharts charts = decode_charts(bytes_in(events_[0].charts().data()), page).value();
    for (size_t i = 0; i < wish.sheets.size(); ++i) {
      const SheetPart part = from_wire(events_[1 + i].sheet());
      EXPECT_EQ(part.number, wish.sheets[i]);
      EXPECT_EQ(part.bytes.size(), directory.sheets[id][i].bytes);
      const Sheet sheet = decode_sheet(part.bytes).value();
      const double texels_per_step = sheet.density * pages.head.grid.step();
      EXPECT_TRUE(check_sheet_layout(sheet.layout, page, charts, texels_per_step).is_ok());
      if (i > 0 || id >= pages.head.level_begin(1)) continue;
      for (size_t t = 0; t < page.triangles.size(); ++t, ++places) {
        const size_t chart = charts.of_triangle[t];
        Vec3d middle = Vec3d::Zero();
        for (const uint16_t v : page.triangles[t]) middle += page.positions[v].cast<double>() / 3;
        const Vec2d at =
            chart_mapping(charts.charts[chart], texels_per_step, sheet.layout.places[chart])
                .texel(middle);
        const auto column = static_cast<size_t>(at.x());
        const auto row = static_cast<size_t>(at.y());
        const Rgba8 shown = sheet.texels.at(row * sheet.layout.width + column);
        const Rgba8 wanted = ball_.colour_at(
            pages.head.grid.origin + (middle + Vec3d::Constant(0.5)) * pages.head.grid.step());
        for (int k = 0; k < 3; ++k) squares += std::pow(shown[k] - wanted[k], 2) / 3;
      }
    }
  }
  // The nearest texel is half a texel off: a few levels of a wave of 40 texels.
  EXPECT_LT(std::sqrt(squares / static_cast<double>(places)), 12);
}

TEST_F(SheetsOverTheWire, PartsThatAreNotThereAreNamed) {
  EXPECT_EQ(fetch({"ball", {}, {}, {{0, 0}}}).error_code(), grpc::StatusCode::FAILED_PRECONDITION);
  ASSERT_TRUE(describe("ball").has_sheets());
  EXPECT_THAT(fetch({"ball", {}, {}, {{999999, 0}}}).error_message(), HasSubstr("999999"));
  EXPECT_THAT(fetch({"ball", {}, {}, {}}).error_message(), HasSubstr("1..64"));
}

TEST_F(SheetsOverTheWire, AScanWithoutPicturesHasNone) {
  ASSERT_TRUE(connection_.import_scan(write_sphere(server_.folder), "plain", {5, 0}, {}).is_ok());
  EXPECT_FALSE(describe("plain").has_sheets());
}

/// The same with two sessions: over photos whose seams may be levelled, and over the ball.
class LevelledSheetsOverTheWire : public SheetsOverTheWire {
 protected:
  LevelledSheetsOverTheWire() {
    import("grid", zip_of(PhotoGrid()));
    for (const std::string name : {"grid", "ball"})
      EXPECT_TRUE(connection_.open_session({name, name + " session", {5, 0}}).is_ok());
  }

  void level(double amount) {
    const Edit edit{"level" + std::to_string(++edits_), SetTexture{{.level_seams = amount}}};
    EXPECT_TRUE(connection_.apply("grid session", {&edit, 1}).is_ok());
  }
  std::string first_sheet(uint64_t version) {
    EXPECT_TRUE(fetch({"grid", {}, {}, {{0, 0}}, version}).ok());
    return events_.empty() ? std::string() : events_[0].sheet().data();
  }

  int edits_ = 0;
};

TEST_F(LevelledSheetsOverTheWire, AreThoseThatASessionsEditsAskFor) {
  const SheetsDescription own = describe("grid");
  EXPECT_EQ(own.version, 0u);
  EXPECT_EQ(describe("grid", "grid session").version, 0u);
  level(1);
  const SheetsDescription levelled = describe("grid", "grid session");
  ASSERT_NE(levelled.version, 0u);
  EXPECT_NE(first_sheet(levelled.version), first_sheet(0));
  EXPECT_EQ(describe("grid").head, own.head);
  EXPECT_EQ(describe("grid").version, 0u);
  const Edit undo{"undo", Undo{}};
  EXPECT_TRUE(connection_.apply("grid session", {&undo, 1}).is_ok());
  EXPECT_EQ(describe("grid", "grid session").version, 0u);
}

TEST_F(LevelledSheetsOverTheWire, KeepWhatIsProtected) {
  level(1);
  const uint64_t all = describe("grid", "grid session").version;
  const Edit edit{"protect", left_half(PhotoGrid().side())};
  EXPECT_TRUE(connection_.apply("grid session", {&edit, 1}).is_ok());
  const uint64_t part = describe("grid", "grid session").version;
  EXPECT_NE(part, all);
  EXPECT_NE(part, 0u);
}

TEST_F(LevelledSheetsOverTheWire, OfASessionOfAnotherScanAreRefusedWithBothNames) {
  const grpc::Status status = ask("grid", "ball session").status;
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(status.error_message(), HasSubstr("ball session"));
  EXPECT_THAT(status.error_message(), HasSubstr("not grid"));
  EXPECT_EQ(ask("grid", "nobody").status.error_code(), grpc::StatusCode::NOT_FOUND);
}

TEST_F(LevelledSheetsOverTheWire, OfAnUnknownVersionAskToBeDescribed) {
  const grpc::Status status = fetch({"grid", {}, {}, {{0, 0}}, 77});
  EXPECT_EQ(status.error_code(), grpc::StatusCode::FAILED_PRECONDITION);
  EXPECT_THAT(status.error_message(), HasSubstr("77"));
  EXPECT_THAT(status.error_message(), HasSubstr("DescribeSheets"));
}

}  // namespace
}  // namespace burnish
