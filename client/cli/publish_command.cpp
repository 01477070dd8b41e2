#include <cstdio>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/interrupt.h"
#include "client/cli/print_json.h"
#include "client/cli/progress_printer.h"
#include "client/cli/server_option.h"
#include "client/publish/publication.h"

namespace burnish {

namespace {

struct PublishOptions {
  ServerOption server;
  PublishWish wish;
};

void print(const Publication& made, const PublishOptions& options) {
  const std::string folder = options.wish.folder.string();
  if (options.server.json)
    return print_json({{"folder", folder},
                       {"files", made.files},
                       {"bytes", made.bytes},
                       {"pages", made.pages},
                       {"triangles", made.triangles},
                       {"textures", made.has_textures}});
  std::printf("%s: %llu triangles, %llu files, %llu bytes\n", folder.c_str(),
              static_cast<unsigned long long>(made.triangles),
              static_cast<unsigned long long>(made.files),
              static_cast<unsigned long long>(made.bytes));
}

Status run(const PublishOptions& options) {
  ASSIGN_OR_RETURN(Connection connection, options.server.connect());
  const Interrupt interrupt;
  ProgressPrinter printer;
  const auto made = publish(connection, options.wish, Interrupt::cancelling(printer.progress()));
  if (!made.is_ok()) return made.status().with_context("publishing " + options.wish.session);
  print(*made, options);
  return Status::ok();
}

}  // namespace

void add_publish_command(CommandTable& table) {
  auto options = std::make_shared<PublishOptions>();
  PublishWish& wish = options->wish;
  CLI::App* command =
      table.add("publish", "Write a folder that shows a session in browsers, from any web server",
                [options] { return run(*options); });
  const auto text = [](const char* what) {
    return
        [what](const std::string& said) { return usage_message(check_published_text(what, said)); };
  };
  command->add_option("SESSION", wish.session, "Name or id")->required();
  command->add_option("DIR", wish.folder, "Folder to write; made if it is not there")->required();
  command->add_option("--title", wish.title, "Heading of the page: the session's name if absent")
      ->check(text("the title"));
  command
      ->add_option("--credit", wish.credit, "Line under the picture: who made it, and the licence")
      ->check(text("the credit"));
  command->add_flag("--replace", wish.replace, "Take the place of a publication in DIR");
  add_server_options(*command, options->server);
}

}  // namespace burnish
