#pragma once

#include "client/cli/command.h"

namespace burnish {

// One function per command of `burnish`, each in its own file; main() calls them.

void add_generate_command(CommandTable& table);
void add_filter_command(CommandTable& table);
void add_watch_command(CommandTable& table);
void add_presets_command(CommandTable& table);

/// Adds nothing in a build without OpenGL.
void add_render_command(CommandTable& table);

/// Adds the commands that talk to a server; adds nothing in a build without gRPC.
void add_service_commands(CommandTable& table);

void add_import_command(CommandTable& table);
void add_meshes_command(CommandTable& table);
void add_describe_command(CommandTable& table);
void add_open_command(CommandTable& table);
void add_sessions_command(CommandTable& table);
void add_edit_command(CommandTable& table);
void add_protect_command(CommandTable& table);
void add_undo_command(CommandTable& table);
void add_redo_command(CommandTable& table);
void add_history_command(CommandTable& table);
void add_checkpoint_command(CommandTable& table);
void add_fork_command(CommandTable& table);
void add_people_command(CommandTable& table);
void add_export_command(CommandTable& table);
void add_publish_command(CommandTable& table);
void add_deviation_command(CommandTable& table);
void add_section_command(CommandTable& table);
void add_unit_command(CommandTable& table);
void add_bench_command(CommandTable& table);
void add_close_command(CommandTable& table);
void add_delete_command(CommandTable& table);
void add_rename_command(CommandTable& table);

}  // namespace burnish
