#include "client/model/workspace/unsaved.h"

namespace burnish {

std::string text_of(const Unsaved& unsaved) {
  std::string text;
  if (unsaved.edits == 1) text = "1 edit is not saved";
  if (unsaved.edits > 1) text = std::to_string(unsaved.edits) + " edits are not saved";
  if (unsaved.files > 0 && !text.empty()) text += ", ";
  if (unsaved.files == 1) text += "1 file is not written";
  if (unsaved.files > 1) text += std::to_string(unsaved.files) + " files are not written";
  return text;
}

}  // namespace burnish
