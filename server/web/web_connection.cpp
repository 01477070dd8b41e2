#include "server/web/web_connection.h"

namespace burnish {

void WebConnections::Slot::take(std::weak_ptr<WebConnection> connection) {
  std::unique_lock lock(all_.mutex_);
  all_.slots_[this] = connection;
  const bool is_leaving = all_.is_leaving_, is_closing = all_.is_closing_;
  lock.unlock();
  const auto alive = connection.lock();
  if (is_leaving) alive->leave();
  if (is_closing) alive->close();
}

void WebConnections::leave() {
  std::unique_lock lock(mutex_);
  is_leaving_ = true;
  const auto connections = alive();
  lock.unlock();
  for (const auto& connection : connections) connection->leave();
}

void WebConnections::close() {
  std::unique_lock lock(mutex_);
  is_closing_ = true;
  const auto connections = alive();
  lock.unlock();
  for (const auto& connection : connections) connection->close();
}

void WebConnections::wait_until_empty() {
  std::unique_lock lock(mutex_);
  removed_.wait(lock, [this] { return slots_.empty(); });
}

size_t WebConnections::count() {
  const std::lock_guard lock(mutex_);
  return slots_.size();
}

std::vector<std::shared_ptr<WebConnection>> WebConnections::alive() {
  std::vector<std::shared_ptr<WebConnection>> connections;
  for (const auto& [slot, connection] : slots_)
    if (auto held = connection.lock()) connections.push_back(std::move(held));
  return connections;
}

void WebConnections::remove(const Slot* slot) {
  const std::lock_guard lock(mutex_);
  slots_.erase(slot);
  removed_.notify_all();
}

}  // namespace burnish
