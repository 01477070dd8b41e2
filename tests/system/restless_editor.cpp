#include "tests/system/restless_editor.h"

#include <algorithm>
#include <thread>

#include "common/base/check.h"
#include "tests/system/server_process.h"

namespace burnish {

using std::chrono::milliseconds;

RestlessEditor::RestlessEditor(const EditorPlace& place, const std::string& user, uint32_t seed)
    : place_(place),
      user_(user),
      random_(seed),
      connection_(Connection::open(place.address, kPatience).value()) {
  connection_.set_user(user);
  LiveOptions options = place.pages.live_options(place.session, place.depth);
  options.retry_after_min = milliseconds(20);
  options.retry_after_max = milliseconds(200);
  link_ = std::make_unique<SessionLink>(connection_, options);
  EXPECT_TRUE(link_->show_pages({place.pages.pages.back()}, {}).is_ok());
}

// Leaves out edits that switch others' entries: the book of an author knows only its own. Nothing
// is protected, because a stroke there is refused.
decltype(Edit::change) RestlessEditor::next_change() {
  const auto upto = [this](double top) {
    return std::uniform_real_distribution<double>(0, top)(random_);
  };
  switch (random_() % 20) {
    case 0:
    case 1:
      return SetGradientScale{upto(2)};
    case 2:
      return SetTransferCurve{TransferCurve(5 + upto(50))};
    case 3:
    case 4:
      return Undo{};
    case 5:
    case 6:
      return Redo{};
    case 7:
      return SetControls{{.pin_rims = random_() % 2 == 0, .cap = place_.brush_radius + upto(1)}};
    case 8:
      return SetPalette{{{{"grooves", 0x112233, TransferCurve(5 + upto(50))}}}};
    case 9:
      return SetColour{{5 + upto(50), upto(2)}};
    case 10:
      return Protect{NoRegion{}};
    case 11:
      return SetTexture{{upto(4), upto(1)}};
    case 12:  // a session has bands or kept edges
      if (place_.has_bands) return SetEqualiser{{{{place_.brush_radius, upto(2)}}}};
      return SetEdges{{.strength = upto(1), .passes = 1 + static_cast<int>(random_() % 5)}};
    default:
      return stroke(upto(1));
  }
}

Stroke RestlessEditor::stroke(double value) {
  const Vec3d& centre = place_.surface[random_() % place_.surface.size()];
  Brush brush{.radius = place_.brush_radius, .beta = value};
  const auto painted = random_() % 6;
  brush.colour = painted == 1;
  brush.edges = painted == 2 && !place_.has_bands;
  brush.texture = painted == 3;
  return {brush, {centre}};
}

Edit RestlessEditor::next_edit() {
  return {user_ + "-" + std::to_string(sent_.size()), next_change()};
}

void RestlessEditor::edit() {
  sent_.push_back(next_edit());
  losses_when_sent_[sent_.back().id] = losses_;
  const Status status = link_->apply({sent_.back()});
  BURNISH_CHECK(status.is_ok(), status.message());
}

void RestlessEditor::take_answer(const std::vector<std::string>& ids,
                                 std::set<std::string>& answered) {
  for (const std::string& id : ids) {
    answered.insert(id);
    losses_when_answered_[id] = losses_;
  }
}

void RestlessEditor::listen() {
  const LiveNews news = link_->take();
  for (const LiveEvent& event : news.events) {
    if (const auto* answer = std::get_if<EditsAcknowledged>(&event))
      take_answer(answer->edit_ids, acknowledged_);
    if (const auto* answer = std::get_if<EditsRefused>(&event))
      take_answer(answer->edit_ids, refused_);
    if (std::holds_alternative<Welcome>(event)) {
      welcomed_ = true;
      frames_then_ = frames_;
    }
  }
  frames_ = news.stats.frames;
}

bool RestlessEditor::wait_until_answered() {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (acknowledged_.size() + refused_.size() < sent_.size()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(milliseconds(2));
    listen();
  }
  return true;
}

void RestlessEditor::lose_server() {
  listen();
  welcomed_ = false;
  ++losses_;
}

/// A model of the author's undo, as a plain list: no other user switches these entries.
struct RestlessEditor::Book {
  std::vector<std::pair<std::string, bool>> entries;
  std::vector<size_t> undone;
  std::set<std::string> refusals;

  void write(const Edit& edit) {
    if (kind_of(edit) == EditKind::kUndo) return undo(edit.id);
    if (kind_of(edit) == EditKind::kRedo) return redo(edit.id);
    undone.clear();
    entries.emplace_back(edit.id, true);
  }

  void undo(const std::string& id) {
    const auto last =
        std::find_if(entries.rbegin(), entries.rend(), [](const auto& e) { return e.second; });
    if (last == entries.rend()) {
      refusals.insert(id);
      return;
    }
    last->second = false;
    undone.push_back(static_cast<size_t>(entries.rend() - last) - 1);
  }

  void redo(const std::string& id) {
    if (undone.empty()) {
      refusals.insert(id);
      return;
    }
    entries[undone.back()].second = true;
    undone.pop_back();
  }
};

/// A refusal is not on disk. If the server dies before it sends the refusal, the client resends the
/// edit, and the server judges it again after the later edits that are on disk. The place among
/// them is unknown.
bool RestlessEditor::is_certain(const std::string& edit_id) const {
  return losses_when_sent_.at(edit_id) == losses_when_answered_.at(edit_id);
}

/// Replays the recorded edits in order, and each refused edit after all edits that were sent before
/// it.
RestlessEditor::Book RestlessEditor::keep_book(const std::vector<std::string>& recorded) const {
  std::map<std::string, size_t> rank;
  for (const std::string& id : recorded) rank.emplace(id, rank.size() + 1);
  std::map<std::pair<size_t, size_t>, const Edit*> judged;
  size_t last = 0;
  for (size_t i = 0; i < sent_.size(); ++i) {
    const auto place = rank.find(sent_[i].id);
    if (place != rank.end()) {
      judged[{place->second, 0}] = &sent_[i];
      last = std::max(last, place->second);
    } else if (is_certain(sent_[i].id)) {
      judged[{last, i + 1}] = &sent_[i];
    }
  }
  Book book;
  for (const auto& [place, edit] : judged) book.write(*edit);
  return book;
}

std::vector<std::pair<std::string, bool>> RestlessEditor::expected_entries(
    const std::vector<std::string>& recorded) const {
  return keep_book(recorded).entries;
}

std::set<std::string> RestlessEditor::expected_refusals(
    const std::vector<std::string>& recorded) const {
  return keep_book(recorded).refusals;
}

std::set<std::string> RestlessEditor::refused() const {
  std::set<std::string> refused;
  for (const std::string& id : refused_)
    if (is_certain(id)) refused.insert(id);
  return refused;
}

}  // namespace burnish
