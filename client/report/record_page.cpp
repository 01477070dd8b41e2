// The processing record as a page for people.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "client/report/entry_text.h"
#include "client/report/length_text.h"
#include "client/report/moves_text.h"
#include "client/report/processing_record.h"
#include "client/report/time_text.h"

namespace burnish {

namespace {

constexpr const char* kHead =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Processing "
    "record</title>\n"
    "<style>\n"
    "@page { size: A4; margin: 18mm }\n"
    "body { font: 11pt/1.4 sans-serif; max-width: 60em; margin: 2em auto; color: #222 }\n"
    "h1 { font-size: 1.5em } h2 { font-size: 1.1em; margin: 1.4em 0 .3em }\n"
    "table { border-collapse: collapse; width: 100% }\n"
    "th, td { text-align: left; vertical-align: top; padding: .15em .8em .15em 0 }\n"
    "th { font-weight: normal; color: #666 }\n"
    ".facts th { width: 13em } .edits tr { border-top: 1px solid #ddd; break-inside: avoid }\n"
    ".off { color: #999; text-decoration: line-through } code { font-size: .85em; word-break: "
    "break-all }\n"
    "</style></head><body>\n";

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string number(double value) {
  return length_text(value, "");
}

/// A table of facts: a name, and a value that is escaped here.
class Facts {
 public:
  explicit Facts(const std::string& title)
      : text_("<h2>" + title + "</h2>\n<table class=\"facts\">\n") {}

  Facts& add(const std::string& name, const std::string& value) {
    text_ += "<tr><th>" + name + "</th><td>" + escaped(value) + "</td></tr>\n";
    return *this;
  }

  Facts& add_hash(const std::string& hash) {
    text_ += "<tr><th>SHA-256</th><td><code>" + escaped(hash) + "</code></td></tr>\n";
    return *this;
  }

  std::string end() const { return text_ + "</table>\n"; }

 private:
  std::string text_;
};

std::string or_unnamed(const std::string& name) {
  return name.empty() ? "without a name" : name;
}

std::string files(const ProcessingRecord& record) {
  const ScanInfo& scan = record.scan;
  Facts input("Scan");
  input.add("Name", scan.name)
      .add("Format", std::string(mesh_format_name(scan.format)) + ", " +
                         std::to_string(scan.size_bytes) + " bytes")
      .add("Surface", std::to_string(scan.statistics.vertices) + " vertices, " +
                          std::to_string(scan.statistics.triangles) + " triangles")
      .add("Diagonal of its box", length_text(scan.statistics.diagonal(), scan.unit))
      .add("Unit", scan.unit.empty() ? "not named" : scan.unit)
      .add_hash(scan.id);
  Facts output("Exported file");
  output.add("File", record.file + ", " + std::to_string(record.result.size_bytes) + " bytes");
  for (const std::string& name : record.result.left_out) output.add("Not in this file", name);
  if (!record.result.pictures.empty()) output.add("Pictures", record.result.pictures);
  if (!record.result.lost_volume.empty()) output.add("Volume", record.result.lost_volume);
  return input.end() + output.add_hash(record.result.sha256).end();
}

std::string method(const ProcessingRecord& record) {
  const ScanInfo& scan = record.scan;
  Facts facts("Method");
  facts.add("Equation", "screened Poisson equation, Chuang and Kazhdan 2011")
      .add("Grid", "depth " + std::to_string(record.state.session.key.depth) + ", cells of " +
                       length_text(record.prepared.cell_size, scan.unit));
  for (const SettingText& setting : texts_of(record.state.settings))
    facts.add(setting.label, setting.text);
  return facts
      .add("Accuracy", number(record.result.distance) + " of the diagonal" +
                           (record.result.converged ? "" : ", not converged"))
      .end();
}

std::string percent_text(double after, double before) {
  char text[32];
  std::snprintf(text, sizeof text, "%+.3f %%", before == 0 ? 0 : 100 * (after / before - 1));
  return text;
}

std::string deviation_facts(const Deviation& deviation, const ScanInfo& scan) {
  Facts facts("Deviation");
  facts.add("Largest", length_text(deviation.max, scan.unit, kDeviationDigits))
      .add("Mean", length_text(deviation.mean, scan.unit, kDeviationDigits))
      .add("Root mean square", length_text(deviation.rms, scan.unit, kDeviationDigits))
      .add("Outwards at most", length_text(deviation.outward_max, scan.unit, kDeviationDigits))
      .add("Inwards at most", length_text(deviation.inward_max, scan.unit, kDeviationDigits));
  for (size_t axis = 0; deviation.axes && axis < 3; ++axis)
    facts.add(std::string("Along ") + "xyz"[axis], moves_text((*deviation.axes)[axis], scan.unit));
  facts.add("Area", percent_text(deviation.area_after, deviation.area_before));
  if (scan.statistics.is_closed())
    facts.add("Volume", percent_text(deviation.volume_after, deviation.volume_before));
  return facts.end();
}

/// Bars of the surface's area by its move along the normal. Heights are roots, so that small parts
/// are seen beside the part that stays.
std::string histogram(const Deviation& deviation, const std::string& unit) {
  constexpr int kWidth = 640, kHeight = 120;
  const double largest = *std::ranges::max_element(deviation.histogram);
  std::string text =
      "<svg viewBox=\"0 0 640 145\" width=\"100%\" role=\"img\" "
      "aria-label=\"Area by deviation\">\n";
  for (int bin = 0; bin < Deviation::kBins; ++bin) {
    const double part = largest > 0 ? deviation.histogram[bin] / largest : 0;
    const double height = kHeight * std::sqrt(part);
    char bar[160];
    std::snprintf(bar, sizeof bar,
                  "<rect x=\"%d\" y=\"%.1f\" width=\"9\" height=\"%.1f\" fill=\"%s\"/>\n",
                  bin * kWidth / Deviation::kBins, kHeight - height, height,
                  bin < Deviation::kBins / 2 ? "#4a78b8" : "#b8544a");
    text += bar;
  }
  const std::string range = escaped(length_text(deviation.histogram_range, unit));
  return text + "<text x=\"0\" y=\"140\" font-size=\"12\">" + range +
         " inwards</text><text x=\"320\" y=\"140\" font-size=\"12\" text-anchor=\"middle\">0</text>"
         "<text x=\"640\" y=\"140\" font-size=\"12\" text-anchor=\"end\">" +
         range + " outwards</text></svg>\n";
}

std::string details_in_row(const std::string& details) {
  return details.empty() ? details : "<br><small>" + escaped(details) + "</small>";
}

std::string edits(const ProcessingRecord& record) {
  std::string text = "<h2>Edits</h2>\n";
  if (record.is_edited_since)
    text +=
        "<p>The session was edited after this export. Entries may have been switched since.</p>\n";
  text += "<table class=\"edits\"><tr><th>No.</th><th>Time</th><th>Who</th><th>What</th></tr>\n";
  for (const HistoryEntry& entry : record.edits)
    text += std::string(entry.enabled ? "<tr>" : "<tr class=\"off\">") + "<td>" +
            std::to_string(entry.number) + "</td><td>" + utc_text(entry.unix_ms) + "</td><td>" +
            escaped(or_unnamed(entry.author)) + "</td><td>" + escaped(entry_name(entry)) +
            details_in_row(entry_details(entry, record.scan.unit)) + "</td></tr>\n";
  return text + "</table>\n";
}

}  // namespace

std::string record_page(const ProcessingRecord& record) {
  const Deviation deviation = record.result.deviation.value_or(Deviation());
  return kHead +
         ("<h1>Processing record: " + escaped(record.scan.name) + "</h1>\n<p>Made " +
          utc_text(record.unix_ms) + " by " + escaped(or_unnamed(record.author)) + " with " +
          escaped(record.program) + ", session " + escaped(record.state.session.name) + ".</p>\n") +
         files(record) + method(record) + deviation_facts(deviation, record.scan) +
         histogram(deviation, record.scan.unit) + edits(record) + "</body></html>\n";
}

}  // namespace burnish
