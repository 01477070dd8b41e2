#include "client/model/workspace/letters.h"

#include "client/model/workspace/workspace.h"

namespace burnish {

static constexpr uint32_t kLoadedAnyway = 0x52f, kFirstPlane = 0xffff;

static bool goes_on(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0) == 0x80;
}

// Takes the first letter off a text. Returns 0 for a byte that begins none.
static uint32_t take_letter(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const size_t more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
  uint32_t letter = more == 0 ? first : first & (0x3fu >> more);
  size_t size = 1;
  for (; size <= more && size < text.size() && goes_on(text[size]); ++size)
    letter = letter << 6 | (static_cast<unsigned char>(text[size]) & 0x3fu);
  text.remove_prefix(size);
  return size == more + 1 ? letter : 0;
}

void Letters::add(std::string_view text) {
  while (!text.empty()) {
    const uint32_t letter = take_letter(text);
    if (letter > kLoadedAnyway && letter <= kFirstPlane && letters_.size() < kLettersMax)
      letters_.insert(static_cast<char16_t>(letter));
  }
}

static void add_document(const Document& document, Letters& letters) {
  letters.add(document.scan().scan.name);
  letters.add(document.session().name);
  for (const HistoryEntry& entry : document.history()) {
    letters.add(entry.summary);
    letters.add(entry.author);
  }
  for (const PresentUser& user : document.people().present) letters.add(user.user);
}

void add_letters(const Workspace& workspace, Letters& letters) {
  for (const ScanInfo& scan : workspace.library().scans) letters.add(scan.name);
  for (const SessionInfo& session : workspace.library().sessions) letters.add(session.name);
  for (const RecentSession& recent : workspace.preferences.recent) {
    letters.add(recent.session);
    letters.add(recent.scan_name);
  }
  for (const auto& folder : workspace.preferences.folders) letters.add(folder.native());
  for (const Message& message : workspace.log.messages()) letters.add(message.text);
  for (const auto& activity : workspace.activities()) letters.add(activity->title());
  letters.add(workspace.preferences.user);
  if (workspace.raw()) letters.add(workspace.raw()->name);
  if (workspace.document()) add_document(*workspace.document(), letters);
}

}  // namespace burnish
