#pragma once

#include <string>
#include <vector>

#include "client/app/panels/strength_pictures.h"
#include "client/app/widgets/panel.h"
#include "client/tools/presets.h"

namespace burnish {

/// Gradient scale, fidelity and presets: the edit outside of painted areas.
class FilterPanel : public Panel {
 public:
  void draw(Workspace& workspace) override;

 private:
  void draw_presets(Workspace& workspace);
  void draw_strength(Workspace& workspace, const PresetInForce& shown);
  void draw_delete(const Document& document, MessageLog& log);
  void draw_own(const Document& document, MessageLog& log);
  void read_own(MessageLog& log);

  std::vector<Preset> own_;  // read when the list opens
  std::string own_name_;     // for the filter as it is
  StrengthPictures pictures_;
};

/// The transfer curve over the histogram of curvature.
class CurvePanel : public Panel {
 public:
  void draw(Workspace& workspace) override;
};

/// Gains by the size of detail, over a plot of what they do.
class EqualiserPanel : public Panel {
 public:
  void draw(Workspace& workspace) override;

 private:
  bool shows_sizes_ = false;
};

/// The curves that a brush can paint.
class PalettePanel : public Panel {
 public:
  void draw(Workspace& workspace) override;

 private:
  std::string name_;  // of the next curve
};

/// The session's edits, newest first. Each can be switched off.
class HistoryPanel : public Panel {
 public:
  void draw(Workspace& workspace) override;

 private:
  void draw_buttons(Document& document);
  void draw_checkpoint_row(Workspace& workspace);

  std::string checkpoint_name_;
};

/// Lengths in the scan's unit: how far the surface moved, distances, sections.
class NumbersPanel : public Panel {
 public:
  void draw(Workspace& workspace) override;

 private:
  void draw_unit(Document& document);

  std::string session_;  // that unit_ is of
  std::string unit_;     // as it is typed
};

/// The people in the session and their roles.
class PeoplePanel : public Panel {
 public:
  void draw(Workspace& workspace) override;
};

}  // namespace burnish
