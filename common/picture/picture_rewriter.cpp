#include "common/picture/picture_rewriter.h"

#include <new>

#include "common/picture/picture_kind.h"
#include "common/picture/rewriters.h"

namespace burnish {

static Result<RewrittenPicture> rewrite_by_kind(std::span<const uint8_t> bytes,
                                                const PictureEditor& editor) {
  ASSIGN_OR_RETURN(const PictureKind kind, kind_of_picture(bytes));
  if (kind == PictureKind::kWebp) return rewrite_webp(bytes, editor);
  return kind == PictureKind::kPng ? rewrite_png(bytes, editor) : rewrite_jpeg(bytes, editor);
}

Result<RewrittenPicture> rewrite_picture(std::span<const uint8_t> bytes, const std::string& name,
                                         const PictureEditor& editor) {
  try {
    auto rewritten = rewrite_by_kind(bytes, editor);
    if (!rewritten.is_ok()) return rewritten.status().with_context(name);
    return rewritten;
  } catch (const std::bad_alloc&) {
    return resource_exhausted(name + ": not enough memory for its pixels");
  }
}

}  // namespace burnish
