#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>

#include "client/app/dialogs/export_dialog.h"
#include "client/app/dialogs/file_dialog.h"
#include "client/app/dialogs/preferences_dialog.h"
#include "client/app/overlay/colour_bar.h"
#include "client/app/overlay/hud.h"
#include "client/app/overlay/section_window.h"
#include "client/app/overlay/toasts.h"
#include "client/app/panels/panels.h"
#include "client/app/start/start_page.h"
#include "client/app/window/window.h"
#include "client/app/window/window_renderer.h"
#include "client/gl/fence.h"
#include "client/model/input/bindings.h"
#include "client/model/workspace/leaving.h"
#include "client/model/workspace/letters.h"
#include "client/model/workspace/workspace.h"

namespace burnish {

struct AppOptions {
  std::filesystem::path scan;    ///< file to import and open; empty: none
  std::string server;            ///< empty: the private server if there is something to open
  std::string session;           ///< session to join, or the name of the new session
  ImageSize size;                ///< of the window; 0x0: as in the last run
  uint64_t triangles_max = 0;    ///< of a picture; 0: as many as the graphics card draws well
  double scale = 0;              ///< 0: from the configuration, else from the screen
  std::filesystem::path record;  ///< script file that records the user's actions; empty: none
  std::filesystem::path places;  ///< file for the places of widgets; empty: none
  WorkspaceOptions workspace;
};

/// The window around a Workspace: takes events, draws pictures.
class App {
 public:
  /// Runs until the window is closed. Fails: unavailable (no display or driver),
  /// failed_precondition (ended by a signal before all edits were saved), and as the renderer does.
  static Status run(AppOptions options, Preferences preferences);

 private:
  App(AppOptions options, Bindings bindings)
      : options_(std::move(options)), bindings_(std::move(bindings)) {}
  Status start(Preferences preferences);
  Status loop();
  double seconds_to_wait(int pictures);
  bool may_draw();
  bool may_close();
  bool is_picture_fine() const;
  std::string title() const;
  void show_title();
  WindowLook look_of(const Preferences& preferences) const;
  void show_look();
  void open_what_was_asked();
  WindowEvents make_events();
  void take_pen(std::optional<double> pressure);
  void handle_key(const std::string& key);
  void do_action(Action action);
  void take_screenshot(const std::filesystem::path& file);
  void save_picture_at_rest(std::chrono::steady_clock::time_point now);
  Result<Image> picture_without_rings();
  void ask_for_scan();
  void ask_for_picture();
  void open_files(const std::vector<std::filesystem::path>& files);

  Status draw();
  bool shows_surface() const;
  void show_picture();
  Status update_surface(std::chrono::steady_clock::time_point now);
  Status draw_surface(std::chrono::steady_clock::time_point begun_at);
  bool is_slower_than_moving() const;
  bool is_surface_at_rest() const;
  bool keeps_raw_picture() const;
  void draw_panels();
  void draw_menu_bar();
  void draw_picture_menu();
  void draw_undo_items();
  void menu_item(const char* name, Action action, bool enabled = true,
                 const std::string& what = {});
  void draw_camera_menu();
  void draw_depth_menu();
  void draw_start_page();
  void draw_session_page();
  void draw_columns(float top, float left, float right);
  void draw_sides() const;
  void draw_trial() const;
  void draw_lasso() const;
  void draw_overlays();

  bool is_in_picture(const Eigen::Vector2d& pixel) const;
  Eigen::Vector2d in_picture(const Eigen::Vector2d& pixel) const;

  AppOptions options_;
  Bindings bindings_;
  std::atomic<bool> news_{true};
  bool is_idle_ = false;  // nothing has happened since the last pictures
  std::string title_;     // of the window
  std::unique_ptr<Window> window_;
  std::unique_ptr<WindowRenderer> renderer_;
  std::unique_ptr<Workspace> workspace_;

  StartPage start_page_;
  FilterPanel filter_panel_;
  CurvePanel curve_panel_;
  EqualiserPanel equaliser_panel_;
  PalettePanel palette_panel_;
  HistoryPanel history_panel_;
  PeoplePanel people_panel_;
  NumbersPanel numbers_panel_;
  FiguresPanel figures_panel_;
  ColourBar colour_bar_;
  SectionWindow section_window_;
  Hud hud_;
  Toasts toasts_;
  ExportDialog export_dialog_;
  FileDialog file_dialog_;
  PreferencesDialog preferences_dialog_;
  double scale_at_start_ = 0;  // of the preferences
  Letters letters_;
  std::string missing_letters_;      // that the user knows of
  std::filesystem::path open_next_;  // file to open once the session is left
  Leaving leaving_;
  Leaving::Step leave_step_ = Leaving::Step::kStay;
  bool shows_hud_ = true;
  bool shows_log_ = false;
  bool shows_help_ = false;
  bool shows_about_ = false;
  bool has_picture_menu_ = false;

  /// The picture's place in the framebuffer, in pixels from the upper left corner.
  struct Area {
    int x = 0, y = 0;
    ImageSize size;
  };
  Area picture_;

  /// State that the renderer's picture shows. While it is the same, nothing is drawn again.
  struct Shown {
    uint64_t surface = 0;  // counts Workspace::pictures_begun()
    bool is_raw = false;
    uint64_t changes = 0;
    ImageSize size;
    Camera camera;
    DrawStyle style;
    bool is_smooth = true;
    bool operator==(const Shown&) const = default;
  };
  Shown next_shown() const;
  Shown shown_;

  /// A picture that the user saves waits for full detail, but not for ever.
  struct WantedPicture {
    std::filesystem::path file;
    std::chrono::steady_clock::time_point until;
  };
  std::optional<WantedPicture> wanted_picture_;
  bool is_surface_new_ = false;                       // the window does not show it yet
  std::chrono::steady_clock::time_point changed_at_;  // but for smoothness
  std::optional<std::chrono::steady_clock::time_point> begun_at_;  // the card draws that picture
  Fence drawn_;                                                    // behind it
};

}  // namespace burnish
