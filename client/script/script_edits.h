#pragma once

#include <string>
#include <vector>

#include "client/model/documents/document.h"
#include "client/script/script.h"
#include "client/tools/presets.h"

namespace burnish {

/// Does a command that changes the session or its brush: `beta` to `restore` in script_help(), but
/// `drag`, `turn` and `fork`. Waits for nothing. Fails: invalid_argument that names the value and
/// its limit; failed_precondition.
Status change_document(const ScriptLine& line, Document& document);

/// The words of `export`.
struct ExportLine {
  std::string file;
  bool is_exact = false;
  bool has_record = false;  ///< also writes who did what
};
/// Parses FILE [exact] [record]. Fails: invalid_argument that names the word.
Result<ExportLine> parse_export(const std::vector<std::string>& words);

struct ChosenPreset {
  Preset preset;
  double strength = 1;
};
/// Parses NAME [STRENGTH]. The name may have several words; a number behind it is the strength.
/// Fails also: not_found for an unknown name.
Result<ChosenPreset> parse_preset(std::vector<std::string> words);

/// Parses a line that is an edit. Fails: as parse_edit() does; failed_precondition for colours of a
/// scan without.
Result<Change> parse_change(const ScriptLine& line, const Document& document);

}  // namespace burnish
