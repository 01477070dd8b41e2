#pragma once

#include "burnish/v1/editing.pb.h"
#include "common/service/session_history.h"
#include "common/service/session_people.h"

namespace burnish {

v1::GetHistoryRequest to_wire(const HistoryWish& wish);
/// Fails: invalid_argument for a count above its limit.
Result<HistoryWish> from_wire(const v1::GetHistoryRequest& message);

v1::GetHistoryResponse to_wire(const HistoryPage& page);
/// Fails: invalid_argument for an entry of an unknown kind.
Result<HistoryPage> from_wire(const v1::GetHistoryResponse& message);

v1::ForkSessionRequest to_wire(const ForkWish& wish);
/// Fails: invalid_argument naming the field, its value and its limit.
Result<ForkWish> from_wire(const v1::ForkSessionRequest& message);

v1::Role to_wire(SessionRole role);
/// Fails: invalid_argument.
Result<SessionRole> from_wire(v1::Role role);

v1::People to_wire(const SessionPeople& people);
Result<SessionPeople> from_wire(const v1::People& message);

v1::PresentUser to_wire(const PresentUser& user);
PresentUser from_wire(const v1::PresentUser& message);

v1::BrushRing to_wire(const BrushRing& ring);
/// Fails: invalid_argument for a ring that is not finite or has no radius.
Result<BrushRing> from_wire(const v1::BrushRing& message);

}  // namespace burnish
