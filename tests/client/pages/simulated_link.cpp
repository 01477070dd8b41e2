#include "tests/client/pages/simulated_link.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "common/generate/noise.h"

namespace burnish {

namespace {

constexpr uint8_t kGoodByte = 0, kDamagedByte = 1, kWrongSizeByte = 2;

std::chrono::microseconds microseconds_of(double seconds) {
  return std::chrono::microseconds(static_cast<int64_t>(seconds * 1e6));
}

}  // namespace

double SimulatedLink::draw() {
  return uniform(options_.seed, draws_++);
}

uint32_t SimulatedLink::bytes_of(PageItem item) const {
  return item.kind == PageItem::Kind::kPage ? scan_.directory.entries[item.number].bytes
                                            : scan_.directory.head.blocks[item.number].bytes;
}

void SimulatedLink::ask(const PageRequests::Plan& plan, Time now) {
  for (const PageItem item : plan.cancel) {
    asked_.erase(item);
    std::erase_if(coming_, [&](const auto& entry) {
      return entry.second.item == item && entry.first > now + microseconds_of(0.02);
    });
  }
  for (const PageItem item : plan.ask) {
    EXPECT_TRUE(asked_.insert(item).second) << "asked twice: " << item.number;
    bytes_asked_ += bytes_of(item);
    send(item, now);
  }
}

void SimulatedLink::send(PageItem item, Time now) {
  const LinkFaults& faults = options_.faults;
  Arrival arrival = {item, Fate::kGood};
  if (broken_ || draw() < faults.lost) return;
  if (draw() < faults.failed) arrival.fate = Fate::kFailed;
  if (draw() < faults.damaged) arrival.fate = Fate::kDamaged;
  if (draw() < faults.cut_short) arrival.fate = Fate::kCutShort;
  if (draw() < faults.wrong_size) arrival.fate = Fate::kWrongSize;
  const double seconds = bytes_of(item) / options_.speed.bytes_per_second;
  free_at_ = std::max(free_at_, now + microseconds_of(options_.speed.round_trip_seconds)) +
             microseconds_of(seconds);
  const bool is_late = draw() < faults.late;
  const Time at = free_at_ + microseconds_of(is_late ? draw() : 0);
  coming_.emplace(at, arrival);
  if (draw() < faults.doubled) coming_.emplace(at + microseconds_of(draw()), arrival);
}

void SimulatedLink::deliver(PageLoader& loader, Time now) {
  while (!coming_.empty() && coming_.begin()->first <= now) {
    const Arrival arrival = coming_.begin()->second;
    coming_.erase(coming_.begin());
    asked_.erase(arrival.item);
    bring(loader, arrival, now);
  }
}

void SimulatedLink::bring(PageLoader& loader, const Arrival& arrival, Time now) {
  if (arrival.fate == Fate::kFailed)
    return loader.on_failure(arrival.item, unavailable("refused"), now);
  if (arrival.item.kind == PageItem::Kind::kBlock) return bring_block(loader, arrival, now);
  std::vector<uint8_t> bytes(bytes_of(arrival.item), kGoodByte);
  if (arrival.fate == Fate::kDamaged) bytes[0] = kDamagedByte;
  if (arrival.fate == Fate::kWrongSize) bytes[0] = kWrongSizeByte;
  if (arrival.fate == Fate::kCutShort) bytes.pop_back();
  loader.on_page(arrival.item.number, std::move(bytes), now);
}

void SimulatedLink::bring_block(PageLoader& loader, const Arrival& arrival, Time now) {
  if (arrival.fate == Fate::kGood)
    loader.on_block(arrival.item.number, scan_.block(arrival.item.number), now);
  else
    loader.on_block(arrival.item.number, data_loss("damaged block"), now);
}

Result<Page> SimulatedLink::decode(PageId page, std::span<const uint8_t> bytes) const {
  if (bytes[0] == kDamagedByte) return data_loss("damaged page");
  Page decoded = scan_.page(page);
  if (bytes[0] == kWrongSizeByte) decoded.triangles.pop_back();
  return decoded;
}

}  // namespace burnish
