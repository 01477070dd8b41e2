#include "common/edit/colour_filter.h"

#include <cstdio>

#include "common/edit/transfer_curve.h"

namespace burnish {

std::string text_of(const ColourFilter& filter) {
  char text[80];
  std::snprintf(text, sizeof text, "colours at beta %g, alpha %g", filter.beta, filter.alpha);
  return text;
}

Status check_colour_filter(const ColourFilter& filter) {
  RETURN_IF_ERROR(check_beta(filter.beta).with_context("colours"));
  return check_alpha(filter.alpha).with_context("colours");
}

}  // namespace burnish
