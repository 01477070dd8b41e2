#pragma once

#include <epoxy/gl.h>

namespace burnish {

/// Tells whether the card has done what it was told to do. Needs: the context is current and
/// outlives this object.
class Fence {
 public:
  Fence() = default;
  ~Fence() { forget(); }
  Fence(const Fence&) = delete;
  Fence& operator=(const Fence&) = delete;

  /// Stands behind all commands so far, in place of where it stood.
  void put();
  /// Returns whether the card has come to it; true before the first put(). Never waits.
  bool is_reached();

 private:
  void forget();

  GLsync sync_ = nullptr;
};

}  // namespace burnish
