#pragma once

#include <memory>
#include <optional>
#include <string>

#include "client/connection/connection.h"
#include "client/model/tasks/message_log.h"
#include "client/model/tasks/tasks.h"
#include "client/tools/ruler.h"
#include "common/measure/section.h"
#include "common/service/surface_measures.h"

namespace burnish {

/// Has the server measure for the window: the deviation of the whole surface, and a section. Asks
/// again after edits, once the surface has settled. Never waits. Used from one thread.
class Measuring {
 public:
  /// Needs: `tasks` and `log` outlive this.
  Measuring(std::shared_ptr<Connection> connection, std::string session, Tasks& tasks,
            MessageLog& log);

  /// The surface that the window shows.
  struct Shown {
    uint64_t edits = 0;
    bool is_settled = false;
  };

  /// Brings the deviation up to date. Call once per picture while it is shown.
  void follow_deviation(const Shown& shown);
  /// The newest deviation; nothing before the first answer.
  const std::optional<SessionDeviation>& deviation() const { return deviation_; }
  /// Whether the deviation is that of this surface, and not of one before.
  bool is_deviation_of(const Shown& shown) const {
    return deviation_ && !is_measuring_ && shown.is_settled && measured_edits_ == shown.edits;
  }

  /// Cuts the surface from now on.
  void cut(const Plane& plane);
  /// Brings the section up to date. Call once per picture while it is shown.
  void follow_section(const Shown& shown);
  const std::optional<Plane>& plane() const { return plane_; }
  /// The newest section of the plane; nothing before the first answer.
  const std::optional<Section>& section() const { return section_; }
  void forget_section();

  bool is_busy() const { return is_measuring_ || is_cutting_; }

  Ruler ruler;

 private:
  std::shared_ptr<Connection> connection_;
  std::string session_;
  Tasks& tasks_;
  MessageLog& log_;

  std::optional<SessionDeviation> deviation_;
  std::optional<uint64_t> measured_edits_;  // of the last question
  bool is_measuring_ = false;

  std::optional<Plane> plane_;
  std::optional<Section> section_;
  std::optional<uint64_t> cut_edits_;  // of the last question
  bool is_cutting_ = false;
  uint64_t cuts_ = 0;  // counts planes

  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  // completions may outlive us
};

}  // namespace burnish
