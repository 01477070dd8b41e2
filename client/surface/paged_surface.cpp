#include "client/surface/paged_surface.h"

#include <algorithm>
#include <cmath>

#include "common/pages/directory_codec.h"

namespace burnish {

/// Bytes that a value takes in a frame before compression while a surface moves; an estimate.
static constexpr double kBytesPerVertexMoving = 1.2;
/// The same of a page that a frame carries for the first time.
static constexpr double kBytesPerVertexNew = 3;
/// New pages that are on their way at once, in frames of FrameBudget: 20 ms of the link while the
/// surface moves, and 100 ms while nothing waits for the next frame.
static constexpr double kNewFramesMoving = 2, kNewFramesStill = 10;

Result<OpenedPages> open_pages(const PagesDescription& description, const std::string& scan) {
  OpenedPages pages;
  pages.scan = scan;
  ASSIGN_OR_RETURN(pages.head, decode_head(description.head));
  pages.fingerprint = pages_fingerprint(description.head);
  for (const PagePart& part : description.blocks) {
    ASSIGN_OR_RETURN(DirectoryBlock block, decode_block(part.bytes, pages.head, part.number));
    pages.blocks.emplace_back(part.number, std::move(block));
  }
  return pages;
}

PagedSurface::PagedSurface(OpenedPages pages, int depth, std::unique_ptr<PageSource> source,
                           LiveLink& link, SurfaceOptions options)
    : pages_(std::move(pages)),
      link_(link),
      options_(std::move(options)),
      cell_size_(std::ldexp(pages_.head.grid.side, -depth)),
      tint_(pages_.head.grid, depth),
      marks_(tint_),
      card_(pages_.head.grid, depth),
      source_(std::move(source)),
      decoder_(pages_.head, options_.on_news) {}

Status PagedSurface::open(PageRenderer& renderer) {
  texture_bytes_max_ = renderer.texture_bytes_max();
  PageBudget budget = options_.budget;
  const uint32_t pages = pages_.head.page_count();
  const auto slots = static_cast<uint32_t>(std::min<uint64_t>(budget.slots(), pages));
  ASSIGN_OR_RETURN(const uint32_t room, card_.open(renderer, slots));
  // A cut leaves some of its slots free. Where all pages fit, these need not be there.
  const auto slots_for_all = static_cast<uint64_t>(pages / kBudgetAim) + 1;
  budget.card_bytes = (room < pages ? room : slots_for_all) * kSlotBytes;
  loader_ = std::make_unique<PageLoader>(pages_.head, budget, options_.is_software);
  for (auto& [number, block] : pages_.blocks)
    loader_->on_block(number, std::move(block), options_.clock());
  pages_.blocks.clear();
  return Status::ok();
}

void PagedSurface::take(const LiveNews& news) {
  if (news.pages_refused > refusals_) room_.refuse(shown_.vertex_count(), options_.clock());
  refusals_ = news.pages_refused;
  stats_ = news.stats;
  frame_ = news.frame;
}

Status PagedSurface::look(const Camera& camera, const ImageSize& size, bool is_dragging) {
  take_arrivals();
  shown_.show_gains(shows_textures());
  server_vertices_max_ = room_.vertices_max(options_.clock()) / shown_.copies();
  loader_->look(question(camera, size, is_dragging), options_.clock());
  start_decoding();
  ask_for_items();
  RETURN_IF_ERROR(put_on_card());
  RETURN_IF_ERROR(show_pages());
  return frame_ ? show_frame() : Status::ok();
}

Status PagedSurface::show_frame() {
  const std::vector<DrawnRange> drawn = drawn_ranges(loader_->cut(), loader_->cache());
  ASSIGN_OR_RETURN(const bool is_changed, card_.show(drawn, *frame_, marks_));
  changes_ += is_changed;
  return shows_textures() ? show_textures(drawn) : Status::ok();
}

// Asks for the sheets of this picture, and shows those that are here.
Status PagedSurface::show_textures(std::span<const DrawnRange> drawn) {
  std::vector<PageId> pages;  // the ranges of a page follow each other
  for (const DrawnRange& range : drawn)
    if (pages.empty() || pages.back() != range.page) pages.push_back(range.page);
  const auto now = options_.clock();
  textures_->take_decoded(now);
  const PageRequests::Plan& plan = textures_->look(*loader_, pages, source_->speed(), now);
  source_->cancel(plan.cancel);
  source_->ask(plan.ask);
  if (textures_->is_settled()) last_textures_.reset();
  ASSIGN_OR_RETURN(const bool is_changed,
                   card_.show_textures([this](PageId page) { return texture(page); }));
  changes_ += is_changed;
  return Status::ok();
}

std::shared_ptr<const PageTexture> PagedSurface::texture(PageId page) const {
  auto texture = textures_->texture(page);
  return texture || !last_textures_ ? texture : last_textures_->texture(page);
}

void PagedSurface::set_textures(std::unique_ptr<TextureSupply> textures) {
  if (textures_) source_->cancel(textures_->in_flight());
  if (textures_ && (textures_->is_settled() || !last_textures_))
    last_textures_ = std::move(textures_);
  textures_ = std::move(textures);
  lacks_sheets_ = false;  // of the last ones
}

// A server that finds a page damaged drops them all, and has none until somebody describes them.
static bool is_damage(StatusCode code) {
  return code == StatusCode::kDataLoss || code == StatusCode::kFailedPrecondition;
}

void PagedSurface::take_sheet_arrival(PageSource::Arrival arrival) {
  if (!textures_ || arrival.item.version != textures_->version()) return;
  lacks_sheets_ |= !arrival.bytes.is_ok() && is_damage(arrival.bytes.status().code());
  textures_->on_arrival(std::move(arrival), options_.clock());
}

void PagedSurface::on_link_made() {
  loader_->on_link_made();
  if (textures_) textures_->on_link_made();
}

void PagedSurface::take_arrivals() {
  const auto now = options_.clock();
  for (PageSource::Arrival& arrival : source_->take()) {
    if (arrival.item.is_of_sheets()) {
      take_sheet_arrival(std::move(arrival));
    } else if (arrival.item.kind == PageItem::Kind::kBlock && arrival.bytes.is_ok()) {
      hand_in_block(arrival.item.number, std::move(arrival.bytes));
    } else if (arrival.bytes.is_ok()) {
      loader_->on_page(arrival.item.number, std::move(*arrival.bytes), now);
    } else {
      if (is_damage(arrival.bytes.status().code())) damage_ = arrival.bytes.status();
      loader_->on_failure(arrival.item, arrival.bytes.status(), now);
    }
  }
  for (DecodedPage& decoded : decoder_.take()) {
    if (decoded.page.is_ok()) meshes_[decoded.id] = std::move(decoded.mesh);
    loader_->on_decoded(decoded.id, std::move(decoded.page), now);
  }
}

void PagedSurface::hand_in_block(uint32_t number, Result<std::vector<uint8_t>> bytes) {
  loader_->on_block(number, decode_block(*bytes, pages_.head, number), options_.clock());
}

PictureQuestion PagedSurface::question(const Camera& camera, const ImageSize& size,
                                       bool is_dragging) const {
  PictureQuestion asked;
  asked.view = make_page_view(camera, size, pages_.head.grid);
  asked.frame = frame_bounds();
  asked.surface_moves = moves(is_dragging);
  asked.frame_vertices_max = static_cast<uint64_t>(stats_.frame_bytes_max / kBytesPerVertexMoving);
  asked.server_vertices_max = server_vertices_max_;
  asked.has_values = [frame = frame_.get()](PageId page) {
    return frame != nullptr && frame->find(page) != nullptr;
  };
  asked.moving_triangles_max = pace_.triangles_max();
  asked.link = source_->speed();
  asked.rests_early = shows_textures() && is_unlit_;
  return asked;
}

FrameBounds PagedSurface::frame_bounds() const {
  if (!frame_) return {};
  uint8_t gain = 0;
  for (const auto& move : frame_->moves) gain = std::max(gain, move->gain);
  return {static_cast<float>(frame_->largest_move * cell_size_), std::ldexp(1.0f, gain)};
}

// A dab moves few pages, and the server has no need to round them: the fine cut stays.
bool PagedSurface::moves(bool is_dragging) const {
  return is_dragging || (frame_ && !stats_.frame.settled && !frame_->is_exact);
}

void PagedSurface::start_decoding() {
  for (const PageId page : loader_->to_decode()) {
    if (!decoder_.has_room()) return;
    if (!decoder_.has(page)) decoder_.decode(page, loader_->bytes_of(page));
  }
}

void PagedSurface::ask_for_items() {
  const PageRequests::Plan& plan = loader_->requests();
  source_->cancel(plan.cancel);
  source_->ask(plan.ask);
}

Status PagedSurface::put_on_card() {
  const auto uploads = loader_->take_uploads();
  for (const PageUpload& each : uploads) {
    auto ready = meshes_.extract(each.page);
    PageMesh mesh =
        ready ? std::move(ready.mapped()) : make_page_mesh(*each.content, pages_.head.grid);
    RETURN_IF_ERROR(card_.put(each.slot, *each.content, std::move(mesh)));
  }
  changes_ += !uploads.empty();
  std::erase_if(meshes_, [this](const auto& mesh) {  // the cache had no room for them
    return loader_->cache().state_of(mesh.first) < PageState::kDecoded;
  });
  return Status::ok();
}

uint64_t PagedSurface::vertices_in_flight_max() const {
  const double frames = stats_.frame.settled ? kNewFramesStill : kNewFramesMoving;
  return static_cast<uint64_t>(frames * stats_.frame_bytes_max / kBytesPerVertexNew);
}

Status PagedSurface::show_pages() {
  ShownSet::Change change =
      shown_.change(loader_->cut(), loader_->cache(), frame_.get(), vertices_in_flight_max(),
                    server_vertices_max_ * shown_.copies());
  if (change.is_empty()) return Status::ok();
  return link_.show_pages(std::move(change.added), std::move(change.removed));
}

std::optional<SurfaceHit> PagedSurface::hit_at(const Camera& camera, const ImageSize& size,
                                               const Eigen::Vector2i& pixel, bool original) const {
  const Ray ray = pixel_ray(camera, size, pixel.cast<double>() + Eigen::Vector2d(0.5, 0.5));
  return card_.hit(ray, original);
}

std::optional<size_t> PagedSurface::vertex_count(PageId page) const {
  const CachedPage* cached = loader_->cache().find(page);
  if (cached == nullptr || cached->page == nullptr) return std::nullopt;
  return cached->page->positions.size();
}

bool PagedSurface::is_settled() const {
  return frame_ != nullptr && loader_->is_settled() &&
         (!shows_textures() || textures_->is_settled());
}

std::string PagedSurface::take_failures() {
  const std::vector<GivenUpItem> items = loader_->take_given_up();
  if (items.empty()) return textures_ ? textures_->take_failures() : std::string();
  return std::to_string(items.size()) +
         " pieces of the surface could not be fetched: " + items.front().last_failure.message();
}

}  // namespace burnish
