#include "tests/bench/local_pages.h"

#include "common/pages/directory_codec.h"
#include "common/pages/page_codec.h"

namespace burnish {

static constexpr LinkSpeed kAnyLink{1e10, 1};

LocalPages::LocalPages(PageFile file)
    : file_(std::move(file)), loader_(file_.directory().head, PageBudget(), false) {}

Result<std::vector<PageUpload>> LocalPages::look(const PageView& view) {
  PictureQuestion question;
  question.view = view;
  question.link = kAnyLink;
  loader_.look(question, {});
  for (const PageItem item : loader_.requests().ask) RETURN_IF_ERROR(bring(item));
  for (const PageId page : loader_.to_decode())
    loader_.on_decoded(page, decode_page(loader_.bytes_of(page)), {});
  return loader_.take_uploads();
}

Status LocalPages::bring(PageItem item) {
  if (item.kind == PageItem::Kind::kPage) {
    ASSIGN_OR_RETURN(std::vector<uint8_t> bytes, file_.read_page_bytes(item.number));
    bytes_ += bytes.size();
    loader_.on_page(item.number, std::move(bytes), {});
    return Status::ok();
  }
  ASSIGN_OR_RETURN(const std::vector<uint8_t> bytes, file_.read_block_bytes(item.number));
  bytes_ += bytes.size();
  loader_.on_block(item.number, decode_block(bytes, head(), item.number), {});
  return Status::ok();
}

}  // namespace burnish
