#include <map>
#include <memory>

#include <google/protobuf/stubs/logging.h>

#include "common/base/check.h"
#include "common/generate/generate.h"
#include "common/page_frames/shown_pages.h"
#include "common/wire/live_wire.h"
#include "server/prepare/prepare.h"
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

/// Checks that a message of the product's own writer is read, and written again the same.
void check_reads_back(const v1::ClientMessage& written) {
  const auto again = from_wire(written);
  BURNISH_CHECK(again.is_ok(), "a client's message does not read back");
  BURNISH_CHECK(to_wire(*again).SerializeAsString() == written.SerializeAsString(),
                "a client's message reads back as another");
}

void check_reads_back(const v1::ServerMessage& written) {
  const auto again = from_wire(written);
  BURNISH_CHECK(again.is_ok() && again->has_value(), "a server's message does not read back");
  BURNISH_CHECK(to_wire(**again).SerializeAsString() == written.SerializeAsString(),
                "a server's message reads back as another");
}

/// The part of a live session that handles clients' messages, without clients and without solving.
class Desk {
 public:
  bool take(const v1::ClientMessage& message) {
    const auto said = from_wire(message);
    if (!said.is_ok()) {
      (void)refused_ids(message);
      return false;
    }
    check_reads_back(to_wire(*said));
    return std::visit([this](const auto& part) { return act(part); }, *said);
  }

  /// After any messages the fields can be shown, and are finite.
  void show() {
    EditEffects changes = edited_.take_changes();
    for (const float beta : previews_.over(edited_.fields(), changes).view().beta)
      BURNISH_CHECK(beta >= kBetaMin && beta <= kBetaMax, "beta of a cell");
  }

 private:
  bool act(const Greeting&) { return true; }
  bool act(const FrameCredit&) { return true; }
  bool act(const MoveBrush&) { return true; }
  bool act(const Heartbeat&) { return true; }

  // like PageWishes::want()
  bool act(const ShowPages& change) {
    static const auto no_layout = std::make_shared<const PageLayout>();
    PageChange numbers{change.revision, {}, change.removed};
    for (const PageId page : change.added) numbers.added.push_back({page, no_layout});
    if (!pages_.check(numbers, kPageCount).is_ok()) return false;
    pages_ = pages_.changed(numbers);
    return true;
  }

  bool act(const ApplyEdits& apply) {
    std::vector<AuthoredEdit> fresh;
    std::map<std::string, int> seen;
    for (const Edit& edit : apply.edits)
      if (!edited_.history().knows(kAuthor, edit.id) && ++seen[edit.id] == 1)
        fresh.push_back({kAuthor, 0, edit});
    const bool applied = edited_.apply(fresh).is_ok();
    previews_.drop_applied(edited_.history());
    return applied;
  }

  bool act(const Preview& piece) {
    // like LiveSession::preview()
    const auto* stroke = std::get_if<Stroke>(&piece.change);
    const auto* slider = std::get_if<SetGradientScale>(&piece.change);
    if (stroke && !validate(*stroke).is_ok()) return false;
    if (slider && !check_beta(slider->beta).is_ok()) return false;
    previews_.show(kConnection, {kAuthor, piece.edit_id, piece.change});
    return true;
  }

  bool act(const DropPreview&) {
    previews_.drop(kConnection);
    return true;
  }

  static constexpr uint32_t kPageCount = 1000;  // of the scan
  ShownPages pages_;
  EditedFields edited_{small_scan()};
  Previews previews_;
};

}  // namespace

bool read_live_messages(std::span<const uint8_t> bytes) {
  google::protobuf::SetLogHandler(nullptr);  // else it logs a line for each text that is not UTF-8
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

bool read_server_message(std::span<const uint8_t> bytes) {
  google::protobuf::SetLogHandler(nullptr);
  v1::ServerMessage message;
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return false;
  const auto said = from_wire(std::move(message));
  if (!said.is_ok() || !said->has_value()) return false;
  check_reads_back(to_wire(**said));
  return true;
}

}  // namespace burnish
