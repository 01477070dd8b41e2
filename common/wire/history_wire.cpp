#include "common/wire/history_wire.h"

#include <utility>

#include "common/base/text.h"
#include "common/wire/format_wire.h"

namespace burnish {

// Older clients refuse kinds that they do not know.
static v1::EntryKind kind_for_older(v1::EntryKind kind) {
  return kind <= v1::ENTRY_KIND_DAMAGED ? kind : v1::ENTRY_KIND_CELL_FIELDS;
}

// A newer server may have kinds that this program does not know; `kind` is as near as it gets.
static Result<EditKind> kind_from_wire(const v1::HistoryEntry& message) {
  if (const auto exact = kind_of_entry(message.exact_kind())) return *exact;
  if (const auto kind = kind_of_entry(message.kind())) return *kind;
  return invalid_argument("history entries of kind " + std::to_string(message.kind()) +
                          " are not known to this program");
}

v1::GetHistoryRequest to_wire(const HistoryWish& wish) {
  v1::GetHistoryRequest message;
  write_fields(wish, message);
  return message;
}

Result<HistoryWish> from_wire(const v1::GetHistoryRequest& message) {
  if (message.count() > kHistoryPageEntriesMax)
    return invalid_argument("a page of " + std::to_string(message.count()) +
                            " history entries is above the limit of " +
                            std::to_string(kHistoryPageEntriesMax));
  return HistoryWish{message.session(), message.after(),
                     message.count() == 0 ? kHistoryPageEntriesMax : message.count()};
}

v1::GetHistoryResponse to_wire(const HistoryPage& page) {
  v1::GetHistoryResponse message;
  for (const HistoryEntry& entry : page.entries) {
    v1::HistoryEntry* added = message.add_entries();
    write_fields(entry, *added);
    added->set_exact_kind(static_cast<v1::EntryKind>(entry_number(entry.kind)));
    added->set_kind(kind_for_older(added->exact_kind()));
  }
  message.set_complete(page.complete);
  return message;
}

Result<HistoryPage> from_wire(const v1::GetHistoryResponse& message) {
  HistoryPage page;
  for (const v1::HistoryEntry& entry : message.entries()) {
    HistoryEntry& read = page.entries.emplace_back();
    read_fields(entry, read);
    ASSIGN_OR_RETURN(read.kind, kind_from_wire(entry));
  }
  page.complete = message.complete();
  return page;
}

v1::ForkSessionRequest to_wire(const ForkWish& wish) {
  v1::ForkSessionRequest message;
  message.set_session(wish.source);
  message.set_name(wish.name);
  if (!wish.checkpoint.empty()) {
    message.set_checkpoint(wish.checkpoint);
  } else if (wish.number > 0) {
    message.set_number(wish.number);
  }
  message.set_depth(static_cast<uint32_t>(wish.depth));
  return message;
}

Result<ForkWish> from_wire(const v1::ForkSessionRequest& message) {
  if (!message.name().empty()) RETURN_IF_ERROR(check_name("the session's name", message.name()));
  if (message.has_number() && message.number() == 0)
    return invalid_argument("edits are numbered from 1: a fork up to number 0 would be empty");
  if (message.has_checkpoint())
    RETURN_IF_ERROR(check_name("the checkpoint's name", message.checkpoint()));
  ASSIGN_OR_RETURN(const PreparedKey key,
                   prepared_key_from_wire(static_cast<int>(message.depth()), 0));
  return ForkWish{message.session(), message.name(), message.number(), message.checkpoint(),
                  key.depth};
}

v1::Role to_wire(SessionRole role) {
  return static_cast<v1::Role>(role);  // the same numbers, see below
}

static_assert(static_cast<int>(SessionRole::kViewer) == v1::ROLE_VIEWER &&
              static_cast<int>(SessionRole::kEditor) == v1::ROLE_EDITOR &&
              static_cast<int>(SessionRole::kOwner) == v1::ROLE_OWNER);

Result<SessionRole> from_wire(v1::Role role) {
  if (role >= v1::ROLE_VIEWER && role <= v1::ROLE_OWNER) return static_cast<SessionRole>(role);
  return invalid_argument("role " + std::to_string(role) +
                          " is none of 1 (viewer), 2 (editor), 3 (owner)");
}

v1::BrushRing to_wire(const BrushRing& ring) {
  v1::BrushRing message;
  *message.mutable_centre() = to_wire(ring.centre);
  message.set_radius(ring.radius);
  return message;
}

v1::PresentUser to_wire(const PresentUser& user) {
  v1::PresentUser message;
  write_fields(user, message);
  if (user.ring) *message.mutable_ring() = to_wire(*user.ring);
  return message;
}

PresentUser from_wire(const v1::PresentUser& message) {
  auto user = read_record<PresentUser>(message);
  if (message.has_ring())
    user.ring = BrushRing{from_wire(message.ring().centre()), message.ring().radius()};
  return user;
}

Result<BrushRing> from_wire(const v1::BrushRing& message) {
  const BrushRing ring{from_wire(message.centre()), message.radius()};
  if ((ring.centre.array().abs() <= kCoordinateMagnitudeMax).all() && ring.radius > 0 &&
      ring.radius <= kCoordinateMagnitudeMax)
    return ring;
  return invalid_argument("the brush's ring of radius " + shortest_text(ring.radius) +
                          " has a centre or a radius that is not finite and within 1e18");
}

v1::People to_wire(const SessionPeople& people) {
  v1::People message;
  for (const auto& [user, role] : people.roles.by_user()) {
    v1::UserRole* added = message.add_roles();
    added->set_user(user);
    added->set_role(to_wire(role));
  }
  for (const PresentUser& user : people.present) *message.add_present() = to_wire(user);
  return message;
}

Result<SessionPeople> from_wire(const v1::People& message) {
  std::map<std::string, SessionRole> roles;
  for (const v1::UserRole& entry : message.roles()) {
    ASSIGN_OR_RETURN(roles[entry.user()], from_wire(entry.role()));
  }
  SessionPeople people{SessionRoles(std::move(roles)), {}};
  for (const v1::PresentUser& user : message.present()) people.present.push_back(from_wire(user));
  return people;
}

}  // namespace burnish
