#include "mlab/cli/batch_options.h"

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "mlab/cli/option_groups.h"
#include "mlab/study/definition.h"

namespace mlab::cli {

void add_batch(CLI::App& app, BatchOptions& o) {
  CLI::App* c = app.add_subcommand(
      "batch",
      "Carry out a mission many times, over seeds and values of its parameters, on all processors; a table\n"
      "and a page of what came out (docs/batch.md). Questions are answered with yes. Exit status 0: done, "
      "and\n"
      "all requirements are met; 1: one is not met, or it was interrupted; 2: something can't be read.");
  c->add_option("file", o.file, "the mission, or the definition of a batch")
      ->required()
      ->type_name("MISSION.mdl|STUDY.toml");
  for (const study::Field& field : study::fields()) {
    if (field.name == "mission") continue;
    const std::string name(field.name);
    c->add_option_function<std::vector<std::string>>(
         "--" + name,
         [&o, name](const std::vector<std::string>& values) {
           for (const std::string& value : values) o.given.emplace_back(name, value);
         },
         std::string(field.help))
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(field.is_repeated ? CLI::MultiOptionPolicy::TakeAll
                                                : CLI::MultiOptionPolicy::Throw)
        ->type_name(std::string(field.value));
  }
  c->add_option("--threads", o.threads, "how many runs at once; the result is the same for any number")
      ->capture_default_str()
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  c->add_flag("--resume", o.resumes, "go on with a batch that was interrupted");
  c->add_flag(
      "--merge", o.merges,
      "carry nothing out: the table and the page of what several processes have done, once all is done");
  c->add_option(
       "--rank", o.rank,
       "which of how many processes that do this batch together, from 0 on (default: as mpirun, srun "
       "and Slurm's arrays say); none: this one does all")
      ->type_name("R/N|none");
  c->add_flag("--strict", o.strict, "warnings keep the mission from running (exit status 1)");
  c->add_flag("--quiet", o.quiet, "print no progress and no table");
  c->add_flag("--allow-native", o.allow_native,
              "run executables that the mission names as robot programs, in cells (docs/security.md)");
  add_cell(c, o);
}

}  // namespace mlab::cli
