#include "client/cli/bench/load_client.h"

#include <bit>

namespace burnish {

using std::chrono::steady_clock;

static constexpr std::chrono::minutes kAnswerPatience{2};

static LiveOptions live_options(const LoadOptions& options) {
  LiveOptions live;
  live.greeting = {.session = options.session, .kind = {}};
  live.head = options.surface->head;
  live.depth = options.surface->depth;
  live.pages_fingerprint = options.surface->pages_fingerprint;
  live.draw_interval =
      std::chrono::microseconds(static_cast<int64_t>(1e6 / options.pictures_per_second));
  live.heartbeat_interval = options.heartbeat_interval;
  return live;
}

LoadClient::LoadClient(const Connection& connection, const LoadOptions& options, uint32_t seed)
    : options_(options),
      session_(connection, live_options(options)),
      gestures_(options.surface, options.mix, seed) {
  const Status shown = session_.show_pages(options.surface->pages, {});
  if (!shown.is_ok()) figures_.ended = shown.to_string();
}

void LoadClient::start(std::chrono::duration<double> length) {
  thread_ = std::thread([this, length] { run(length); });
}

void LoadClient::join() {
  thread_.join();
}

void LoadClient::run(std::chrono::duration<double> length) {
  const auto begin = steady_clock::now();
  const auto picture = std::chrono::duration<double>(1 / options_.pictures_per_second);
  auto next = begin;
  while (steady_clock::now() < begin + length && figures_.ended.empty()) {
    draw();
    gestures_.advance(steady_clock::now(), session_);
    next += std::chrono::duration_cast<steady_clock::duration>(picture);
    std::this_thread::sleep_until(next);
  }
  figures_.seconds = std::chrono::duration<double>(steady_clock::now() - begin).count();
  figures_.frames = stats_.frames;
  figures_.bytes = stats_.bytes;
  gestures_.end(session_);
  session_.move_brush(std::nullopt);
  session_.wait_until_acknowledged(kAnswerPatience);
  draw();
  figures_.applied = gestures_.applied().size();
}

void LoadClient::draw() {
  LiveNews news = session_.take();
  if (news.stats.frames > stats_.frames) {
    figures_.age_ms.push_back(news.stats.age_ms);
    figures_.drawn_ms.push_back(news.stats.age_ms + news.stats.waited_ms);
  }
  stats_ = news.stats;
  shown_ = news.frame;
  for (const LiveEvent& event : news.events) {
    if (const auto* answer = std::get_if<EditsAcknowledged>(&event))
      figures_.acknowledged.insert(answer->edit_ids.begin(), answer->edit_ids.end());
    if (const auto* refused = std::get_if<EditsRefused>(&event))
      figures_.refused.push_back(refused->status.to_string());
    if (const auto* shown = std::get_if<EditsShown>(&event))
      figures_.edit_ms.push_back(shown->latency_ms);
    if (const auto* shown = std::get_if<PreviewShown>(&event))
      figures_.preview_ms.push_back(shown->latency_ms);
    if (const auto* link = std::get_if<LinkChanged>(&event)) {
      if (link->state == LinkState::kLost) ++figures_.times_lost;
      if (link->state == LinkState::kEnded) figures_.ended = link->reason;
    }
  }
}

bool LoadClient::settle(uint64_t edits, std::chrono::seconds patience) {
  const auto end = steady_clock::now() + patience;
  while (steady_clock::now() < end && figures_.ended.empty()) {
    draw();
    const bool has_all = shown_ && shown_->pages.size() == options_.surface->pages.size();
    if (has_all && stats_.frame.settled && stats_.frame.edits >= edits) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

uint64_t LoadClient::shown_hash() const {
  uint64_t hash = 14695981039346656037u;  // FNV-1a
  if (!shown_) return 0;
  for (const auto& move : shown_->moves)
    for (const Vec3f& displacement : move->displacements)
      for (const float part : displacement)
        hash = (hash ^ std::bit_cast<uint32_t>(part)) * 1099511628211u;
  return hash;
}

}  // namespace burnish
