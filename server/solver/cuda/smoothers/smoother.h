#pragma once

#include <memory>
#include <string>
#include <vector>

#include "server/solver/cuda/device/named_bits.h"
#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/cycle/smoother_names.h"

namespace burnish {
struct HierarchyDepth;
}

namespace burnish::cuda {
class Halo;
}

namespace burnish::cuda {

/// Relaxes one depth. relax() is the transpose of relax_from_zero(), so the V-cycle stays
/// symmetric. One object serves one depth.
class DepthSmoother {
 public:
  virtual ~DepthSmoother() = default;

  /// Returns the stream of set_up(). Until finish_set_up() it runs next to the main stream. Its
  /// work comes after all earlier work of the main stream.
  virtual Stream& fork() = 0;
  virtual Stream& beside() = 0;  ///< the same stream without a fork: after its earlier work
  /// Returns the vector whose product with S assemble() leaves in r for set_up(); null for none.
  virtual const float4* probe() const { return nullptr; }
  /// Call after a new matrix. Changes r, and the first time f too. `inverses` is working memory;
  /// `anisotropy` is the largest ratio of α1 to α2, or α2 to α1, in any cell, on the device.
  virtual void set_up(const CellSquares<float>& inverses, const float* anisotropy) = 0;
  /// Call instead after a local new metric: makes what depends on the touched rows of S alone.
  /// Needs: set_up() before. It may make all anew.
  virtual void update(const CellSquares<float>& inverses, const float* anisotropy,
                      const Touched& touched) {
    (void)touched;
    set_up(inverses, anisotropy);
  }
  virtual void finish_set_up() = 0;

  /// Regularises by the size of the blocks in the next set_up(), so that none can fail; or as
  /// usual again.
  virtual void be_careful(bool careful) { (void)careful; }
  virtual void start_over() {}  ///< forgets what earlier matrices taught it

  virtual void relax_from_zero() = 0;  ///< x from zero
  virtual void relax() = 0;            ///< continues from x
  virtual uint64_t byte_count() const = 0;
  /// Appends what set_up() makes, as far as update() may leave parts of it.
  virtual void read(const std::string& name, std::vector<NamedBits>& to) {
    (void)name;
    (void)to;
  }
};

/// `halo`: to the other shards, for kSchwarz alone; null if the depth is whole. Needs: `kind` is
/// one of kCudaSmoothers.
std::unique_ptr<DepthSmoother> make_smoother(Smoother kind, Stream& stream,
                                             const HierarchyDepth& topology, const Depth& depth,
                                             bool needs_all_digits, Halo* halo);

}  // namespace burnish::cuda
