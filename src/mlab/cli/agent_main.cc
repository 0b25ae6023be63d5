// `mlab-agent`: what `mlab agent` does, for machines that do nothing else.

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <google/protobuf/stubs/logging.h>

#include <CLI/CLI.hpp>

#include "mlab/cli/agent_options.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/output.h"
#include "mlab/cli/version.h"
#include "mlab/cli/wrong_words.h"

namespace mlab::cli {
namespace {

int parse_and_serve(int argc, char** argv) {
  CLI::App app(kAgentDescription, "mlab-agent");
  app.set_version_flag("--version", fmt::format("mlab-agent {}", kVersion));
  app.set_config("--config", "", "a file with these options, a line each: `fleet = \"alpha\"`")
      ->type_name("FILE");
  app.allow_config_extras(CLI::config_extras_mode::error);
  AgentOptions options;
  add_agent_options(&app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // help and version come this way, too
    tell_wrong_words(app, e, {argv + 1, argv + argc});
    return kBadInput;
  }
  return agent(options);
}

}  // namespace
}  // namespace mlab::cli

int main(int argc, char** argv) {
  try {
    mlab::cli::guard_output();
    google::protobuf::SetLogHandler(nullptr);  // what arrives may be anything, and is told of in our words
    return mlab::cli::output_status(mlab::cli::parse_and_serve(argc, argv));
  } catch (const std::exception& e) {
    fmt::print(stderr, "mlab-agent: {}\n", e.what());
    return mlab::cli::kFailed;
  }
}
