#include "server/library/scan_names.h"

#include <utility>

#include "server/library/kept_name.h"

namespace burnish {

ScanNames::Hold::~Hold() {
  if (!state_) return;
  const std::lock_guard lock(state_->mutex);
  state_->given.erase(look_);
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
    const bool is_going = state_->given.contains(look);
    if (other == others.end() && !is_going) {
      state_->given.insert(look);
      return Hold(state_, wanted, std::move(look));
    }
    if (exact && is_going)
      return already_exists("the name '" + name +
                            "' is being given to another scan; choose another");
    if (exact) return has_name(other->second, name);
  }
}

}  // namespace burnish
