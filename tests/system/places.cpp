#include "tests/system/places.h"

#include <fstream>
#include <thread>

#include "common/base/check.h"
#include "tests/system/server_process.h"

namespace burnish {

std::optional<Box> Places::find(const std::string& name) const {
  const auto places = all();
  const auto found = places.find(name);
  return found == places.end() ? std::nullopt : std::optional(found->second);
}

std::map<std::string, Box> Places::all() const {
  std::map<std::string, Box> places;
  std::ifstream lines(file_);
  Box box;
  std::string name;
  while (lines >> box.x >> box.y >> box.width >> box.height && std::getline(lines >> std::ws, name))
    places.try_emplace(name, box);
  return places;
}

Box Places::wait_for(const std::string& name) const {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  std::optional<Box> last;
  while (std::chrono::steady_clock::now() < deadline) {
    const std::optional<Box> now = find(name);
    if (now && last && now->x == last->x && now->y == last->y) return *now;
    last = now;
    // The window is another process and says nothing when its widgets rest.
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  BURNISH_CHECK(false, "no widget " + name);
  return {};
}

}  // namespace burnish
