#include "client/web/core/front.h"

#include <algorithm>
#include <utility>

#include "client/script/script_runner.h"
#include "client/web/core/front_commands.h"
#include "client/web/core/json_writer.h"
#include "client/web/core/picture_address.h"
#include "client/web/core/snapshot.h"
#include "client/web/core/stored_png.h"

namespace burnish {

using std::chrono::milliseconds;

static constexpr milliseconds kSnapshotInterval{50};
static constexpr milliseconds kIdle{500};    // figures and activities go on without news
static constexpr milliseconds kFiner{16};    // while the picture becomes finer
static constexpr milliseconds kDrawing{24};  // while the card draws
static constexpr milliseconds kRest{100};    // until edges become smooth
static constexpr std::chrono::seconds kPictureInterval{10};  // nobody tells before a page is closed

Front::Front(PageRenderer& renderer, Preferences preferences, WorkspaceOptions options,
             FrontHost host)
    : renderer_(renderer),
      host_(std::move(host)),
      workspace_(renderer, std::move(preferences), std::move(options)) {}

void Front::answer(const std::string& line, const Status& status) {
  JsonWriter json;
  json.open().text("kind", "answer").text("line", line).text("message", status.message()).close();
  host_.say(json.written());
}

void Front::do_line(const std::string& line) {
  FrontParts parts{workspace_, state_, host_};
  const Status done = do_front_line(line, parts);
  if (!done.is_ok()) answer(line, done);
}

void Front::replay(const GivenFile& script) {
  host_.begin([this, script] {
    const auto text = host_.read(script);
    const auto lines = text.is_ok() ? parse_script(*text, script.name) : text.status();
    if (!lines.is_ok()) return workspace_.log.failure("replay", lines.status());
    ScriptRunner runner(
        workspace_, renderer_,
        {.wait = host_.wait,
         .keep_picture = [this](const Image& image, const std::filesystem::path& file) {
           host_.download(file.filename().string(), stored_png(image));
           return Status::ok();
         }});
    const Status done = runner.run(*lines, script.name);
    if (!done.is_ok()) return workspace_.log.failure("replay", done);
    workspace_.log.info("replayed " + script.name);
  });
}

Front::Time Front::tick(Time now) {
  const bool draws = may_draw(now);
  workspace_.update(draws);
  Document* const document = workspace_.document();
  if (document) {
    document->show_over(state_.shows_protection, state_.shows_curves);
    document->measuring().follow_deviation(document->shown());
    if (document->measuring().plane()) document->measuring().follow_section(document->shown());
  }
  const Status drawn = draws ? draw(now) : Status::ok();
  const std::string failure = drawn.is_ok() ? "" : drawn.message();
  if (std::exchange(failure_, failure) != failure && !drawn.is_ok())
    workspace_.log.failure("picture", drawn);
  say_strength_picture();
  say_guides();
  keep_picture_now_and_then(now);
  const Time snapshot_at = std::min(say_snapshot(now), begun_at_ ? now + kDrawing : Time::max());
  if (!document && workspace_.activities().empty()) return snapshot_at;
  const bool is_final = document && document->is_picture_fine() && shown_.is_smooth;
  const bool becomes_finer = document && !begun_at_ && !is_final && is_visible_;
  return std::min(snapshot_at, now + (becomes_finer ? kFiner : kIdle));
}

bool Front::may_draw(Time now) {
  if (!begun_at_) return true;
  if (host_.is_drawing()) return false;
  const auto took = std::chrono::duration<double, std::milli>(now - *begun_at_);
  workspace_.on_picture(took.count(), surface_ms_);
  begun_at_.reset();
  return true;
}

Front::Shown Front::next_shown() const {
  Shown next{.begun = workspace_.pictures_begun(),
             .is_raw = workspace_.raw() != nullptr,
             .size = workspace_.viewport.size(),
             .camera = workspace_.viewport.camera,
             .is_smooth = shown_.is_smooth};
  if (const Document* const document = workspace_.document()) {
    next.changes = document->picture_changes();
    next.style = workspace_.viewport.style(*document);
  }
  return next;
}

bool Front::is_at_rest(const Shown& next, Time now) const {
  if (!host_.set_smooth) return true;
  if (!(next == shown_)) return false;
  const Document* const document = workspace_.document();
  const bool is_settled = !document || document->is_picture_fine();
  return shown_.is_smooth || (is_settled && now - changed_at_ >= kRest);
}

// Leaves smooth edges to pictures that are saved.
Status Front::draw_surface(bool is_smooth) {
  if (!host_.set_smooth) return workspace_.draw();
  host_.set_smooth(is_smooth);
  Status drawn = workspace_.draw();
  surface_ms_ = host_.draw_ms();
  host_.set_smooth(true);
  return drawn;
}

// Draws the surface again if its picture has changed.
Status Front::draw(Time now) {
  if (!is_visible_ || !workspace_.has_picture()) return Status::ok();
  const ImageSize& size = workspace_.viewport.size();
  if (!check_image_size(size).is_ok()) return Status::ok();
  RETURN_IF_ERROR(workspace_.look());
  Shown next = next_shown();
  if (!(next == shown_)) changed_at_ = now;
  next.is_smooth = is_at_rest(next, now);
  const bool keeps = shown_.is_raw && size == shown_.size && !next.is_raw &&
                     workspace_.keeps_raw_picture(shown_.camera);
  if (next == shown_ || keeps) return Status::ok();
  RETURN_IF_ERROR(draw_surface(next.is_smooth));
  shown_ = std::move(next);
  host_.show();
  // One of the background alone takes no time, and must not hold the surface up. One at rest says
  // nothing about the pace of moving ones.
  const Document* const document = workspace_.document();
  const bool has_pace = !host_.set_smooth || !shown_.is_smooth;
  if (has_pace && document && !document->surface().patches().empty()) begun_at_ = now;
  JsonWriter json;
  json.open().text("kind", "drawn").whole("count", static_cast<int64_t>(++pictures_)).close();
  host_.say(json.written());
  return Status::ok();
}

void Front::keep_picture_now_and_then(Time now) {
  const Document* const document = workspace_.document();
  if (!document || !document->is_picture_settled() || !document->is_settled()) return;
  if (!shown_.is_smooth) return;
  const bool is_new_session = kept_session_ != document->session().id;
  if (kept_picture_ == pictures_ || (!is_new_session && now - kept_at_ < kPictureInterval)) return;
  workspace_.keep_session_picture();
  kept_session_ = document->session().id;
  kept_picture_ = pictures_;
  kept_at_ = now;
}

void Front::say_strength_picture() {
  const Document* const document = workspace_.document();
  if (!document || !document->is_picture_fine() || !(next_shown() == shown_)) return;
  if (!shown_.is_smooth) return;
  const StrengthStrip::Picture* const picture = workspace_.keep_strength_picture();
  if (!picture) return;
  JsonWriter json;
  json.open().text("kind", "strength").whole("number", static_cast<int64_t>(picture->number));
  host_.say(json.text("address", picture_address(picture->image)).close().written());
}

// Apart from the snapshot: a turn of the view changes nothing else, and a page has much to draw.
void Front::say_guides() {
  std::string guides = guides_of(workspace_);
  if (guides == said_guides_) return;
  host_.say(guides);
  said_guides_ = std::move(guides);
}

Front::Time Front::say_snapshot(Time now) {
  if (now - said_at_ < kSnapshotInterval) return said_at_ + kSnapshotInterval;
  std::string snapshot = snapshot_of(workspace_, state_);
  if (snapshot == said_) return Time::max();
  host_.say(R"({"kind":"snapshot","snapshot":)" + snapshot + "}");
  said_ = std::move(snapshot);
  said_at_ = now;
  return Time::max();
}

}  // namespace burnish
