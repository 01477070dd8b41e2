// The client's messages in a live session.

#include "common/base/limits.h"
#include "common/edit/preview_change.h"
#include "common/wire/edit_wire.h"
#include "common/wire/history_wire.h"
#include "common/wire/live_wire.h"

namespace burnish {
namespace {

/// Sets the message's member of the oneof.
struct ClientWriter {
  v1::ClientMessage& message;

  void operator()(const Greeting& greeting) const {
    *message.mutable_greeting() = burnish::to_wire(greeting);
  }
  void operator()(const FrameCredit& credit) const {
    write_fields(credit, *message.mutable_credit());
  }
  void operator()(const ApplyEdits& apply) const {
    v1::ApplyEdits& sent = *message.mutable_apply();
    for (const Edit& edit : apply.edits) *sent.add_edits() = burnish::to_wire(edit);
  }
  void operator()(const Preview& preview) const {
    v1::Preview& sent = *message.mutable_preview();
    sent.set_edit_id(preview.edit_id);
    write_preview(preview.change, sent);
  }
  void operator()(const DropPreview& drop) const {
    message.mutable_preview()->set_edit_id(drop.edit_id);
    message.mutable_preview()->mutable_drop();
  }
  void operator()(const MoveBrush& move) const {
    v1::MoveBrush& sent = *message.mutable_move_brush();
    if (move.ring) *sent.mutable_ring() = burnish::to_wire(*move.ring);
  }
  void operator()(const Heartbeat& beat) const {
    message.mutable_heartbeat()->set_client_time_us(beat.client_time_us);
  }
  void operator()(const ShowPages& change) const {
    write_fields(change, *message.mutable_show_pages());
  }
};

Result<FrameCredit> read_credit(const v1::Credit& message) {
  const auto decoded = static_cast<size_t>(message.decoded_size());
  const auto refused = static_cast<size_t>(message.refused_size());
  if (decoded > kCreditNamesMax || refused > kCreditNamesMax)
    return invalid_argument("a credit names " + std::to_string(decoded) + " decoded and " +
                            std::to_string(refused) + " refused frames, the limit is " +
                            std::to_string(kCreditNamesMax));
  return read_record<FrameCredit>(message);
}

Result<Preview> read_preview(const v1::Preview& message) {
  ASSIGN_OR_RETURN(Edit edit, from_wire(message));
  return Preview{std::move(edit.id), *preview_of(std::move(edit.change))};
}

Result<MoveBrush> read_move_brush(const v1::MoveBrush& message) {
  if (!message.has_ring()) return MoveBrush{};
  ASSIGN_OR_RETURN(const BrushRing ring, from_wire(message.ring()));
  return MoveBrush{ring};
}

Result<ApplyEdits> read_apply(const v1::ApplyEdits& message) {
  ASSIGN_OR_RETURN(std::vector<Edit> edits, edits_from_wire(message));
  return ApplyEdits{std::move(edits)};
}

Result<ShowPages> read_show_pages(const v1::ShowPages& message) {
  const auto added = static_cast<size_t>(message.added_size());
  const auto removed = static_cast<size_t>(message.removed_size());
  if (added > kShownPagesMax || removed > kShownPagesMax)
    return invalid_argument("a change adds " + std::to_string(added) + " pages and removes " +
                            std::to_string(removed) + ", the limit is " +
                            std::to_string(kShownPagesMax));
  return read_record<ShowPages>(message);
}

v1::FrameKind kind_to_wire(PageFrameKind kind) {
  return kind == PageFrameKind::kVertices ? v1::FRAME_KIND_VERTICES : v1::FRAME_KIND_CORNERS;
}

/// Returns nothing for an unspecified kind. Fails: invalid_argument for an unknown one.
Result<std::optional<PageFrameKind>> kind_from_wire(v1::FrameKind kind) {
  using Kind = std::optional<PageFrameKind>;
  if (kind == v1::FRAME_KIND_UNSPECIFIED) return Kind();
  if (kind == v1::FRAME_KIND_CORNERS) return Kind(PageFrameKind::kCorners);
  if (kind == v1::FRAME_KIND_VERTICES) return Kind(PageFrameKind::kVertices);
  return invalid_argument("frame kind " + std::to_string(kind) +
                          " is none of 0 (whichever is smaller), 1 (corners), 2 (vertices)");
}

template <typename Part>
Result<ClientMessage> whole(Result<Part> part) {
  if (!part.is_ok()) return part.status();
  return ClientMessage(std::move(part).value());
}

}  // namespace

v1::Greeting to_wire(const Greeting& greeting) {
  v1::Greeting message;
  message.set_session(greeting.session);
  message.set_pages(true);
  message.set_held(greeting.knows_held);
  if (greeting.kind) message.set_kind(kind_to_wire(*greeting.kind));
  return message;
}

Result<Greeting> from_wire(const v1::Greeting& message) {
  if (!message.pages())
    return failed_precondition(
        "this server sends frames by pages, and the client does not say that it knows pages: a "
        "newer client is needed");
  ASSIGN_OR_RETURN(const auto kind, kind_from_wire(message.kind()));
  return Greeting{message.session(), kind, message.held()};
}

v1::ClientMessage to_wire(const ClientMessage& message) {
  v1::ClientMessage sent;
  std::visit(ClientWriter{sent}, message);
  return sent;
}

Result<ClientMessage> from_wire(const v1::ClientMessage& message) {
  switch (message.message_case()) {
    case v1::ClientMessage::kGreeting:
      return whole(from_wire(message.greeting()));
    case v1::ClientMessage::kCredit:
      return whole(read_credit(message.credit()));
    case v1::ClientMessage::kApply:
      return whole(read_apply(message.apply()));
    case v1::ClientMessage::kPreview:
      if (message.preview().has_drop())
        return ClientMessage(DropPreview{message.preview().edit_id()});
      return whole(read_preview(message.preview()));
    case v1::ClientMessage::kMoveBrush:
      return whole(read_move_brush(message.move_brush()));
    case v1::ClientMessage::kHeartbeat:
      return ClientMessage(Heartbeat{message.heartbeat().client_time_us()});
    case v1::ClientMessage::kShowPages:
      return whole(read_show_pages(message.show_pages()));
    case v1::ClientMessage::MESSAGE_NOT_SET:
      break;
  }
  return invalid_argument("the message says nothing that this server knows");
}

std::vector<std::string> refused_ids(const v1::ClientMessage& message) {
  std::vector<std::string> ids;
  const auto add = [&ids](const std::string& id) {
    if (ids.size() < kEditsPerFrameMax && id.size() <= kEditIdBytesMax) ids.push_back(id);
  };
  if (message.has_preview()) add(message.preview().edit_id());
  for (const v1::Edit& edit : message.apply().edits()) add(edit.id());
  return ids;
}

}  // namespace burnish
