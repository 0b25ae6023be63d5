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
#include "mlab/study/page.h"
#include "mlab/study/study_file.h"
#include "mlab/study/summary.h"
#include "mlab/study/table.h"

namespace mlab::cli {
namespace {

namespace fs = std::filesystem;

int wrong_usage(const std::string& message) {
  fmt::print(stderr, "mlab batch: {}\n", message);
  return kBadInput;
}

// What the command line says counts more than what the file says.
void give_way(study::Definition& definition, const study::Dimension& given) {
  std::erase_if(definition.dimensions,
                [&](const study::Dimension& one) { return one.name.text == given.name.text; });
}

// The definition out of file and options. Nothing where it can't be understood, which is told.
std::optional<study::Definition> definition_of(const BatchOptions& options) {
  study::Definition out;
  text::Diagnostics sink;
  if (study::is_study_file(options.file)) {
    if (const auto source = text::read_source(options.file))
      study::read_study(*source, out, sink);
    else
      sink.report(source.error());
  } else if (auto problem = study::take(out, "mission", study::written_in_option("MISSION", options.file))) {
    sink.report(std::move(*problem));
  }
  for (const auto& [field, value] : options.given) {
    study::Definition one;
    const study::Written written = study::written_in_option("--" + field, value);
    auto problem = study::take(one, field, written);
    if (!problem && field == "set") give_way(out, one.dimensions.front());
    if (!problem) problem = study::take(out, field, written);
    if (problem) sink.report(std::move(*problem));
  }
  if (!sink.has_errors()) {
    if (auto problem = study::settle(out)) sink.report(std::move(*problem));
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

// One mission clock for all runs, also for those of a batch that is resumed.
bool settle_clock(study::Definition& definition, const std::string& results, bool resumes) {
  if (definition.start_time.empty() && resumes && !results.empty())
    definition.start_time = study::ResultsFile::kept_word(results, "start-time").value_or("");
  const auto clock = definition.start_time.empty() ? wall_clock() : parse_start_time(definition.start_time);
  if (!clock) {
    wrong_usage(fmt::format("start-time {}: expected YYYY-MM-DD HH:MM or YYYY-MM-DD HH:MM:SS",
                            definition.start_time));
    return false;
  }
  definition.start_time = print(*clock);
  return true;
}

// What is written can be, and is nothing that is read.
bool outputs_are_usable(const study::Definition& definition, const std::string& study_file,
                        const std::string& results) {
  const std::pair<const char*, std::string> outputs[] = {
      {"--table", definition.table}, {"--html", definition.page}, {"--results", results}};
  const std::pair<const char*, std::string> inputs[] = {
      {"mission", definition.mission.text},
      {"mission of --against", definition.against.text},
      {"file of --environment", definition.environment.text},
      {"definition", study_file}};
  std::vector<std::string> seen;
  for (const auto& [option, file] : outputs) {
    if (file.empty()) continue;
    for (const auto& [what, input] : inputs) {
      std::error_code unreadable;
      if (input.empty() || !fs::equivalent(file, input, unreadable)) continue;
      wrong_usage(
          fmt::format("{} {}: that is the {} itself, which would be overwritten", option, file, what));
      return false;
    }
    if (std::ranges::find(seen, file) != seen.end()) {
      wrong_usage(fmt::format("{} {}: another file goes there as well", option, file));
      return false;
    }
    if (!is_writable(file)) {
      wrong_usage(fmt::format("{} {}: the file can't be written", option, file));
      return false;
    }
    seen.push_back(file);
  }
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

// All that its runs hang on.
study::Identity identity_of(const study::Definition& d, std::uint64_t texts) {
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
          {"environment", d.environment.text},
          {"texts", fmt::format("{:016x}", texts)}};
}

cell::Permission permission_of(const BatchOptions& options, const study::Definition& definition) {
  RunOptions run;
  run.allow_native = options.allow_native;
  run.no_cell = options.no_cell;
  return permission_to_run(run, cell::Grounds::People::kHere,
                           fs::path(definition.mission.text).parent_path().string());
}

bool deliver_file(const char* what, const std::string& file, const std::string& text) {
  if (write_file(file, text)) {
    fmt::print("{}: {}\n", what, file);
    return true;
  }
  fmt::print(stderr, "mlab batch: the {} {} could not be written\n", what, file);
  return false;
}

bool deliver_all(const study::Batch& batch, const study::Summary& summary,
                 const study::Definition& definition, const study::Plan& plan, const std::string& title) {
  bool is_whole = true;
  if (!definition.table.empty()) {
    const bool is_json = fs::path(definition.table).extension() == ".json";
    is_whole &= deliver_file("table", definition.table,
                             is_json ? study::json_of(batch, summary, definition, plan, kVersion)
                                     : study::csv_of(batch, definition, plan));
  }
  if (!definition.page.empty())
    is_whole &= deliver_file("page", definition.page,
                             study::page_of(batch, summary, definition, plan, {title, kVersion}));
  return is_whole;
}

// The runs themselves, and what is told meanwhile.
study::Batch::End carry_out(study::Batch& batch, const BatchOptions& options) {
  BatchProgress progress(options.quiet);
  // A second Ctrl-C ends the process at once, whatever the threads do.
  note_interrupts();
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

int run_batch(const BatchOptions& options, const study::Definition& definition, const std::string& results) {
  const study::Plan plan(definition);
  text::Diagnostics sink;
  const Scenes scenes = scenes_of(definition, plan, permission_of(options, definition), options.limits, sink);
  tell(sink);
  if (scenes.all.empty()) return kBadInput;
  if (options.strict && sink.warning_count() > 0) {
    fmt::print(stderr, "mlab batch: not run, because of {} and --strict\n",
               base::counted(sink.warning_count(), "warning"));
    return kFailed;
  }
  std::unique_ptr<study::ResultsFile> kept;
  std::vector<study::Row> before;
  if (!results.empty()) {
    auto opened = study::ResultsFile::open(results, identity_of(definition, scenes.texts), options.resumes);
    if (!opened) return wrong_usage(fmt::format("{} {}", results, opened.error()));
    kept = std::move(opened->file);
    before = std::move(opened->rows);
  }
  study::Batch batch(definition, plan, scenes.all, kept.get());
  batch.take(std::move(before));
  const double began = steady_seconds();
  const study::Batch::End end = carry_out(batch, options);
  if (end != study::Batch::End::kDone) return tell_unfinished(end, results, batch.progress());
  const study::Summary summary = study::summary_of(batch, definition, plan);
  if (!options.quiet)
    print_summary(summary, definition, plan, scenes.all.front()->mission_name(), steady_seconds() - began);
  print_verdicts(summary);
  if (!deliver_all(batch, summary, definition, plan, scenes.all.front()->mission_name())) return kFailed;
  // It was for who would have had to go on.
  std::error_code failure;
  if (kept && definition.results.empty()) fs::remove(results, failure);
  return summary.are_all_met() ? kDone : kFailed;
}

}  // namespace

int batch(const BatchOptions& options) {
  if (is_standard_input(options.file))
    return wrong_usage("standard input can't be read again and again: expected a file");
  std::optional<study::Definition> definition = definition_of(options);
  if (!definition) return kBadInput;
  const std::string results = results_of(*definition);
  if (options.resumes && results.empty())
    return wrong_usage("--resume: which batch? It is kept beside --table or --html, or in --results");
  const std::string study_file = study::is_study_file(options.file) ? options.file : "";
  if (!settle_clock(*definition, results, options.resumes) ||
      !outputs_are_usable(*definition, study_file, results))
    return kBadInput;
  return run_batch(options, *definition, results);
}

}  // namespace mlab::cli
