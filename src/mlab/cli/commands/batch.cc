#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/cli/batch_outputs.h"
#include "mlab/cli/batch_rank.h"
#include "mlab/cli/batch_screen.h"
#include "mlab/cli/batch_study.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/input.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/places.h"
#include "mlab/cli/terminal.h"
#include "mlab/cli/version.h"
#include "mlab/study/batch.h"
#include "mlab/study/shared_results.h"
#include "mlab/study/study_file.h"
#include "mlab/study/summary.h"

namespace mlab::cli {
namespace {

namespace fs = std::filesystem;

// What the command line says counts more than what the file says. What is wrong in it is told where it is
// taken.
void give_way(study::Definition& of_file, const BatchOptions& options) {
  for (const auto& [field, value] : options.given) {
    if (field != "set") continue;
    study::Definition given;
    if (study::take(given, field, study::written_in_option("--set", value))) continue;
    std::erase_if(of_file.dimensions, [&](const study::Dimension& one) {
      return one.name.text == given.dimensions.front().name.text;
    });
  }
}

// The definition out of file and options. Nothing where it can't be understood, which is told.
std::optional<study::Definition> definition_of(const BatchOptions& options) {
  study::Definition out;
  text::Diagnostics sink;
  text::SourcePtr source;  // null: there is no file but the mission's
  if (study::is_study_file(options.file)) {
    if (auto read = text::read_source(options.file)) {
      source = *std::move(read);
      study::read_study(source, out, sink);
    } else {
      sink.report(read.error());
    }
  } else if (auto problem = study::take(out, "mission", study::written_in_option("MISSION", options.file))) {
    sink.report(std::move(*problem));
  }
  give_way(out, options);
  for (const auto& [field, value] : options.given) {
    if (auto problem = study::take(out, field, study::written_in_option("--" + field, value)))
      sink.report(std::move(*problem));
  }
  if (!sink.has_errors()) {
    if (auto problem = study::settle(out)) {
      if (!problem->place.source) problem->place = {source, {0, 0}};
      sink.report(std::move(*problem));
    }
  }
  tell(sink);
  if (sink.has_errors()) return std::nullopt;
  return out;
}

// Where runs are kept until all are done; empty: nowhere.
std::string results_of(const study::Definition& definition) {
  if (!definition.results.empty()) return definition.results;
  const std::string& beside = !definition.table.empty() ? definition.table : definition.page;
  return beside.empty() ? "" : beside + ".runs";
}

// As it is printed; nothing where it is no time, which is told.
bool read_start_time(study::Definition& definition) {
  if (definition.start_time.empty()) return true;
  if (const auto problem = wrong_start_time(definition)) {
    tell(*problem);
    return false;
  }
  definition.start_time = print(*parse_start_time(definition.start_time));
  return true;
}

std::string text_of(const std::vector<study::Dimension>& dimensions) {
  std::string out;
  for (const study::Dimension& one : dimensions) {
    out += fmt::format("{}{}=", out.empty() ? "" : "; ", one.name.text);
    if (one.is_drawn()) out += study::shortest(one.low) + ".." + study::shortest(one.high);
    for (const study::Written& value : one.values)
      out += (&value == &one.values.front() ? "" : ",") + value.text;
  }
  return out;
}

// All that its runs hang on, but for what is read.
study::Identity identity_of(const study::Definition& d) {
  const auto optional = [](const std::optional<double>& value) {
    return value ? study::shortest(*value) : "";
  };
  return {{"program", kVersion},
          {"mission", d.mission.text},
          {"against", d.against.text},
          {"seed", std::to_string(d.seed)},
          {"runs", std::to_string(d.runs)},
          {"set", text_of(d.dimensions)},
          {"combine", d.is_paired ? "paired" : "crossed"},
          {"draw", d.is_latin ? "latin" : "random"},
          {"success", d.success ? d.success->text() : ""},
          {"start-time", d.start_time},
          {"patience", study::shortest(d.patience)},
          {"limit", optional(d.limit)},
          {"for", optional(d.duration)},
          {"environment", d.environment.text}};
}
study::Identity identity_of(const study::Definition& d, std::uint64_t texts) {
  study::Identity out = identity_of(d);
  out.emplace_back("texts", fmt::format("{:016x}", texts));
  return out;
}

cell::Permission permission_of(const BatchOptions& options, const study::Definition& definition) {
  RunOptions run;
  run.allow_native = options.allow_native;
  run.no_cell = options.no_cell;
  return permission_to_run(run, cell::Grounds::People::kHere,
                           fs::path(definition.mission.text).parent_path().string());
}

// The runs themselves, and what is told meanwhile.
study::Batch::End carry_out(study::Batch& batch, const BatchOptions& options) {
  BatchProgress progress(options.quiet);
  const study::Batch::End end =
      batch.run(options.threads, was_interrupted, [&](const study::Progress& now) { progress.show(now); });
  progress.clear();
  return end;
}

int tell_unfinished(study::Batch::End end, const std::string& results, const study::Progress& progress) {
  if (end == study::Batch::End::kNotKept) {
    fmt::print(stderr, "mlab batch: {} could not be written; no more runs are begun\n", results);
    return kFailed;
  }
  fmt::print(stderr, "mlab batch: interrupted after {} of {} runs; {}\n", progress.done, progress.all,
             results.empty() ? "nothing is kept without --table, --html or --results"
                             : fmt::format("they are kept in {}, and --resume goes on", results));
  return kFailed;
}

/// A batch that this process has a part in.
struct Part {
  study::Share share;
  std::string results;                           // empty: nothing is kept
  std::unique_ptr<study::SharedResults> shared;  // null: alone
  std::unique_ptr<study::ResultsFile> own;       // null: shared, or nothing is kept
  std::vector<study::Row> before;
  std::vector<std::string> damage;  // of what is kept, which counts all the same as far as it can be read

  study::Keeper* keeper() const { return shared ? static_cast<study::Keeper*>(shared.get()) : own.get(); }
};

// Where runs are kept, once all is known that they hang on. @return  false: it can't be, which is told
bool open_results(Part& part, const study::Identity& identity, bool resumes) {
  if (part.shared) {
    const auto problem = part.shared->begin(identity);
    if (problem) wrong_batch_usage(fmt::format("{} {}", part.results, *problem));
    return !problem;
  }
  if (part.results.empty()) return true;
  auto opened = study::ResultsFile::open(part.results, identity, resumes);
  if (!opened) {
    wrong_batch_usage(fmt::format("{} {}", part.results, opened.error()));
    return false;
  }
  part.own = std::move(opened->file);
  part.before = std::move(opened->rows);
  part.damage = std::move(opened->damage);
  return true;
}

// Several processes have done all runs, and this one is not to write.
int leave_to_others(const BatchOptions& options, const Part& part, std::uint64_t runs) {
  if (part.share.count > 1 && part.share.rank == 0 && !part.share.writes_table && !options.quiet)
    fmt::print("all {} are done; --merge writes the table and the page\n", base::counted(runs, "run"));
  return kDone;
}

int tell_missing(const study::Progress& progress) {
  fmt::print(
      stderr,
      "mlab batch: of {} runs {} are done: --merge writes the table once all are; --resume, in its place, "
      "does the rest\n",
      progress.all, progress.done);
  return kFailed;
}

// All runs are done, and not all causes are recorded.
int tell_unrecorded(const study::FailureRecordings& recordings, std::uint64_t runs,
                    const std::string& results) {
  const std::uint64_t causes = recordings.made + recordings.missing + recordings.problems.size();
  fmt::print(stderr, "mlab batch: interrupted after all {} with {} of {} of failure recorded; {}\n",
             base::counted(runs, "run"), recordings.made, base::counted(causes, "cause"),
             results.empty() ? "nothing is kept without --table, --html or --results"
                             : fmt::format("table and page are not written; the runs are kept in {}, and "
                                           "--resume goes on",
                                           results));
  return kFailed;
}

int conclude(const BatchOptions& options, const study::Definition& definition, const study::Plan& plan,
             const study::Batch& batch, const Scenes& scenes, Part& part, double seconds) {
  const std::string& title = scenes.all.front()->mission_name();
  study::Summary summary = study::summary_of(batch, definition, plan);
  const study::FailureRecordings recordings =
      deliver_recordings(batch, summary, definition, plan, scenes, part.keeper());
  if (!options.quiet) print_summary(summary, definition, plan, title, seconds);
  print_verdicts(summary);
  if (recordings.missing > 0) return tell_unrecorded(recordings, summary.runs, part.results);
  if (!deliver_all(batch, summary, recordings, definition, plan, title)) return kFailed;
  // It was for who would have had to go on.
  if (part.own && definition.results.empty()) part.own->finish();
  if (part.shared) part.shared->finish(!definition.results.empty());
  return summary.are_all_met() ? kDone : kFailed;
}

// What is only a warning is said by one of several processes.
void tell_of(const text::Diagnostics& sink, const Part& part) {
  if (part.share.rank == 0 || sink.has_errors()) tell(sink);
}

int run_batch(const BatchOptions& options, const study::Definition& definition, Part& part) {
  const study::Plan plan(definition);
  text::Diagnostics sink;
  const Scenes scenes = scenes_of(definition, plan, permission_of(options, definition), options.limits, sink);
  tell_of(sink, part);
  if (scenes.all.empty()) return kBadInput;
  if (options.strict && sink.warning_count() > 0) {
    fmt::print(stderr, "mlab batch: not run, because of {} and --strict\n",
               base::counted(sink.warning_count(), "warning"));
    return kFailed;
  }
  if (options.merges && !study::ResultsFile::keeps_runs(part.results)) {
    fmt::print(stderr,
               "mlab batch: no run of this batch is kept in {}: none is done yet, or table and page were "
               "written, and it was removed then\n",
               part.results);
    return kFailed;
  }
  if (!open_results(part, identity_of(definition, scenes.texts), options.resumes || options.merges))
    return kBadInput;
  if (part.share.rank == 0) {
    for (const std::string& one : part.damage) fmt::print(stderr, "mlab batch: {}\n", one);
  }
  study::Batch batch(definition, plan, scenes.all, part.keeper(), part.share);
  batch.take(std::move(part.before));
  const double began = steady_seconds();
  using End = study::Batch::End;
  // A second Ctrl-C ends the process at once, whatever the threads do.
  note_interrupts();
  if (options.merges) {
    if (!batch.is_complete()) return tell_missing(batch.progress());
  } else if (const End end = carry_out(batch, options); end == End::kOver) {
    return kDone;
  } else if (end != End::kDone) {
    return tell_unfinished(end, part.results, batch.progress());
  }
  if (!part.share.writes_table) return leave_to_others(options, part, batch.progress().done);
  return conclude(options, definition, plan, batch, scenes, part, steady_seconds() - began);
}

// One mission clock for all runs, also for those of a batch that is resumed, and of all processes that do it.
// @return  nothing: go on; else the exit status, and why was told
std::optional<int> settle_clock(study::Definition& definition, Part& part, bool resumes) {
  const std::string now = print(wall_clock());
  if (part.share.is_alone()) {
    if (definition.start_time.empty() && resumes && !part.results.empty())
      definition.start_time = study::ResultsFile::kept_word(part.results, "start-time").value_or("");
    if (definition.start_time.empty()) definition.start_time = now;
    return std::nullopt;
  }
  auto joined = study::SharedResults::join(part.results, identity_of(definition), now, part.share, resumes);
  if (!joined) return wrong_batch_usage(fmt::format("{} {}", part.results, joined.error()));
  if (!joined->results) {
    if (part.share.rank == 0)
      fmt::print(stderr, "mlab batch: this batch is done; to do it again, remove {}\n", part.results);
    return kDone;
  }
  part.shared = std::move(joined->results);
  part.damage = std::move(joined->damage);
  definition.start_time = joined->start_time;
  return std::nullopt;
}

std::optional<study::Share> share_of(const BatchOptions& options) {
  if (options.merges) return study::Share{};
  return options.rank.empty() ? share_from(environment()) : share_in(options.rank);
}

}  // namespace

int batch(const BatchOptions& given) {
  BatchOptions options = given;
  if (is_standard_input(options.file))
    return wrong_batch_usage("standard input can't be read again and again: expected a file");
  Part part;
  const auto share = share_of(options);
  if (!share)
    return wrong_batch_usage(fmt::format("--rank {}: expected 0/3, 1/3, 2/3, or none", options.rank));
  part.share = *share;
  options.quiet = options.quiet || part.share.rank > 0;
  std::optional<study::Definition> definition = definition_of(options);
  if (!definition || !read_start_time(*definition)) return kBadInput;
  part.results = results_of(*definition);
  if (options.resumes && options.merges)
    return wrong_batch_usage(
        "--resume goes on with what is missing, --merge carries nothing out: expected one of them");
  const bool resumes = options.resumes || options.merges;
  if (part.results.empty() && resumes)
    return wrong_batch_usage(
        "--resume, --merge: which batch? It is kept beside --table or --html, or in --results");
  if (part.results.empty() && !part.share.is_alone())
    return wrong_batch_usage(fmt::format(
        "this is one of {} processes: they share what they have done beside --table or --html, or in "
        "--results; with --rank none each does all",
        part.share.count));
  const std::string study_file = study::is_study_file(options.file) ? options.file : "";
  if (!outputs_are_usable(*definition, study_file, part.results)) return kBadInput;
  if (const auto status = settle_clock(*definition, part, resumes)) return *status;
  return run_batch(options, *definition, part);
}

}  // namespace mlab::cli
