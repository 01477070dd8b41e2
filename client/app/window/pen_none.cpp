#include "client/app/window/pen.h"

namespace burnish {

std::optional<double> Pen::begin() {
  return std::nullopt;
}

std::optional<double> Pen::go_on() {
  return std::nullopt;
}

std::string Pen::lack() {
  return "this program was built without libXi";
}

}  // namespace burnish
