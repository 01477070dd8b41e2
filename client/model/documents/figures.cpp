#include "client/model/documents/figures.h"

#include <cstdarg>
#include <cstdio>

#include "client/report/length_text.h"
#include "client/report/moves_text.h"

namespace burnish {

__attribute__((format(printf, 1, 2))) static std::string printed(const char* format, ...) {
  char text[128];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

const char* state_word(const Document& document) {
  if (document.stats().frames == 0) return "waiting for the first frame";
  if (document.is_trying()) return "trying a strength";
  if (!document.stats().frame.settled) return "converging";
  if (!document.is_settled()) return "saving";
  return document.stats().frame.exact ? "exact" : "settled";
}

std::vector<Figure> link_figures(const Document& document) {
  const LinkStats& stats = document.stats();
  const FrameStats& frame = stats.frame;
  std::vector<Figure> figures = {
      {"residual", printed("%.1e", frame.residual)},
      {"distance", printed("%.1e of the diagonal", frame.distance)},
      {"cycles", std::to_string(frame.cycles) + " (" + document.welcome().backend + ")"},
      {"server",
       printed("%.1f + %.1f + %.1f ms", frame.assemble_ms, frame.solve_ms, frame.encode_ms)},
      {"frame age", printed("%.0f ms", stats.age_ms)},
      {"round trip", stats.rtt_ms < 1 ? "under 1 ms" : printed("%.0f ms", stats.rtt_ms)},
      {"frames",
       printed("%.0f/s, %.1f Mbit/s", stats.frames_per_second, stats.megabits_per_second)},
  };
  if (frame.volume != 0)
    figures.push_back({"volume", is_volume_kept(frame.volume)
                                     ? "kept"
                                     : printed("%.6g %% of the scan's", 100 * frame.volume)});
  if (document.shown_after_ms() > 0)
    figures.push_back({"edit to picture", printed("%.0f ms", document.shown_after_ms())});
  return figures;
}

static std::vector<Figure> upward_figures(const Deviation& deviation, UpAxis up,
                                          const std::string& unit) {
  if (!deviation.axes) return {};
  const auto axis = static_cast<size_t>(up);
  const AxisMoves& moves = (*deviation.axes)[axis % 3];
  const AxisMoves upwards = axis < 3 ? moves : moves.reversed();
  const std::string along = "along " + std::string(name_of(up));
  return {{along, signed_length_text(upwards.farthest(), unit)},
          {"mean " + along, signed_length_text(upwards.mean, unit)},
          {"rms " + along, length_text(upwards.rms, unit, kDeviationDigits)}};
}

std::vector<Figure> deviation_figures(const Document& document, UpAxis up) {
  const auto& measured = document.measuring().deviation();
  if (!measured) return {};
  const Deviation& deviation = measured->deviation;
  const std::string& unit = document.unit();
  std::vector<Figure> figures = {
      {"largest move", length_text(deviation.max, unit, kDeviationDigits)},
      {"mean", length_text(deviation.mean, unit, kDeviationDigits)},
      {"rms", length_text(deviation.rms, unit, kDeviationDigits)},
      {"outwards", length_text(deviation.outward_max, unit, kDeviationDigits)},
      {"inwards", length_text(deviation.inward_max, unit, kDeviationDigits)}};
  for (Figure& figure : upward_figures(deviation, up, unit)) figures.push_back(std::move(figure));
  if (document.is_closed() && deviation.volume_before != 0)
    figures.push_back(
        {"volume",
         printed("%+.3f %%", 100 * (deviation.volume_after / deviation.volume_before - 1))});
  return figures;
}

std::string rims_text(const Document& document) {
  const auto count = document.rims();
  if (!count || count->rims == 0) return {};
  return "rims: " + std::to_string(count->held) + " of " + std::to_string(count->rims) + " stay";
}

std::string walls_text(const Document& document) {
  return describe(document.opened().state.walls);
}

std::string noise_text(const Document& document) {
  if (document.noise().is_asking()) return "measuring the noise…";
  const auto& proposal = document.noise().proposal();
  if (!proposal) return {};
  return "noise about " + length_text(proposal->noise, document.unit()) +
         (proposal->filter.is_on() ? "" : ": too little to take away");
}

std::string seams_text(const Document& document) {
  return document.levels_seams() ? "levelling seams…" : std::string();
}

std::vector<Figure> ruler_figures(const Document& document) {
  const Ruler& ruler = document.measuring().ruler;
  const auto length = ruler.length();
  if (!length) return {};
  return {
      {"distance", length_text(*length, document.unit(), kRulerDigits)},
      {"on the original", length_text(*ruler.original_length(), document.unit(), kRulerDigits)}};
}

}  // namespace burnish
