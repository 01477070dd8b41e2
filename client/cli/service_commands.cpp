#include "client/cli/commands.h"

namespace burnish {

void add_service_commands(CommandTable& table) {
  add_import_command(table);
  add_meshes_command(table);
  add_describe_command(table);
  add_open_command(table);
  add_sessions_command(table);
  add_edit_command(table);
  add_protect_command(table);
  add_undo_command(table);
  add_redo_command(table);
  add_history_command(table);
  add_checkpoint_command(table);
  add_fork_command(table);
  add_people_command(table);
  add_export_command(table);
  add_publish_command(table);
  add_deviation_command(table);
  add_section_command(table);
  add_unit_command(table);
  add_bench_command(table);
  add_close_command(table);
  add_delete_command(table);
  add_rename_command(table);
}

}  // namespace burnish
