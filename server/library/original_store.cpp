#include "server/library/original_store.h"

#include <spdlog/spdlog.h>

namespace burnish {

Status told_apart(const Status& status, const std::string& store, const std::string& what,
                  const ScanInfo& scan) {
  if (status.is_ok() || status.code() == StatusCode::kCancelled) return status;
  spdlog::error("{}: {}", store, status.message());
  const bool is_damage =
      status.code() == StatusCode::kDataLoss || status.code() == StatusCode::kNotFound;
  if (!is_damage) return {status.code(), what + " scan " + scan.name + " failed; see the log"};
  return data_loss("the original of scan " + scan.name + " in the " + store +
                   " is damaged or missing; import the same file again");
}

Progress as_phase(const char* phase, const Progress& progress) {
  return [phase, &progress](std::string_view, double fraction) {
    return report(progress, phase, fraction);
  };
}

}  // namespace burnish
