#include <map>
#include <memory>

#include <google/protobuf/stubs/logging.h>

#include "common/base/check.h"
#include "common/generate/generate.h"
#include "server/prepare/prepare.h"
#include "server/rpc/live_wire.h"
#include "server/session/previews.h"
#include "tests/fuzz/readers.h"

namespace burnish {
namespace {

constexpr uint64_t kConnection = 1;
constexpr char kAuthor[] = "fuzzer";

const PreparedMesh& small_scan() {
  static const std::shared_ptr<const PreparedMesh> scan = [] {
    PrepareOptions options;
    options.depth = kDepthMin;
    return prepare(make_icosphere(1, 1), options).value();
  }();
  return *scan;
}

/// What a live session does with its clients' messages, without clients and without solving.
class Desk {
 public:
  bool take(const v1::ClientMessage& message) {
    switch (message.message_case()) {
      case v1::ClientMessage::kGreeting:
        return from_wire(message.greeting()).is_ok();
      case v1::ClientMessage::kCredit:
        return from_wire(message.credit()).is_ok();
      case v1::ClientMessage::kMoveBrush:
        return from_wire(message.move_brush()).is_ok();
      case v1::ClientMessage::kApply:
        return apply(message.apply());
      case v1::ClientMessage::kPreview:
        return preview(message.preview());
      default:
        return false;
    }
  }

  /// Needs nothing: whatever came, the fields can be shown, and are finite.
  void show() {
    EditedFields::Changes changes = edited_.take_changes();
    for (const float beta : previews_.over(edited_.fields(), changes).view().beta)
      BURNISH_CHECK(beta >= kBetaMin && beta <= kBetaMax, "beta of a cell");
  }

 private:
  bool apply(const v1::ApplyEdits& message) {
    auto edits = edits_from_wire(message.edits());
    if (!edits.is_ok()) return false;
    std::vector<AuthoredEdit> fresh;
    std::map<std::string, int> seen;
    for (Edit& edit : *edits)
      if (!edited_.history().knows(kAuthor, edit.id) && ++seen[edit.id] == 1)
        fresh.push_back({kAuthor, 0, std::move(edit)});
    const bool applied = edited_.apply(fresh).is_ok();
    previews_.drop_applied(edited_.history());
    return applied;
  }

  bool preview(const v1::Preview& message) {
    if (message.has_drop()) {
      previews_.drop(kConnection);
      return true;
    }
    auto piece = from_wire(message);
    if (!piece.is_ok()) return false;
    // as LiveSession::preview() asks
    const auto* stroke = std::get_if<Stroke>(&piece->change);
    const auto* slider = std::get_if<SetGradientScale>(&piece->change);
    if (stroke && !validate(*stroke).is_ok()) return false;
    if (slider && !check_beta(slider->beta).is_ok()) return false;
    previews_.show(kConnection, {kAuthor, piece->edit_id, std::move(piece->change)});
    return true;
  }

  EditedFields edited_{small_scan()};
  Previews previews_;
};

}  // namespace

bool read_live_messages(std::span<const uint8_t> bytes) {
  google::protobuf::SetLogHandler(nullptr);  // a line for each text that is not UTF-8
  Desk desk;
  bool all_taken = true;
  while (bytes.size() >= 2) {
    const size_t size = std::min<size_t>(bytes[0] + 256 * bytes[1], bytes.size() - 2);
    v1::ClientMessage message;
    all_taken &=
        message.ParseFromArray(bytes.data() + 2, static_cast<int>(size)) && desk.take(message);
    bytes = bytes.subspan(2 + size);
    desk.show();
  }
  return all_taken && bytes.empty();
}

}  // namespace burnish
