#include "server/prepare/cell_pieces.h"

#include <algorithm>
#include <atomic>
#include <vector>

#include "common/base/heard_loop.h"
#include "common/base/parallel.h"
#include "server/prepare/cut_triangles.h"
#include "server/prepare/radix_sort.h"

namespace burnish {

namespace {

constexpr size_t kPiecesPerWrite = 4096;  // 64 KiB
constexpr double kDealtPart = 0.7;  // of the phase "grid", when the pieces are in their bricks

/// The bricks while pieces are dealt to them, in any order.
struct Dealing {
  const Bricks& bricks;
  int bucket_shift;
  std::vector<uint64_t> next;  // free place of each brick
  std::span<CellPiece> pieces;
};

/// Deals the pieces of one block. Keeps those that follow each other in one brick, and writes them
/// together.
class PieceDealer {
 public:
  explicit PieceDealer(Dealing& dealing) : dealing_(dealing) { waiting_.reserve(kPiecesPerWrite); }

  void add(const CellPiece& piece) {
    const uint32_t brick = dealing_.bricks.of_bucket[piece.cell >> dealing_.bucket_shift];
    if (brick != brick_ || waiting_.size() == kPiecesPerWrite) flush();
    brick_ = brick;
    waiting_.push_back(piece);
  }
  void flush() {
    if (waiting_.empty()) return;
    const uint64_t at = std::atomic_ref(dealing_.next[brick_]).fetch_add(waiting_.size());
    std::ranges::copy(waiting_, dealing_.pieces.begin() + static_cast<ptrdiff_t>(at));
    waiting_.clear();
  }

 private:
  Dealing& dealing_;
  uint32_t brick_ = 0;
  std::vector<CellPiece> waiting_;
};

void deal_pieces(const GridMesh& mesh, Dealing& dealing, const Progress& progress) {
  LoopProgress loop(progress, "grid", kCountedPart, kDealtPart);
  std::atomic<size_t> done{0};  // blocks
  const auto blocks = static_cast<double>(block_count(mesh));
  ParallelFailure failure;
  ask_before(loop);
#pragma omp parallel for schedule(dynamic)
  for (size_t block = 0; block < block_count(mesh); ++block)
    failure.run([&] {
      PieceDealer dealer(dealing);
      for_each_triangle_of_block(mesh, block, [&](const CutTriangle& triangle) {
        for_each_cell_with_passages(triangle.corners, triangle.columns,
                                    [&](const Vec3i& cell, Passages passages) {
                                      dealer.add({morton_key(cell), triangle.index, passages});
                                    });
        return loop.goes_on(static_cast<double>(done) / blocks);
      });
      dealer.flush();
      ++done;
    });
  failure.rethrow();
  leave_if_cancelled(loop);
}

// Threads have dealt the pieces of a cell in any order.
void order_by_triangle(std::span<CellPiece> pieces, const LoopPart& part) {
  const std::vector<size_t> starts = chunks_of_cells(pieces);
  LoopProgress loop(part.progress, part.phase, part.begin, part.end);
#pragma omp parallel for schedule(static)
  for (size_t chunk = 0; chunk < starts.size() - 1; ++chunk)
    for (size_t begin = starts[chunk]; begin < starts[chunk + 1] && loop.goes_on(0);) {
      const size_t end = end_of_cell(pieces, begin);
      const auto of_cell = pieces.subspan(begin, end - begin);
      if (!std::ranges::is_sorted(of_cell, {}, &CellPiece::triangle))
        std::ranges::sort(of_cell, {}, &CellPiece::triangle);
      begin = end;
    }
  leave_if_cancelled(loop);
}

uint64_t largest_brick(const Bricks& bricks) {
  uint64_t largest = 0;
  for (size_t brick = 0; brick < bricks.count(); ++brick)
    largest = std::max(largest, bricks.start[brick + 1] - bricks.start[brick]);
  return largest;
}

}  // namespace

Result<ScratchArray<CellPiece>> find_cell_pieces(const GridMesh& mesh, const PieceCount& count,
                                                 const PieceRoom& room, const Progress& progress) {
  const Bricks bricks = make_bricks(count, room.pieces_per_brick);
  ScratchArray<CellPiece> pieces(room.space, count.total());
  Dealing dealing{bricks, count.shift, bricks.start, {pieces.data(), pieces.size()}};
  deal_pieces(mesh, dealing, progress);
  ScratchArray<CellPiece> spare(room.space, largest_brick(bricks));
  for (size_t brick = 0; brick < bricks.count(); ++brick) {
    const double done = kDealtPart + (1 - kDealtPart) * static_cast<double>(brick) /
                                         static_cast<double>(bricks.count());
    if (!report(progress, "grid", done)) return cancelled("cancelled while cutting at the grid");
    const uint64_t begin = bricks.start[brick], size = bricks.start[brick + 1] - begin;
    const std::span<CellPiece> of_brick(pieces.data() + begin, size);
    radix_sort(of_brick, std::span(spare.data(), size), std::mem_fn(&CellPiece::cell),
               {progress, "grid", done, done});
    order_by_triangle(of_brick, {progress, "grid", done, done});
  }
  return pieces;
}

std::vector<size_t> chunks_of_cells(std::span<const CellPiece> pieces) {
  constexpr size_t kChunks = 64;
  std::vector<size_t> starts;
  for (size_t chunk = 0; chunk < kChunks; ++chunk) {
    size_t start = pieces.size() * chunk / kChunks;
    while (start > 0 && start < pieces.size() && pieces[start].cell == pieces[start - 1].cell)
      ++start;
    starts.push_back(start);
  }
  starts.push_back(pieces.size());
  return starts;
}

uint64_t count_cells(std::span<const CellPiece> pieces) {
  uint64_t cells = 0;
#pragma omp parallel for schedule(static) reduction(+ : cells)
  for (size_t i = 0; i < pieces.size(); ++i)
    cells += i == 0 || pieces[i].cell != pieces[i - 1].cell;
  return cells;
}

}  // namespace burnish
