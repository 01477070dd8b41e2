#pragma once

#include <memory>
#include <random>
#include <vector>

#include "common/frame_codec/frame_layout.h"
#include "common/frame_codec/frame_sample.h"
#include "common/frame_codec/frame_state.h"

namespace burnish {

/// A generated scan in a grid of the cells that hold its vertices: enough for frames.
struct SmallScan {
  TriangleMesh mesh;
  GridFrame frame;
  SparseGrid grid;
  std::vector<EvaluationPoint> points;

  FrameMesh frame_mesh() const { return {grid, points}; }
};

/// Returns a lumpy sphere of about five tiles of coefficients and three of vertices.
const SmallScan& small_scan();

std::shared_ptr<const FrameLayout> small_layout(FrameContent content);

/// Returns a displacement that is smooth over the grid, with a little noise. Units: cells.
std::vector<Vec3d> wavy_displacement(const SparseGrid& grid, double amplitude, double phase);

FrameSample sample_of(const FrameLayout& layout, std::span<const Vec3d> displacement);

/// Returns all values of a state, in the order of a sample.
std::vector<int32_t> steps_of(const FrameLayout& layout, const FrameState& state);

/// Makes random small changes in some tiles, sometimes a large one.
void change_some_tiles(const FrameLayout& layout, std::mt19937& random, FrameSample& sample);

}  // namespace burnish
