#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/connection/connection.h"
#include "common/pages/directory_codec.h"
#include "common/pages/page_codec.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// A server with a sphere.
class PagesOverTheWire : public testing::Test {
 protected:
  PagesOverTheWire() : connection_(Connection::open(server_.address, kPatience).value()) {
    EXPECT_TRUE(
        connection_.import_scan(write_sphere(server_.folder, 5), "ball", {5, 0}, {}).is_ok());
  }

  PageHead head() {
    return decode_head(connection_.describe_pages("ball", {}).value().head).value();
  }

  ServerProcess server_;
  Connection connection_;
};

TEST_F(PagesOverTheWire, AllOfThemAreTheScanAtEveryLevel) {
  const PageHead head = this->head();
  std::vector<size_t> triangles(head.level_count());
  const auto take_page = [&](const PagePart& part) {
    const Page page = decode_page(part.bytes).value();
    EXPECT_TRUE(check_page_in_scan(page, part.number, head).is_ok());
    triangles[head.level_of(page.id)] += page.triangles.size();
    return true;
  };
  for (PageId page = 0; page < head.page_count(); ++page)
    ASSERT_TRUE(connection_.fetch_pages({"ball", {}, {page}}, {{}, take_page}).is_ok());
  EXPECT_EQ(triangles.front(), head.scan_triangles);
  for (size_t level = 1; level < triangles.size(); ++level)
    EXPECT_LT(triangles[level], triangles[level - 1]);
}

TEST_F(PagesOverTheWire, BlocksComeBeforePages) {
  std::string order;
  const auto take = [&](char kind) {
    return [&order, kind](const PagePart&) {
      order += kind;
      return true;
    };
  };
  ASSERT_TRUE(connection_.fetch_pages({"ball", {0}, {1, 0}}, {take('b'), take('p')}).is_ok());
  EXPECT_EQ(order, "bpp");
}

TEST_F(PagesOverTheWire, AreFetchedUntilCancelled) {
  int pages = 0;
  const auto take = [&](const PagePart&) { return ++pages < 2; };
  EXPECT_EQ(connection_.fetch_pages({"ball", {}, {0, 1, 2, 0, 1, 2}}, {{}, take}).code(),
            StatusCode::kCancelled);
  EXPECT_EQ(pages, 2);
}

TEST_F(PagesOverTheWire, OfWhatIsNotThereNameIt) {
  EXPECT_THAT(connection_.describe_pages("cube", {}).status().message(), HasSubstr("'cube'"));
  EXPECT_THAT(connection_.fetch_pages({"ball", {}, {999999}}, {}).message(), HasSubstr("999999"));
  EXPECT_THAT(connection_.fetch_pages({"ball", {}, {}}, {}).message(), HasSubstr("1..64"));
}

}  // namespace
}  // namespace burnish
