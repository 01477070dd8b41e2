#include "client/connection/session_link.h"

#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/system/fetched_pages.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr int kDepth = 5;

/// A client of the session that shows the scan's own triangles: its surface and its news.
class Client {
 public:
  Client(const ServerProcess& server, const std::string& user,
         std::optional<PageFrameKind> kind = std::nullopt)
      : connection(Connection::open(server.address, kPatience).value()),
        pages(fetch_all_pages(connection, "ball")) {
    connection.set_user(user);
    LiveOptions options = pages.live_options("work", kDepth);
    options.greeting.kind = kind;
    options.retry_after_min = milliseconds(20);
    options.retry_after_max = milliseconds(200);
    session = std::make_unique<SessionLink>(connection, options);
    EXPECT_TRUE(session->show_pages(pages.level(0), {}).is_ok());
  }

  void take() {
    news = session->take();
    for (LiveEvent& event : news.events) events.push_back(std::move(event));
  }

  template <typename What>
  bool until(What what) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < end) {
      take();
      if (what()) return true;
      std::this_thread::sleep_for(milliseconds(5));
    }
    return false;
  }
  bool until_live() {
    return until([this] { return news.link == LinkState::kLive; });
  }
  bool until_settled_with(uint64_t edits) {
    return until([&] {
      const bool has_all = news.frame && news.frame->pages.size() == pages.level(0).size();
      return has_all && news.stats.frame.settled && news.stats.frame.edits >= edits;
    });
  }

  template <typename Event>
  const Event* told() const {
    for (auto event = events.rbegin(); event != events.rend(); ++event)
      if (const auto* found = std::get_if<Event>(&*event)) return found;
    return nullptr;
  }

  /// Returns the moves of all shown vertices, in cells.
  std::vector<Vec3f> moves() const {
    std::vector<Vec3f> all;
    if (!news.frame) return all;
    for (const auto& move : news.frame->moves)
      all.insert(all.end(), move->displacements.begin(), move->displacements.end());
    return all;
  }

  /// Returns the largest move of a vertex, in file units.
  double largest_move() const {
    double largest = 0;
    for (const Vec3f& move : moves()) largest = std::max<double>(largest, move.norm());
    return largest * pages.cell_size(kDepth);
  }

  Connection connection;
  FetchedPages pages;
  std::unique_ptr<SessionLink> session;
  LiveNews news;
  std::vector<LiveEvent> events;
};

std::vector<Edit> slider(const std::string& id, double beta) {
  return {Edit{id, SetGradientScale{beta}}};
}

/// A server with a session over a sphere.
class LiveService : public testing::Test {
 protected:
  LiveService() {
    Connection connection = Connection::open(server_.address, kPatience).value();
    EXPECT_TRUE(
        connection.import_scan(write_sphere(server_.folder, 4), "ball", {5, 0}, {}).is_ok());
    EXPECT_TRUE(connection.open_session({"ball", "work", {5, 0}}).is_ok());
  }

  ServerProcess server_;
};

TEST_F(LiveService, ShowsAnEditToAllItsClients) {
  Client anna(server_, "anna"), bert(server_, "bert");
  ASSERT_TRUE(anna.until_settled_with(0));
  EXPECT_EQ(anna.largest_move(), 0);
  ASSERT_TRUE(anna.session->apply(slider("a", 0)).is_ok());
  ASSERT_TRUE(anna.until_settled_with(1));
  ASSERT_TRUE(bert.until_settled_with(1));
  EXPECT_GT(anna.largest_move(), 1e-4);
  EXPECT_EQ(anna.moves(), bert.moves());
  ASSERT_TRUE(anna.until([&] { return anna.told<EditsAcknowledged>(); }));
  EXPECT_THAT(anna.told<EditsAcknowledged>()->edit_ids, ElementsAre("a"));
  ASSERT_TRUE(bert.until([&] { return bert.told<HistoryState>(); }));
  EXPECT_EQ(bert.told<HistoryState>()->settings.beta, 0);
  ASSERT_TRUE(bert.until([&] {
    return bert.told<SessionPeople>() && bert.told<SessionPeople>()->present.size() == 2;
  }));
}

TEST_F(LiveService, SendsVerticesOrCornersAsTheClientInsists) {
  Client corners(server_, "anna", PageFrameKind::kCorners);
  Client vertices(server_, "bert", PageFrameKind::kVertices);
  ASSERT_TRUE(corners.until_live());
  ASSERT_TRUE(corners.session->apply(slider("a", 0)).is_ok());
  for (Client* client : {&corners, &vertices}) ASSERT_TRUE(client->until_settled_with(1));
  const std::vector<Vec3f> some = corners.moves(), others = vertices.moves();
  ASSERT_EQ(some.size(), others.size());
  for (size_t v = 0; v < some.size(); ++v)
    EXPECT_LT((some[v] - others[v]).norm(), 1.0 / 128) << v;  // two roundings
}

TEST_F(LiveService, MovesThePagesThatAreShownAndNoOthers) {
  Client anna(server_, "anna");
  ASSERT_TRUE(anna.until_settled_with(0));
  const auto fine = anna.pages.level(0);
  std::vector<PageId> removed;
  for (const auto& page : fine) removed.push_back(page->id);
  const PageId root = anna.pages.head.root();
  ASSERT_TRUE(anna.session->show_pages({anna.pages.pages[root]}, removed).is_ok());
  ASSERT_TRUE(anna.session->apply(slider("a", 0)).is_ok());
  ASSERT_TRUE(anna.until([&] {
    return anna.news.stats.frame.settled && anna.news.stats.frame.edits == 1 &&
           anna.news.frame->pages == std::vector<PageId>{root};
  }));
  EXPECT_GT(anna.largest_move(), 1e-4);
}

TEST_F(LiveService, ShowsAPreviewAndForgetsIt) {
  Client anna(server_, "anna"), bert(server_, "bert");
  ASSERT_TRUE(anna.until_settled_with(0));
  anna.session->preview("p", SetGradientScale{0});
  ASSERT_TRUE(
      anna.until([&] { return anna.told<PreviewShown>() && anna.news.stats.frame.settled; }));
  ASSERT_TRUE(
      bert.until([&] { return bert.largest_move() > 1e-4 && bert.news.stats.frame.settled; }));
  const double previewed = bert.largest_move();
  anna.session->drop_preview("p");
  ASSERT_TRUE(bert.until([&] { return bert.largest_move() < previewed / 10; }));
  EXPECT_EQ(bert.news.stats.frame.edits, 0u);
}

TEST_F(LiveService, LosesNoEditWhenItIsKilled) {
  Client anna(server_, "anna");
  ASSERT_TRUE(anna.until_live());
  server_.listen = server_.address;
  for (int i = 0; i < 40; ++i) {
    const double x = 0.02 * i;
    const Stroke stroke{{.radius = 0.3, .beta = 2}, {Vec3d(x, 0, std::sqrt(1 - x * x))}};
    ASSERT_TRUE(anna.session->apply({Edit{"s" + std::to_string(i), stroke}}).is_ok());
    anna.take();
    if (i == 20) {
      server_.kill();
      server_.start();
    }
  }
  EXPECT_TRUE(anna.session->wait_until_acknowledged(kPatience));
  ASSERT_TRUE(anna.until_settled_with(40));
  Connection again = Connection::open(server_.address, kPatience).value();
  const auto history = again.history("work").value();
  ASSERT_EQ(history.size(), 40u);
  for (int i = 0; i < 40; ++i) EXPECT_EQ(history[i].edit_id, "s" + std::to_string(i));
}

TEST_F(LiveService, RefusesWhatTheHistoryCannotDo) {
  Client anna(server_, "anna");
  ASSERT_TRUE(anna.until_live());
  ASSERT_TRUE(anna.session->apply({Edit{"r", RestoreCheckpoint{"never"}}}).is_ok());
  ASSERT_TRUE(anna.until([&] { return anna.told<EditsRefused>() != nullptr; }));
  EXPECT_THAT(anna.told<EditsRefused>()->status.message(), HasSubstr("never"));
  EXPECT_EQ(anna.news.unacknowledged, 0u);
}

TEST_F(LiveService, EndsForItsClientsWhenTheSessionIsDeleted) {
  Client anna(server_, "anna");
  ASSERT_TRUE(anna.until_live());
  Connection owner = Connection::open(server_.address, kPatience).value();
  ASSERT_TRUE(owner.delete_session("work").is_ok());
  EXPECT_TRUE(anna.until([&] { return anna.news.link == LinkState::kEnded; }));
}

TEST_F(LiveService, ItsClientsComeBackAfterADrain) {
  Client anna(server_, "anna");
  ASSERT_TRUE(anna.until_live());
  ASSERT_TRUE(anna.session->apply(slider("a", 0.5)).is_ok());
  ASSERT_TRUE(anna.session->wait_until_acknowledged(kPatience));
  server_.listen = server_.address;
  server_.process->signal(SIGTERM);
  ASSERT_TRUE(anna.until([&] { return anna.news.link == LinkState::kLost; }));
  ASSERT_TRUE(anna.session->apply(slider("b", 0.25)).is_ok());
  EXPECT_EQ(server_.process->wait(kPatience), 0);
  server_.start();
  EXPECT_TRUE(anna.session->wait_until_acknowledged(kPatience));
  EXPECT_TRUE(anna.until_settled_with(2));
}

}  // namespace
}  // namespace burnish
