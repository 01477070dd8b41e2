#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace burnish {

/// A client's connection to the gateway. Thread-safe.
class WebConnection {
 public:
  virtual ~WebConnection() = default;
  virtual void leave() = 0;  ///< closes it once no call runs
  virtual void close() = 0;  ///< closes it now
};

/// The connections of the gateway. Each holds a slot until its end. Thread-safe.
class WebConnections {
 public:
  /// A member of a connection.
  class Slot {
   public:
    explicit Slot(WebConnections& all) : all_(all) {}
    ~Slot() { all_.remove(this); }
    Slot(const Slot&) = delete;
    Slot& operator=(const Slot&) = delete;

    /// From now on leave() and close() reach the connection, also those that came before.
    void take(std::weak_ptr<WebConnection> connection);

   private:
    WebConnections& all_;
  };

  void leave();
  void close();
  void wait_until_empty();
  size_t count();

 private:
  std::vector<std::shared_ptr<WebConnection>> alive();  // needs the lock
  void remove(const Slot* slot);

  std::mutex mutex_;  // guards the following members
  std::condition_variable removed_;
  std::unordered_map<const Slot*, std::weak_ptr<WebConnection>> slots_;
  bool is_leaving_ = false;
  bool is_closing_ = false;
};

}  // namespace burnish
