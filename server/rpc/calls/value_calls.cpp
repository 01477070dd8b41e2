#include "server/rpc/calls/value_calls.h"

#include <algorithm>
#include <vector>

#include "common/transfer/chunk.h"
#include "common/wire/format_wire.h"
#include "common/wire/page_values_wire.h"
#include "common/wire/session_wire.h"
#include "server/manager/cell_values.h"
#include "server/manager/page_values.h"

namespace burnish {

void GetCellsCall::begin() {
  post([](GetCellsCall& call) {
    const Status status = call.take_values();
    if (!status.is_ok()) return call.end(status);
    call.send_next();
  });
}

Status GetCellsCall::take_values() {
  ASSIGN_OR_RETURN(const CellValue value, from_wire(request_.value()));
  const auto take = [&](Session& session) {
    values_ = cell_values(session, value);
    return Status::ok();
  };
  return calls_.sessions.visit(request_.session(), calls_.caller, take, silent_progress());
}

void GetCellsCall::OnWriteDone(bool ok) {
  events_.on_write_done(ok);
  if (!ok) return end(cancelled("the client has gone"));
  run_guarded([this] { send_next(); }, [this](const Status& status) { end(status); });
}

void GetCellsCall::send_next() {
  const std::string_view all(reinterpret_cast<const char*>(values_.data()),
                             values_.size() * sizeof(float));
  const std::string_view piece = all.substr(sent_bytes_, kChunkBytes);
  if (piece.empty()) return events_.close(grpc::Status::OK);
  v1::Chunk chunk;
  set_chunk(sent_bytes_, piece, chunk);
  sent_bytes_ += piece.size();
  events_.push(std::move(chunk));
}

static constexpr size_t kPagesAtATime = 64;

void GetPageValuesCall::begin() {
  send(&GetPageValuesCall::send_first);
}

void GetPageValuesCall::send(Status (GetPageValuesCall::*work)()) {
  post([work](GetPageValuesCall& call) {
    const Status status = (call.*work)();
    if (!status.is_ok()) call.end(status);
  });
}

static Status check_pages(std::span<const PageId> pages, uint32_t count) {
  for (const PageId page : pages)
    if (page >= count)
      return invalid_argument("page " + std::to_string(page) + " is outside 0.." +
                              std::to_string(count - 1));
  std::vector<PageId> rising(pages.begin(), pages.end());
  std::ranges::sort(rising);
  const auto twice = std::ranges::adjacent_find(rising);
  if (twice == rising.end()) return Status::ok();
  return invalid_argument("page " + std::to_string(*twice) + " is named twice");
}

Status GetPageValuesCall::send_first() {
  ASSIGN_OR_RETURN(PageValuesWish wish, from_wire(request_));
  ASSIGN_OR_RETURN(const SessionManager::Attached attached,
                   calls_.sessions.attach(wish.session, calls_.caller, silent_progress()));
  ASSIGN_OR_RETURN(scan_, calls_.store.find_pages(attached.info.scan_id));
  RETURN_IF_ERROR(check_pages(wish.pages, scan_->file.directory().head.page_count()));
  const auto take = [&](Session& session) {
    values_ = cell_values(session, wish.value);
    return Status::ok();
  };
  RETURN_IF_ERROR(calls_.sessions.visit(attached.info.id, calls_.caller, take, silent_progress()));
  mesh_ = attached.mesh;
  pages_ = std::move(wish.pages);
  return send_some();
}

Status GetPageValuesCall::send_some() {
  const SparseGrid& grid = mesh_->hierarchy->at(mesh_->hierarchy->finest).grid;
  const int bits = scan_->file.directory().head.grid.bits;
  const auto next = std::span(pages_).subspan(sent_);
  std::vector<v1::PageValues> events;
  for (const PageId number : next.first(std::min(next.size(), kPagesAtATime))) {
    if (cancelled_) return cancelled("the client has gone");
    ASSIGN_OR_RETURN(const Page page, calls_.store.read_page(*scan_, number));
    events.push_back(to_wire(page_values(page, bits, grid, values_)));
  }
  sent_ += events.size();
  unwritten_ = events.size();  // before the first write can end
  for (v1::PageValues& event : events) events_.push(std::move(event));
  return Status::ok();
}

void GetPageValuesCall::OnWriteDone(bool ok) {
  events_.on_write_done(ok);
  if (!ok) return end(cancelled("the client has gone"));
  if (--unwritten_ > 0) return;
  if (sent_ == pages_.size()) return end(Status::ok());
  run_guarded([this] { send(&GetPageValuesCall::send_some); },
              [this](const Status& status) { end(status); });
}

}  // namespace burnish
