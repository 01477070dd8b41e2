#include "server/library/scan_names.h"

#include <utility>

#include "server/library/kept_name.h"

namespace burnish {

ScanNames::Hold::~Hold() {
  if (!state_) return;
  const std::lock_guard lock(state_->mutex);
  const auto given = state_->given.find(look_);
  if (--given->second.holds == 0) state_->given.erase(given);
}

static Status has_name(const ScanInfo& other, const std::string& name) {
  static constexpr char kAdvice[] = "; choose another name, or rename or delete that scan";
  if (other.name == name)
    return already_exists("scan " + short_id(other.id) + " has the name '" + name + "'" + kAdvice);
  return already_exists("the name '" + name + "' looks like '" + other.name + "', scan " +
                        short_id(other.id) + kAdvice);
}

Status check_name_is_free(const ScanInfo& scan, const std::vector<ScanInfo>& others) {
  const std::string look = look_of_name(scan.name);
  for (const ScanInfo& other : others)
    if (other.id != scan.id && look_of_name(other.name) == look) return has_name(other, scan.name);
  return Status::ok();
}

Result<ScanNames::Hold> ScanNames::hold(const std::string& id, const std::string& name,
                                        bool exact) {
  if (exact) RETURN_IF_ERROR(check_scan_name(name));
  const std::lock_guard lock(state_->mutex);
  const auto others = index_.by_look(id);
  for (int number = 1;; ++number) {
    const std::string wanted = exact ? name : numbered_scan_name(name, number);
    std::string look = look_of_name(wanted);
    const auto other = others.find(look);
    const auto given = state_->given.find(look);
    const bool is_going = given != state_->given.end() && (!exact || given->second.id != id);
    if (other == others.end() && !is_going) {
      state_->given.try_emplace(look, id).first->second.holds += 1;
      return Hold(state_, wanted, std::move(look));
    }
    if (exact && is_going)
      return already_exists("the name '" + name +
                            "' is being given to another scan; choose another");
    if (exact) return has_name(other->second, name);
  }
}

}  // namespace burnish
