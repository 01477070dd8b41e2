#include "tests/client/connection/fake_library.h"

#include <algorithm>
#include <chrono>
#include <cstring>

#include "common/packing/checksum.h"
#include "common/pages/page_codec.h"
#include "common/pages/page_format.h"
#include "tests/client/connection/fake_server.h"
#include "tests/common/pages/made_pages.h"

namespace burnish {

FakeLibrary::FakeLibrary() {
  start();
}

FakeLibrary::~FakeLibrary() {
  stop();
}

void FakeLibrary::start() {
  stopping_ = false;
  server_ = serve_fake(*this, port_);
}

void FakeLibrary::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  if (server_) server_->Shutdown(std::chrono::system_clock::now());
  server_.reset();
}

void FakeLibrary::set_faults(const Faults& faults) {
  const std::lock_guard lock(mutex_);
  faults_ = faults;
  changed_.notify_all();
}

FakeLibrary::Seen FakeLibrary::seen() const {
  const std::lock_guard lock(mutex_);
  return seen_;
}

// A block has the checksum of one; nobody here reads the rest.
std::vector<uint8_t> FakeLibrary::bytes_of(PageItem item) {
  if (item.kind == PageItem::Kind::kPage)
    return encode_page(
        made_sheet({.id = item.number, .columns = 4, .rows = 3, .patches = 0}, item.number));
  const auto fill = static_cast<uint8_t>(item.number + 50 * item.halving);
  std::vector<uint8_t> bytes(kPageBlockHeaderBytes + 50, fill);
  constexpr size_t kChecksumAt = kPageBlockHeaderBytes - sizeof(uint64_t);
  const uint64_t checksum = sealed_checksum(bytes, kChecksumAt, kPageBlockHeaderBytes);
  std::memcpy(&bytes[kChecksumAt], &checksum, sizeof checksum);
  return bytes;
}

bool FakeLibrary::wait_while_held(grpc::ServerContext& context) {
  std::unique_lock lock(mutex_);
  while (faults_.holds && !stopping_ && !context.IsCancelled())
    changed_.wait_for(lock, std::chrono::milliseconds(1));
  return !stopping_ && !context.IsCancelled();
}

static void fill(v1::PagePart& part, PageItem item) {
  const std::vector<uint8_t> bytes = FakeLibrary::bytes_of(item);
  part.set_number(item.number);
  part.set_data(bytes.data(), bytes.size());
}

static void fill(v1::FetchPagesEvent& event, PageItem item) {
  fill(item.kind == PageItem::Kind::kPage ? *event.mutable_page() : *event.mutable_block(), item);
}

static void fill(v1::FetchSheetsEvent& event, PageItem item) {
  if (item.kind == PageItem::Kind::kSheetBlock) return fill(*event.mutable_block(), item);
  if (item.kind == PageItem::Kind::kCharts) return fill(*event.mutable_charts(), item);
  const std::vector<uint8_t> bytes = FakeLibrary::bytes_of(item);
  event.mutable_sheet()->mutable_number()->set_page(item.number);
  event.mutable_sheet()->mutable_number()->set_halving(item.halving);
  event.mutable_sheet()->set_data(bytes.data(), bytes.size());
}

grpc::Status FakeLibrary::FetchPages(grpc::ServerContext* context,
                                     const v1::FetchPagesRequest* request, Writer* writer) {
  std::vector<PageItem> items;
  for (const uint32_t block : request->blocks()) items.push_back(PageItem::of_block(block));
  for (const uint32_t page : request->pages()) items.push_back(PageItem::of_page(page));
  return send(*context, request->scan(), std::move(items), *writer);
}

grpc::Status FakeLibrary::FetchSheets(grpc::ServerContext* context,
                                      const v1::FetchSheetsRequest* request, SheetWriter* writer) {
  std::vector<PageItem> items;
  for (const uint32_t block : request->blocks()) items.push_back(PageItem::of_sheet_block(block));
  for (const uint32_t page : request->charts()) items.push_back(PageItem::of_charts(page));
  for (const v1::SheetNumber& sheet : request->sheets())
    items.push_back(PageItem::of_sheet(sheet.page(), static_cast<uint8_t>(sheet.halving())));
  return send(*context, request->scan(), std::move(items), *writer);
}

template <typename Event>
grpc::Status FakeLibrary::send(grpc::ServerContext& context, const std::string& scan,
                               std::vector<PageItem> items, grpc::ServerWriter<Event>& writer) {
  {
    const std::lock_guard lock(mutex_);
    seen_.calls.push_back(items);
    seen_.scan = scan;
    seen_.calls_at_once_max = std::max(seen_.calls_at_once_max, ++calls_now_);
  }
  const bool goes_on = wait_while_held(context);
  const std::lock_guard lock(mutex_);
  --calls_now_;
  if (!goes_on) {
    ++seen_.cancelled;
    return {grpc::StatusCode::UNAVAILABLE, "gone"};
  }
  if (faults_.turns_around) std::ranges::reverse(items);
  int parts = 0;
  for (const PageItem item : items) {
    if (parts++ == faults_.parts_max) break;
    if (faults_.left_out.contains(item.number)) continue;
    Event event;
    fill(event, item);
    writer.Write(event);
  }
  return {faults_.ends_with, "not today"};
}

grpc::Status FakeLibrary::ListScans(grpc::ServerContext*, const v1::ListScansRequest*,
                                    v1::ListScansResponse*) {
  return grpc::Status::OK;
}

}  // namespace burnish
