#include "client/model/documents/measuring.h"

#include <utility>

namespace burnish {

Measuring::Measuring(std::shared_ptr<Connection> connection, std::string session, Tasks& tasks,
                     MessageLog& log)
    : connection_(std::move(connection)), session_(std::move(session)), tasks_(tasks), log_(log) {}

void Measuring::follow_deviation(const Shown& shown) {
  if (is_measuring_ || !shown.is_settled || measured_edits_ == shown.edits) return;
  is_measuring_ = true;
  measured_edits_ = shown.edits;
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = connection_,
                session = session_](StopToken) -> Tasks::Completion {
    connection->bring_back();
    const auto measured = connection->deviation(session);
    return [this, alive, measured] {
      if (alive.expired()) return;
      is_measuring_ = false;
      if (!measured.is_ok()) return log_.failure("deviation", measured.status());
      deviation_ = *measured;
    };
  });
}

void Measuring::cut(const Plane& plane) {
  forget_section();
  plane_ = plane;
}

void Measuring::forget_section() {
  plane_.reset();
  section_.reset();
  cut_edits_.reset();
  ++cuts_;
}

void Measuring::follow_section(const Shown& shown) {
  const bool is_first = !cut_edits_;
  if (!plane_ || is_cutting_ || cut_edits_ == shown.edits) return;
  if (!is_first && !shown.is_settled) return;
  is_cutting_ = true;
  cut_edits_ = shown.is_settled ? std::optional(shown.edits) : std::optional<uint64_t>(0);
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = connection_, cut = cuts_,
                wish = SectionWish{session_, *plane_}](StopToken) -> Tasks::Completion {
    connection->bring_back();
    const auto section = connection->section(wish);
    return [this, alive, cut, section] {
      if (alive.expired()) return;
      is_cutting_ = false;
      if (cut != cuts_) return;  // of another plane
      if (!section.is_ok()) return log_.failure("section", section.status());
      section_ = *section;
    };
  });
}

}  // namespace burnish
