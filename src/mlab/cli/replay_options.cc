#include "mlab/cli/replay_options.h"

#include <cmath>
#include <string>

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include "mlab/cli/option_groups.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

// @return  what is wrong with it; empty: it is a moment of a run
std::string refuse_if_no_moment(const std::string& text) {
  double seconds = 0.0;
  const bool is_number = CLI::detail::lexical_cast(text, seconds);
  return is_number && std::isfinite(seconds) && seconds >= 0.0
             ? ""
             : fmt::format("expected simulated seconds, 0 or more, found `{}`", text::shown(text, 40));
}

void add_computing(CLI::App* c, int& threads, robot_host::Limits& limits) {
  c->add_option("--threads", threads,
                "how many threads step the robots; the result is the same for any number")
      ->capture_default_str()
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  add_cell_limits(c, limits);
}

CLI::Option* add_recording(CLI::App* c, ReplayOptions& o) {
  CLI::Option* out =
      c->add_option("recording", o.recording, "the file that `mlab run` has recorded")->type_name("RUN.mcap");
  add_computing(c, o.threads, o.limits);
  return out;
}

template <class Options>
void add_viewers(CLI::App* c, Options& o, CLI::Option* file) {
  auto* const record_for =
      c->add_option_function<std::string>(
           "--record-for", [&o](const std::string&) { o.records_for_viewers = true; },
           "viewers: beside the history put into the recording what Foxglove and Lichtblick show without "
           "configuration (docs/recording.md)")
          ->check(CLI::IsMember({"viewers"}))
          ->needs(file)
          ->type_name("viewers");
  c->add_option("--viewer-rate", o.viewer_rate, "poses for viewers in a simulated second")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 1000.0))
      ->needs(record_for)
      ->type_name("HZ");
}

}  // namespace

void add_record(CLI::App* c, RunOptions& o) {
  auto* const file =
      c->add_option("--record", o.record,
                    "record the run in this MCAP file, from which it is computed again (docs/recording.md); "
                    "without, the console keeps its newest runs by itself")
          ->check(refuse_if_empty)
          ->type_name("FILE.mcap");
  c->add_flag("--no-record", o.no_record,
              "the console makes no recording; the journal by which --resume goes on is kept all the same")
      ->excludes(file);
  add_viewers(c, o, file);
  c->add_flag("--resume", o.resume,
              "go on with the newest run that did not end (of MISSION, or of the project in this folder or "
              "below it), exactly where a killed or quit console left it (docs/journal.md)")
      ->excludes(file);
}

void add_replay_options(CLI::App* c, ReplayOptions& o) {
  add_recording(c, o)->description(
      "the file that `mlab run` has recorded; without one, those of the project in this folder are listed");
  auto* const headless = c->add_flag(
      "--headless", o.headless, "no page: compute it again here, and say whether it is as it was recorded");
  c->add_option(
       "--against", o.page.against,
       "show this recorded run beside it, as its other future: both on one map, and how far they are "
       "apart; `mlab compare` says the same in the terminal")
      ->check(refuse_if_empty)
      ->excludes(headless)
      ->type_name("OTHER.mcap");
  c->add_option("--report", o.report,
                "with --headless: write the run's report as it would have been written then")
      ->check(refuse_if_empty)
      ->type_name("FILE.json");
  auto* const again =
      c->add_option("--record", o.record,
                    "with --headless: record it once more, in this MCAP file: for viewers, say")
          ->check(refuse_if_empty)
          ->type_name("FILE.mcap");
  add_viewers(c, o, again);
  auto* const keep =
      c->add_flag("--keep", o.keep, "only mark it: it stays, however many runs the console records after it");
  c->add_flag("--no-keep", o.no_keep, "take the mark away")->excludes(keep);
  c->add_flag("--quiet", o.quiet, "with --headless: print only what became of it");
}

void add_trace_options(CLI::App* c, TraceOptions& o) {
  add_recording(c, o.replay)->required();
  c->add_option("--robot", o.robots, "only this robot; again for each (default: all)")->type_name("N");
  c->add_option("--ports", o.ports,
                "paths of ports, in which * stands for anything: 'movement.*'; again for each (default: all "
                "outputs)")
      ->type_name("PATTERN");
  c->add_option("--from", o.from, "simulated seconds from which on")
      ->check(refuse_if_no_moment)
      ->type_name("SECONDS");
  c->add_option("--to", o.to, "simulated seconds up to which (default: the end)")
      ->check(refuse_if_no_moment)
      ->type_name("SECONDS");
  c->add_option("--every", o.every, "a row for every so many cycles")
      ->capture_default_str()
      ->check(CLI::Range(1U, 1'000'000U))
      ->type_name("CYCLES");
  c->add_flag("--csv", o.says_csv, "as comma-separated values, which is what it does anyway");
}

void add_compare_options(CLI::App* c, CompareOptions& o) {
  c->add_option("first", o.first, "a file that `mlab run` has recorded")->required()->type_name("A.mcap");
  c->add_option("second", o.second, "another one")->required()->type_name("B.mcap");
  c->add_flag("--json", o.json, "for programs (docs/recording.md has the fields)");
  c->add_option("--html", o.page, "write a page with plots, which needs nothing else")
      ->check(refuse_if_empty)
      ->type_name("FILE.html");
  c->add_flag("--quiet", o.quiet, "print only what came out");
  add_computing(c, o.threads, o.limits);
}

}  // namespace mlab::cli
