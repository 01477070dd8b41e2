#include "common/service/scan_info.h"

#include "common/base/text.h"

namespace burnish {

Status check_unit(std::string_view unit) {
  if (unit.empty()) return Status::ok();
  if (unit.size() > kUnitBytesMax)
    return invalid_argument("the scan's unit has " + std::to_string(unit.size()) +
                            " bytes, the limit is " + std::to_string(kUnitBytesMax));
  return check_name("the scan's unit", unit);
}

}  // namespace burnish
