#include "client/cli/filter/filter_outcomes.h"

#include <algorithm>
#include <cctype>
#include <iostream>

#include "client/cli/print_json.h"

namespace burnish {

using nlohmann::ordered_json;

/// The code as gRPC writes it: "INVALID_ARGUMENT".
static std::string code_of(const Status& status) {
  if (status.code() == StatusCode::kInternal) return "INTERNAL";
  std::string name = status_code_name(status.code());
  for (char& letter : name)
    letter =
        letter == ' ' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return name;
}

static void add_facts(const FilteredFacts& facts, ordered_json& json) {
  add_fields(facts, json);
  json["volume"] = facts.volume ? ordered_json(*facts.volume) : ordered_json();
  json["seconds"] = facts.seconds;
  json["left_out"] = facts.left_out;
  const PictureReport& pictures = facts.pictures;
  json["pictures"] = {{"edited", pictures.pictures},
                      {"changed", pictures.changed},
                      {"texels", pictures.texels},
                      {"shared_texels", pictures.shared_texels},
                      {"bare_triangles", pictures.bare_triangles},
                      {"kept", pictures.kept},
                      {"notes", pictures.notes}};
  if (pictures.seams) json["pictures"]["seams"] = json_of<ordered_json>(*pictures.seams);
}

static void add_failure(const Status& status, ordered_json& json) {
  json["code"] = code_of(status);
  json["message"] = status.message();
}

static ordered_json outcome_to_json(const FilterOutcome& outcome) {
  ordered_json json = {{"in", outcome.job.in}, {"out", outcome.job.out}};
  switch (outcome.end) {
    case FilterEnd::kDone:
      json["outcome"] = "done";
      add_facts(outcome.facts, json);
      break;
    case FilterEnd::kSkipped:
      json["outcome"] = "skipped";
      break;
    case FilterEnd::kFailed:
      json["outcome"] = "failed";
      add_failure(outcome.status, json);
      break;
  }
  return json;
}

std::string json_of(const FilterOutcome& outcome) {
  return outcome_to_json(outcome).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

void print_outcome(const FilterOutcome& outcome) {
  std::ostream& stream = outcome.job.out == kStandardStream ? std::cerr : std::cout;
  if (outcome.end == FilterEnd::kSkipped) {
    stream << outcome.job.out << " is there already: skipped\n";
    return;
  }
  const FilteredFacts& facts = outcome.facts;
  stream << outcome.job.out << ": depth " << facts.depth << ", " << facts.corners << " corners, "
         << facts.cycles << " cycles, estimated distance " << facts.distance
         << " of the diagonal\n";
  if (const std::string pictures = text_of(facts.pictures); !pictures.empty())
    stream << outcome.job.out << ": " << pictures << "\n";
}

void print_outcomes_json(const std::vector<FilterOutcome>& outcomes, const Status& begun) {
  ordered_json json = {{"files", ordered_json::array()}};
  for (const FilterOutcome& outcome : outcomes) json["files"].push_back(outcome_to_json(outcome));
  if (!begun.is_ok()) add_failure(begun, json);
  print_json(json);
}

Status status_of(const std::vector<FilterOutcome>& outcomes) {
  if (outcomes.size() == 1) return outcomes[0].status;
  const auto failed = std::count_if(outcomes.begin(), outcomes.end(),
                                    [](const auto& one) { return one.end == FilterEnd::kFailed; });
  if (failed == 0) return Status::ok();
  return invalid_argument(std::to_string(failed) + " of " + std::to_string(outcomes.size()) +
                          " files failed");
}

}  // namespace burnish
