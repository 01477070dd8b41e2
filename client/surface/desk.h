#pragma once

#include <vector>

namespace burnish {

/// Does jobs beside the pictures: on a thread of its own (DeskThread), or where there are
/// no threads between two pictures (page_desk_alone.cpp) or by the browser (client/web/core/host).
/// Used from one thread.
template <typename Job, typename Done>
class Desk {
 public:
  Desk() = default;
  virtual ~Desk() = default;
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  virtual void put(Job job) = 0;
  /// Returns what is done since the last call.
  virtual std::vector<Done> take() = 0;
};

}  // namespace burnish
