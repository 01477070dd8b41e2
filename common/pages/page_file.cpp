#include "common/pages/page_file.h"

#include <cstring>
#include <string>

#include "common/pages/directory_codec.h"
#include "common/pages/page_codec.h"
#include "common/pages/page_format.h"

namespace burnish {

namespace {

Status check_rise(const PageDirectory& directory) {
  for (PageId page = 0; page < directory.entries.size(); ++page)
    for (const PageId coarser : directory.coarser[page]) {
      const PageBounds& fine = directory.entries[page].bounds;
      const PageBounds& coarse = directory.entries[coarser].bounds;
      if (coarse.error < fine.error || coarse.edge < fine.edge)
        return data_loss("page " + std::to_string(coarser) +
                         " has a smaller error or edge than the finer page " +
                         std::to_string(page));
    }
  return Status::ok();
}

}  // namespace

PageFile::PageFile(MappedFile file) : file_(std::move(file)) {}

Result<PageFile> PageFile::open(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(MappedFile mapped, MappedFile::open(path));
  PageFile file(std::move(mapped));
  Status status = file.read_head();
  if (status.is_ok()) status = file.read_blocks();
  if (status.is_ok()) status = check_rise(file.directory_);
  if (!status.is_ok()) return status.with_context(path.string());
  return file;
}

Status PageFile::read_head() {
  const auto bytes = file_.bytes();
  PageTail tail;
  if (bytes.size() < sizeof(tail))
    return data_loss("the page file has " + std::to_string(bytes.size()) + " bytes, its tail has " +
                     std::to_string(sizeof(tail)));
  const size_t tail_begin = bytes.size() - sizeof(tail);
  std::memcpy(&tail, bytes.data() + tail_begin, sizeof(tail));
  if (tail.magic != kPageTailMagic) return data_loss("the page file does not end with BnPt");
  if (tail.head_bytes > tail_begin)
    return data_loss("the head has " + std::to_string(tail.head_bytes) + " bytes, the page file " +
                     std::to_string(bytes.size()));
  head_begin_ = tail_begin - tail.head_bytes;
  ASSIGN_OR_RETURN(directory_.head, decode_head(head_bytes()));
  const PageHead& head = directory_.head;
  if (head.page_bytes > head_begin_ || head_begin_ - head.page_bytes != head.block_bytes)
    return data_loss("the head says " + std::to_string(head.page_bytes) + " bytes of pages and " +
                     std::to_string(head.block_bytes) + " of blocks, before it lie " +
                     std::to_string(head_begin_));
  return Status::ok();
}

Status PageFile::read_blocks() {
  const PageHead& head = directory_.head;
  block_offsets_.push_back(head.page_bytes);
  for (const PageBlock& block : head.blocks)
    block_offsets_.push_back(block_offsets_.back() + block.bytes);
  page_offsets_.push_back(0);
  for (uint32_t b = 0; b < head.blocks.size(); ++b) {
    ASSIGN_OR_RETURN(const DirectoryBlock block, decode_block(block_bytes(b), head, b));
    for (size_t i = 0; i < block.entries.size(); ++i) {
      directory_.entries.push_back(block.entries[i]);
      directory_.coarser.add(block.coarser[i]);
      page_offsets_.push_back(page_offsets_.back() + block.entries[i].bytes);
    }
  }
  return Status::ok();
}

std::span<const uint8_t> PageFile::head_bytes() const {
  return file_.bytes().subspan(head_begin_, file_.bytes().size() - sizeof(PageTail) - head_begin_);
}

std::span<const uint8_t> PageFile::block_bytes(uint32_t block) const {
  return file_.bytes().subspan(block_offsets_[block],
                               block_offsets_[block + 1] - block_offsets_[block]);
}

std::span<const uint8_t> PageFile::page_bytes(PageId page) const {
  return file_.bytes().subspan(page_offsets_[page], page_offsets_[page + 1] - page_offsets_[page]);
}

Result<Page> PageFile::read_page(PageId page) const {
  ASSIGN_OR_RETURN(Page decoded, decode_page(page_bytes(page)));
  RETURN_IF_ERROR(check_page_in_directory(decoded, page, directory_));
  return decoded;
}

}  // namespace burnish
