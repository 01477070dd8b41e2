#pragma once

#include <filesystem>
#include <map>
#include <memory>

#include "client/app/widgets/panel.h"
#include "client/gl/gl_image.h"

namespace burnish {

/// The recent sessions as cards with pictures. A click opens one.
class SessionCards : public Panel {
 public:
  void draw(Workspace& workspace) override;

 private:
  const GlImage* picture_of(const std::filesystem::path& path);

  uint64_t pictures_begun_ = 0;  // pictures_ are read again when it rises
  std::map<std::filesystem::path, std::unique_ptr<GlImage>> pictures_;
};

}  // namespace burnish
