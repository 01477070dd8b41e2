#include "server/rpc/admission/admission.h"

#include "server/rpc/admission/refusals.h"

namespace burnish {

Status Admission::admit(std::string_view method, const Proof& proof, std::string_view peer) const {
  const Status status = guard_->check(method, proof).status();
  if (status.is_ok()) {
    ++counts_->arrived;
  } else {
    report_refusal(method, peer, status);
  }
  return status;
}

}  // namespace burnish
