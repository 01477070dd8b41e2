#include "client/tools/ruler.h"

namespace burnish {

void Ruler::put(const End& end) {
  if (ends_.size() == 2) ends_.clear();
  ends_.push_back(end);
}

std::optional<double> Ruler::length() const {
  if (ends_.size() < 2) return std::nullopt;
  return (ends_[1].edited - ends_[0].edited).norm();
}

std::optional<double> Ruler::original_length() const {
  if (ends_.size() < 2) return std::nullopt;
  return (ends_[1].original - ends_[0].original).norm();
}

}  // namespace burnish
