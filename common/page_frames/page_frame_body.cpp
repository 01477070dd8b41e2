#include "common/page_frames/page_frame_body.h"

#include <algorithm>
#include <string>

#include "common/page_frames/page_frame_header.h"
#include "common/page_frames/page_kind.h"

namespace burnish {

namespace {

constexpr uint8_t kValuesFlag = 1;
constexpr uint8_t kGainFlag = 2;
constexpr uint8_t kHeldFlag = 4;
constexpr uint8_t kAllFlags = kValuesFlag | kGainFlag | kHeldFlag;

size_t width_bytes_of_page(const ShownPage& page) {
  return size_t{3} * width_bytes(static_cast<int>(page.value_count()));
}

Status check_flags(std::span<const uint8_t> flags, uint32_t sent_pages) {
  uint32_t count = 0;
  for (const uint8_t flag : flags) {
    if (flag > kAllFlags)
      return data_loss("a page is marked " + std::to_string(flag) + ", the largest mark is " +
                       std::to_string(kAllFlags));
    count += flag & kValuesFlag;
  }
  if (count == sent_pages) return Status::ok();
  return data_loss(std::to_string(count) + " pages are marked as sent, the header says " +
                   std::to_string(sent_pages));
}

Status check_gains(std::span<const uint8_t> gains) {
  const auto wrong =
      std::ranges::find_if(gains, [](uint8_t gain) { return gain > kPageGainExponentMax; });
  if (wrong == gains.end()) return Status::ok();
  return data_loss("a page has gain 2^" + std::to_string(*wrong) + ", the largest is 2^" +
                   std::to_string(kPageGainExponentMax));
}

}  // namespace

void PageFrameBodyWriter::add_gain(size_t page, uint8_t gain) {
  flags_[page] |= kGainFlag;
  gains_.push_back(gain);
}

void PageFrameBodyWriter::add_held(size_t page, const HeldVertices& held, size_t vertices) {
  flags_[page] |= kHeldFlag;
  ++sent_held_;
  const size_t end = held_.size() + held_bytes(vertices);
  if (held) held_.insert(held_.end(), held->begin(), held->end());
  held_.resize(end);
}

void PageFrameBodyWriter::add_values(size_t page, std::span<const uint32_t> residuals) {
  flags_[page] |= kValuesFlag;
  ++sent_pages_;
  const size_t size = residuals.size() / 3;
  for (int axis = 0; axis < 3; ++axis) groups_.add_axis(residuals.subspan(axis * size, size));
}

size_t PageFrameBodyWriter::byte_count() const {
  return flags_.size() + gains_.size() + held_.size() + groups_.byte_count();
}

std::vector<uint8_t> PageFrameBodyWriter::bytes() const {
  std::vector<uint8_t> bytes = flags_;
  bytes.insert(bytes.end(), gains_.begin(), gains_.end());
  bytes.insert(bytes.end(), held_.begin(), held_.end());
  groups_.append_to(bytes);
  return bytes;
}

Result<PageFrameBodyReader> PageFrameBodyReader::open(std::span<const ShownPage> pages,
                                                      uint32_t sent_pages,
                                                      std::span<const uint8_t> bytes) {
  PageFrameBodyReader reader;
  ASSIGN_OR_RETURN(reader.flags_, take_stream(bytes, pages.size()));
  RETURN_IF_ERROR(check_flags(reader.flags_, sent_pages));
  size_t gains = 0, all_held_bytes = 0, all_width_bytes = 0;
  for (size_t page = 0; page < pages.size(); ++page) {
    if (reader.has_gain(page)) ++gains;
    if (reader.has_held(page)) all_held_bytes += held_bytes(pages[page].layout->vertices);
    if (reader.has_values(page)) all_width_bytes += width_bytes_of_page(pages[page]);
  }
  ASSIGN_OR_RETURN(reader.gains_, take_stream(bytes, gains));
  RETURN_IF_ERROR(check_gains(reader.gains_));
  ASSIGN_OR_RETURN(reader.held_, take_stream(bytes, all_held_bytes));
  RETURN_IF_ERROR(reader.check_held(pages));
  ASSIGN_OR_RETURN(reader.groups_, GroupUnpacker::open(all_width_bytes, bytes));
  return reader;
}

bool PageFrameBodyReader::has_gain(size_t page) const {
  return (flags_[page] & kGainFlag) != 0;
}

bool PageFrameBodyReader::has_held(size_t page) const {
  return (flags_[page] & kHeldFlag) != 0;
}

bool PageFrameBodyReader::has_values(size_t page) const {
  return (flags_[page] & kValuesFlag) != 0;
}

uint8_t PageFrameBodyReader::read_gain() {
  const uint8_t gain = gains_.front();
  gains_ = gains_.subspan(1);
  return gain;
}

HeldVertices PageFrameBodyReader::read_held(size_t vertices) {
  const auto bits = held_.first(held_bytes(vertices));
  held_ = held_.subspan(bits.size());
  if (std::ranges::all_of(bits, [](uint8_t byte) { return byte == 0; })) return nullptr;
  return std::make_shared<const std::vector<uint8_t>>(bits.begin(), bits.end());
}

// Bits beyond the last vertex would be vertices that the page does not have.
Status PageFrameBodyReader::check_held(std::span<const ShownPage> pages) const {
  size_t end = 0;
  for (size_t page = 0; page < pages.size(); ++page) {
    const uint32_t vertices = pages[page].layout->vertices;
    if (!has_held(page) || vertices == 0) continue;
    end += held_bytes(vertices);
    const uint32_t last = 1 + (vertices - 1) % 8;
    if (held_[end - 1] >> last != 0)
      return data_loss("page " + std::to_string(pages[page].page) +
                       " holds a vertex beyond its last, " + std::to_string(vertices - 1));
  }
  return Status::ok();
}

void PageFrameBodyReader::read_values(std::span<uint32_t> residuals) {
  const size_t size = residuals.size() / 3;
  for (int axis = 0; axis < 3; ++axis) groups_.read_axis(residuals.subspan(axis * size, size));
}

uint64_t page_body_bytes_max(std::span<const ShownPage> pages) {
  uint64_t bytes = 0;
  for (const ShownPage& page : pages)
    bytes += page_key_bytes_max(page.value_count()) + held_bytes(page.layout->vertices);
  return bytes;
}

}  // namespace burnish
