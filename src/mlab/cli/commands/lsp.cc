#include <unistd.h>

#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/cli/output.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/version.h"
#include "mlab/lsp/server.h"

namespace mlab::cli {

int lsp() {
  lsp::Options options;
  options.version = kVersion;
  options.around = surroundings({});
  options.permission = [](bool is_trusted) { return permission_to_check(is_trusted, false); };
  options.library_folder = library_folder();
  return lsp::serve(std::move(options), STDIN_FILENO, write_output_now);
}

}  // namespace mlab::cli
