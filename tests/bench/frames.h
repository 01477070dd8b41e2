#pragma once

#include "common/edit/transfer_curve.h"
#include "server/session/session.h"

namespace burnish {

/// Milliseconds of one frame in each state of the system (section 7.2, Table 1), medians.
struct FrameTimes {
  double solve = 0;      ///< no edit: one cycle
  double rhs = 0;        ///< a new β: constraint and one cycle
  double dab = 0;        ///< a new β in a small ball: constraint of what it touches and one cycle
  double matrix = 0;     ///< a new curve: matrices, constraint and one cycle
  double evaluate = 0;   ///< all vertices, if the client does not do it
  double gigahertz = 0;  ///< clock of the cores: the lowest core_gigahertz() between the states
};

/// Leaves the session with `curve` and β near 0.
FrameTimes measure_frames(Session& session, const TransferCurve& curve);

/// Applies a change that must succeed.
template <typename Change>
void must_apply(Session& session, Change change) {
  const Status status = session.apply({"", std::move(change)});
  BURNISH_CHECK(status.is_ok(), status.message());
}

}  // namespace burnish
