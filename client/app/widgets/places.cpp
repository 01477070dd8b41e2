#include "client/app/widgets/places.h"

#include <fstream>
#include <utility>

namespace burnish {
namespace {

struct Places {
  std::filesystem::path file;  // empty: nobody asks
  std::string group;
  std::string noted, written;
};

Places& places() {
  static Places all;  // as ImGui's own state
  return all;
}

void note_box(const std::string& name, const ImVec2& low, const ImVec2& high) {
  const auto number = [](float value) { return std::to_string(static_cast<int>(value)) + " "; };
  places().noted +=
      number(low.x) + number(low.y) + number(high.x - low.x) + number(high.y - low.y) + name + "\n";
}

}  // namespace

void follow_places(std::filesystem::path file) {
  places().file = std::move(file);
}

void begin_place_group(const std::string& group) {
  places().group = group.empty() ? "" : group + "/";
}

void note_place(const std::string& name) {
  if (places().file.empty()) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  const ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 least = list.GetClipRectMin(), most = list.GetClipRectMax();
  if (middle.x < least.x || middle.x > most.x || middle.y < least.y || middle.y > most.y) return;
  note_box(places().group + name, low, high);
}

void note_area(const std::string& name, const ImVec2& low, const ImVec2& high) {
  if (!places().file.empty()) note_box("Area/" + name, low, high);
}

void note_window(const std::string& name) {
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const ImVec2 high{low.x + size.x, low.y + size.y};
  note_area(name, low, high);
  note_area(name + "/content", low,
            {high.x + ImGui::GetScrollMaxX(), high.y + ImGui::GetScrollMaxY()});
}

void write_places() {
  Places& all = places();
  const std::string now = std::exchange(all.noted, {});
  if (all.file.empty() || now == all.written) return;
  const std::filesystem::path part = all.file.string() + ".part";
  std::ofstream(part) << now;
  std::error_code ignored;
  std::filesystem::rename(part, all.file, ignored);
  all.written = now;
}

}  // namespace burnish
