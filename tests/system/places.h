#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "tests/system/sheet.h"

namespace burnish {

/// The places of a window's widgets, as `burnish window --places FILE` writes them.
class Places {
 public:
  explicit Places(std::filesystem::path file) : file_(std::move(file)) {}

  /// Returns the widget's place on the screen; nothing if it is not there now. Names: "Menu/File",
  /// "Filter/Presets", "Brush/Radius as a number".
  std::optional<Box> find(const std::string& name) const;
  /// Returns all, by name.
  std::map<std::string, Box> all() const;

  /// Waits until the widget is there and rests. Needs: it comes within kPatience.
  Box wait_for(const std::string& name) const;

 private:
  std::filesystem::path file_;
};

}  // namespace burnish
