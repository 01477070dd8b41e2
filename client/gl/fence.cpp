#include "client/gl/fence.h"

namespace burnish {

void Fence::put() {
  forget();
  sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

// A fence that fails, by a lost context for instance, holds nobody up.
bool Fence::is_reached() {
  if (sync_ == nullptr) return true;
  if (glClientWaitSync(sync_, GL_SYNC_FLUSH_COMMANDS_BIT, 0) == GL_TIMEOUT_EXPIRED) return false;
  forget();
  return true;
}

void Fence::forget() {
  if (sync_ != nullptr) glDeleteSync(sync_);
  sync_ = nullptr;
}

}  // namespace burnish
