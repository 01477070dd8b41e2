#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/scene/null_page_renderer.h"
#include "tests/system/server_process.h"
#include "tests/system/workspace_pictures.h"

namespace burnish {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// A workspace that shows files before they are imported, on a server without scans.
class WorkspaceDepth : public testing::Test {
 protected:
  WorkspaceDepth() {
    workspace_.viewport.set_size({400, 300});
    workspace_.connect(server_.address);
    EXPECT_TRUE(until([this] { return workspace_.library().state == Library::State::kConnected; }));
  }

  template <typename What>
  bool until(What what) {
    return pictures_until(workspace_, what);
  }
  bool until_settled_at(int depth) {
    return until([&] {
      return workspace_.document() && document().depth() == depth && document().is_settled();
    });
  }
  Document& document() { return *workspace_.document(); }
  std::vector<std::string> texts() const {
    std::vector<std::string> texts;
    for (const Message& message : workspace_.log.messages()) texts.push_back(message.text);
    return texts;
  }

  ServerProcess server_;
  Connection owner_ = Connection::open(server_.address, kPatience).value();
  NullPageRenderer renderer_;
  Workspace workspace_{renderer_, Preferences(), WorkspaceOptions{.shows_raw = true}};
};

TEST_F(WorkspaceDepth, ARawScanOpensAtTheDepthThatIsChosen) {
  const auto file = write_sphere(server_.folder, 4);
  workspace_.import_scan(file);
  ASSERT_TRUE(until([this] { return workspace_.raw() != nullptr; }));
  EXPECT_EQ(workspace_.chosen_depth(), 0);
  EXPECT_GT(workspace_.raw()->statistics.area, 0);
  workspace_.choose_depth(6);
  EXPECT_EQ(workspace_.chosen_depth(), 6);
  workspace_.choose_depth(5);
  ASSERT_TRUE(until_settled_at(5));
  EXPECT_EQ(workspace_.raw(), nullptr);
  EXPECT_EQ(workspace_.chosen_depth(), 0);
}

TEST_F(WorkspaceDepth, ASessionOpensAgainAtAnotherDepthWithItsEdits) {
  ASSERT_TRUE(owner_.import_scan(write_sphere(server_.folder, 3), "ball", {5, 0}, {}).is_ok());
  ASSERT_TRUE(owner_.open_session({"ball", "work", {5, 0}}).is_ok());
  const Palette palette{{{"soft", 0x4a7fd0, TransferCurve(20)}}};
  const std::vector<Edit> edits = {
      {"a", SetGradientScale{0.5}},
      {"b", SetTransferCurve{TransferCurve(30)}},
      {"c", SetPalette{palette}},
      {"d", Stroke{{.radius = 0.3, .beta = 2}, {Vec3d(0, 0, 1)}}},
  };
  ASSERT_TRUE(owner_.apply("work", edits).is_ok());
  workspace_.join_by_name("work");
  ASSERT_TRUE(until_settled_at(5));
  workspace_.open_again(6);
  ASSERT_TRUE(until_settled_at(6));
  EXPECT_EQ(document().beta(), 0.5);
  EXPECT_EQ(document().curve().curve(), TransferCurve(30));
  EXPECT_EQ(document().palette(), palette);
  EXPECT_EQ(document().session().name, "ball");
  EXPECT_THAT(texts(), Not(Contains(HasSubstr("without"))));
  EXPECT_EQ(owner_.history("ball").value().size(), owner_.history("work").value().size());
  EXPECT_EQ(owner_.list_sessions()->size(), 2u);
}

}  // namespace
}  // namespace burnish
