#pragma once

#include <string>
#include <vector>

#include "client/model/documents/document.h"
#include "client/scene/up_axis.h"

namespace burnish {

/// A name and a value, both in words for users.
struct Figure {
  std::string name;
  std::string value;
};

/// Returns "converging", "saving", "settled" or "exact" for a session that is live, and
/// "waiting for the first frame".
const char* state_word(const Document& document);

/// How the solver and the link do. Needs: a first frame.
std::vector<Figure> link_figures(const Document& document);

/// How far the surface has moved, and how far upwards; empty until it is measured.
std::vector<Figure> deviation_figures(const Document& document, UpAxis up);

/// Says how many of the scan's rims stay; empty where none is known.
std::string rims_text(const Document& document);

/// Says how much of the scan is on thin walls; empty where nothing is told.
std::string walls_text(const Document& document);

/// Says how large the scan's noise is, or that it is being measured; empty before anybody asks.
std::string noise_text(const Document& document);

/// Says that the server levels the seams of pictures for this view; else empty.
std::string seams_text(const Document& document);

/// The ruler's distances; empty until it has two ends.
std::vector<Figure> ruler_figures(const Document& document);

}  // namespace burnish
