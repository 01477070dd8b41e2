#include <cstring>
#include <vector>

#include "common/base/check.h"
#include "common/pages/directory_codec.h"
#include "common/pages/page_codec.h"
#include "common/pages/page_file.h"
#include "common/pages/page_format.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/readers.h"
#include "tests/fuzz/sealed_part.h"

namespace burnish {

namespace {

void seal_blocks(const PageHead& head, std::span<uint8_t> blocks) {
  for (const PageBlock& block : head.blocks) {
    if (block.bytes > blocks.size()) return;
    seal_part(blocks.first(block.bytes), kPageBlockHeaderBytes);
    blocks = blocks.subspan(block.bytes);
  }
}

void seal_file(std::span<uint8_t> file) {
  PageTail tail;
  if (file.size() < sizeof(tail)) return;
  const size_t end = file.size() - sizeof(tail);
  std::memcpy(&tail, file.data() + end, sizeof(tail));
  if (tail.head_bytes > end) return;
  const auto head_bytes = file.subspan(end - tail.head_bytes, tail.head_bytes);
  seal_part(head_bytes, kPageHeadHeaderBytes);
  const auto head = decode_head(head_bytes);
  if (head.is_ok() && head->page_bytes <= file.size())
    seal_blocks(*head, file.subspan(head->page_bytes));
}

/// The head of three, two and one pages of 100 bytes each.
PageHead small_head() {
  PageHead head{.scan_vertices = 9, .scan_triangles = 9};
  head.level_pages = {3, 2, 1};
  const PageBounds wide{Vec3f::Zero(), 100, 100, 100};
  head.blocks = {{wide, 0, 100}, {wide, 300, 100}, {wide, 500, 100}};
  head.page_bytes = 600;
  head.block_bytes = 300;
  return head;
}

}  // namespace

bool read_fuzzed_page(std::span<const uint8_t> bytes) {
  (void)decode_page(bytes);
  const auto page = decode_page(compressed(bytes, kPageHeaderBytes));
  if (!page.is_ok()) return false;
  const auto again = decode_page(encode_page(*page));
  BURNISH_CHECK(again.is_ok() && again->patches == page->patches, "a page does not read back");
  return true;
}

bool read_page_block(std::span<const uint8_t> bytes) {
  (void)decode_block(bytes, small_head(), 0);
  const auto block = decode_block(compressed(bytes, kPageBlockHeaderBytes), small_head(), 0);
  if (!block.is_ok()) return false;
  const auto again = decode_block(encode_block(*block), small_head(), 0);
  BURNISH_CHECK(again.is_ok() && again->entries == block->entries, "a block does not read back");
  return true;
}

bool read_page_file(std::span<const uint8_t> bytes) {
  std::vector<uint8_t> sealed(bytes.begin(), bytes.end());
  seal_file(sealed);
  const MemoryFile in_memory(sealed);
  const auto file = PageFile::open(in_memory.path());
  if (!file.is_ok()) return false;
  for (PageId page = 0; page < file->directory().head.page_count(); ++page)
    (void)file->read_page(page);
  return true;
}

}  // namespace burnish
