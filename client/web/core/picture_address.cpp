#include "client/web/core/picture_address.h"

#include "client/web/core/stored_png.h"
#include "common/base/base64.h"

namespace burnish {

std::string picture_address(const Image& image) {
  return "data:image/png;base64," + base64(stored_png(image));
}

}  // namespace burnish
