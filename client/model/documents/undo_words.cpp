#include "client/model/documents/undo_words.h"

#include <algorithm>
#include <optional>

#include "client/report/entry_text.h"

namespace burnish {

/// Returns the user's name, empty for one without a name; nothing before the server tells.
static std::optional<std::string> own_name(const Document& document) {
  const std::vector<PresentUser>& present = document.people().present;
  const auto me =
      std::ranges::find(present, document.welcome().connection, &PresentUser::connection);
  return me == present.end() ? std::nullopt : std::optional(me->user);
}

std::string undo_name(const Document& document) {
  const auto author = own_name(document);
  if (!author || !document.has_newest_history()) return {};
  const auto& history = document.history();
  const auto newest =
      std::find_if(history.rbegin(), history.rend(), [&](const HistoryEntry& entry) {
        return entry.enabled && makes_fields(entry.kind) && entry.author == *author;
      });
  if (newest == history.rend()) return {};
  const int others = document.undo_steps().next_undo() - 1;
  if (others == 0) return entry_name(*newest);
  return entry_name(*newest) + " and " + std::to_string(others) +
         (others == 1 ? " more edit" : " more edits");
}

static std::string with_name(const char* what, const std::string& name) {
  return name.empty() ? what + std::string(".") : what + (": " + name + ".");
}

std::string undo_hint(const Document& document) {
  const bool is_nameless = own_name(document) == "";
  return with_name(is_nameless ? "Takes back the last edit of anybody without a name"
                               : "Takes back your last edit, not those of others",
                   undo_name(document));
}

std::string redo_hint(const Document& document) {
  return with_name("Makes the edit again that you took back", document.undo_steps().redo_name());
}

}  // namespace burnish
