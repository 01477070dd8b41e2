#pragma once

#include <filesystem>
#include <imgui.h>
#include <string>

namespace burnish {

/// The places of widgets on the screen. Tests and the pictures of the documents use the real window
/// by them. Nothing is noted until somebody asks. Used from the window's thread.

/// Asks for the places in a file, with a line "X Y WIDTH HEIGHT NAME" for each, in pixels.
void follow_places(std::filesystem::path file);

/// Puts "GROUP/" before the names that come. Empty: nothing.
void begin_place_group(const std::string& group);

/// Notes the last ImGui item, if its middle is visible.
void note_place(const std::string& name);

/// Does the same and returns `result`: noted("Undo", ImGui::Button("Undo")).
inline bool noted(const std::string& name, bool result) {
  note_place(name);
  return result;
}

/// Notes an area as "Area/NAME".
void note_area(const std::string& name, const ImVec2& low, const ImVec2& high);

/// Notes the present ImGui window as an area, and what it holds as "Area/NAME/content": it is wider
/// where something does not fit. Call it before the window ends.
void note_window(const std::string& name);

/// Writes what was noted since the last call, if it is news. Call it once per picture.
void write_places();

}  // namespace burnish
