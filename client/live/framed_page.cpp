#include "client/live/framed_page.h"

#include <utility>

namespace burnish {

FramedPage frame_page(std::shared_ptr<const Page> page, const FrameTerms& terms) {
  FramedPage framed{.page = std::move(page), .shown = {}, .corners = {}};
  framed.shown.page = framed.page->id;
  if (terms.kind == PageFrameKind::kVertices) {
    framed.shown.layout = std::make_shared<const PageLayout>(make_vertex_page_layout(*framed.page));
    return framed;
  }
  framed.corners = std::make_shared<const PageCorners>(
      make_page_corners(framed.page->positions, terms.bits, terms.depth));
  framed.shown.layout =
      std::make_shared<const PageLayout>(make_corner_page_layout(*framed.corners));
  return framed;
}

std::shared_ptr<const PageMove> move_of(const FramedPage& framed, const PageTile& tile,
                                        const FrameTerms& terms) {
  auto move = std::make_shared<PageMove>();
  move->gain = tile.gain;
  std::vector<Vec3f>& of_vertices = move->displacements;
  of_vertices.resize(framed.page->positions.size());
  if (framed.corners) {
    std::vector<Vec3f> of_corners(tile.shown.value_count());
    tile.read_displacements(of_corners);
    evaluate_page(*framed.corners, framed.page->positions, terms.bits, terms.depth, of_corners,
                  of_vertices);
  } else {
    tile.read_displacements(of_vertices);
  }
  for_each_held(tile.held, [&](size_t vertex) { of_vertices[vertex].setZero(); });
  return move;
}

}  // namespace burnish
