#pragma once

#include <memory>
#include <optional>
#include <string>

#include "client/connection/connection.h"
#include "client/model/tasks/message_log.h"
#include "client/model/tasks/tasks.h"
#include "common/edit/proposed_edges.h"

namespace burnish {

/// Has the server measure a scan's noise for the window, once. Never waits. Used from one thread.
class ScanNoise {
 public:
  /// Needs: `tasks` and `log` outlive this.
  ScanNoise(std::shared_ptr<Connection> connection, std::string scan, Tasks& tasks,
            MessageLog& log);

  /// Asks unless the answer is known or on its way. The log has a failure, and the next call asks
  /// again.
  void ask();
  bool is_asking() const { return is_asking_; }
  /// The answer; nothing before it.
  const std::optional<EdgeProposal>& proposal() const { return proposal_; }

 private:
  std::shared_ptr<Connection> connection_;
  std::string scan_;
  Tasks& tasks_;
  MessageLog& log_;
  bool is_asking_ = false;
  std::optional<EdgeProposal> proposal_;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  // completions may outlive us
};

}  // namespace burnish
