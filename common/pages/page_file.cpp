#include "common/pages/page_file.h"

#include <cstring>
#include <string>

#include "common/pages/directory_codec.h"
#include "common/pages/page_codec.h"
#include "common/pages/page_format.h"
#include "common/pages/page_header.h"

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

Result<PageFile> PageFile::open(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(FileReader reader, FileReader::open(path));
  PageFile file(std::move(reader));
  Status status = file.read_head();
  if (status.is_ok()) status = file.read_blocks();
  if (status.is_ok()) status = check_rise(file.directory_);
  if (!status.is_ok()) return status.with_context(path.string());
  return file;
}

Result<uint64_t> PageFile::find_head() const {
  PageTail tail;
  const uint64_t file_bytes = file_.file_bytes();
  if (file_bytes < sizeof(tail))
    return data_loss("the page file has " + std::to_string(file_bytes) + " bytes, its tail has " +
                     std::to_string(sizeof(tail)));
  const uint64_t tail_begin = file_bytes - sizeof(tail);
  ASSIGN_OR_RETURN(const std::vector<uint8_t> bytes, file_.read(tail_begin, sizeof(tail)));
  std::memcpy(&tail, bytes.data(), sizeof(tail));
  if (tail.magic != kPageTailMagic) return data_loss("the page file does not end with BnPt");
  if (tail.head_bytes > tail_begin)
    return data_loss("the head has " + std::to_string(tail.head_bytes) + " bytes, the page file " +
                     std::to_string(file_bytes));
  return tail_begin - tail.head_bytes;
}

Status PageFile::read_head() {
  ASSIGN_OR_RETURN(const uint64_t begin, find_head());
  ASSIGN_OR_RETURN(head_bytes_, file_.read(begin, file_.file_bytes() - sizeof(PageTail) - begin));
  ASSIGN_OR_RETURN(directory_.head, decode_head(head_bytes_));
  const PageHead& head = directory_.head;
  if (head.page_bytes > begin || begin - head.page_bytes != head.block_bytes)
    return data_loss("the head says " + std::to_string(head.page_bytes) + " bytes of pages and " +
                     std::to_string(head.block_bytes) + " of blocks, but " + std::to_string(begin) +
                     " bytes lie before it");
  return Status::ok();
}

Status PageFile::read_blocks() {
  const PageHead& head = directory_.head;
  block_offsets_.push_back(head.page_bytes);
  for (const PageBlock& block : head.blocks)
    block_offsets_.push_back(block_offsets_.back() + block.bytes);
  page_offsets_.push_back(0);
  for (uint32_t b = 0; b < head.blocks.size(); ++b) {
    ASSIGN_OR_RETURN(const DirectoryBlock block, read_block(b));
    for (size_t i = 0; i < block.entries.size(); ++i) {
      directory_.entries.push_back(block.entries[i]);
      directory_.coarser.add(block.coarser[i]);
      page_offsets_.push_back(page_offsets_.back() + block.entries[i].bytes);
    }
  }
  return Status::ok();
}

Result<std::vector<uint8_t>> PageFile::read_part(std::span<const uint64_t> offsets,
                                                 uint32_t part) const {
  return file_.read(offsets[part], offsets[part + 1] - offsets[part]);
}

Result<DirectoryBlock> PageFile::read_block(uint32_t block) const {
  ASSIGN_OR_RETURN(const std::vector<uint8_t> bytes, read_part(block_offsets_, block));
  return decode_block(bytes, directory_.head, block);
}

Result<std::vector<uint8_t>> PageFile::read_block_bytes(uint32_t block) const {
  ASSIGN_OR_RETURN(std::vector<uint8_t> bytes, read_part(block_offsets_, block));
  RETURN_IF_ERROR(decode_block(bytes, directory_.head, block).status());
  return bytes;
}

Result<std::vector<uint8_t>> PageFile::read_page_bytes(PageId page) const {
  ASSIGN_OR_RETURN(std::vector<uint8_t> bytes, read_part(page_offsets_, page));
  RETURN_IF_ERROR(read_page_header(bytes).status());
  return bytes;
}

Result<Page> PageFile::read_page(PageId page) const {
  ASSIGN_OR_RETURN(const std::vector<uint8_t> bytes, read_part(page_offsets_, page));
  ASSIGN_OR_RETURN(Page decoded, decode_page(bytes));
  RETURN_IF_ERROR(check_page_in_directory(decoded, page, directory_));
  return decoded;
}

uint64_t PageFile::byte_count() const {
  return directory_.entries.capacity() * sizeof(PageEntry) + directory_.coarser.byte_count() +
         directory_.head.blocks.capacity() * sizeof(PageBlock) + head_bytes_.capacity() +
         (page_offsets_.capacity() + block_offsets_.capacity()) * sizeof(uint64_t);
}

}  // namespace burnish
