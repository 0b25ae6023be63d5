// `mlab test-components`: tests that stand beside components.

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <unistd.h>

#include <fmt/core.h>

#include "mlab/assist/service.h"
#include "mlab/base/counted.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/cli/input.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/terminal.h"
#include "mlab/component_test/component_test.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

namespace fs = std::filesystem;
using component_test::Outcome;
using component_test::Test;

constexpr std::size_t kLongestName = 200;

struct Tally {
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::size_t unread = 0;  ///< files
  std::vector<std::string> names;
};

std::string small(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return out;
}

bool is_asked_for(const TestOptions& options, std::string_view name) {
  return options.only.empty() || small(name).find(small(options.only)) != std::string::npos;
}

/// What a folder has for who looks for tests, in the order of names.
struct Folder {
  std::vector<std::string> files;
  std::vector<std::string> unread;  ///< sentences: folders that can't be looked into
};

bool has_tests(const std::string& file) {
  const text::Result<text::SourcePtr> source = text::read_source(file);
  if (!source) return true;  // which is said where it is read
  return (*source)->text().find("test") != std::string_view::npos &&
         !cdl::tests_of(cdl::read_as_written(*source).tree).empty();
}

/// Configurations in a folder that have tests or can't be read. Folders that begin with a dot, and links to
/// folders, are left out.
void look_for_tests(const fs::path& folder, Folder& out) {
  std::error_code failure;
  fs::directory_iterator each(folder, failure);
  for (; !failure && each != fs::directory_iterator(); each.increment(failure)) {
    const std::string name = each->path().filename().string();
    std::error_code ignored;
    if (each->is_directory(ignored)) {
      const bool is_meant = !name.starts_with('.') && name != "node_modules" && !each->is_symlink(ignored);
      if (is_meant) look_for_tests(each->path(), out);
    } else if (!each->is_regular_file(ignored) && each->exists(ignored)) {
      continue;  // a pipe, say
    } else if (small(name).ends_with(".cdl") && has_tests(each->path().string())) {
      out.files.push_back(each->path().string());
    }
  }
  if (failure)
    out.unread.push_back(fmt::format("cannot look into `{}`: {}", text::shown(folder.string(), kLongestName),
                                     failure.message()));
}

// On a terminal, what runs now; it is written over by what came of it.
void show_progress(const Test& test) {
  if (isatty(STDOUT_FILENO) == 0) return;
  fmt::print("  ...   {}", text::shown(test.lowered.test->name.text, kLongestName));
  std::fflush(stdout);
}

void tell_outcome(const TestOptions& options, const Outcome& outcome) {
  if (isatty(STDOUT_FILENO) != 0) fmt::print("\r\033[K");
  const std::string name = text::shown(outcome.name, kLongestName);
  if (outcome.has_passed()) {
    if (!options.quiet)
      fmt::print("  {}    {} ({})\n", colored("ok", Color::kGood), name,
                 base::counted(outcome.cycles, "cycle"));
    return;
  }
  fmt::print("  {}  {}\n", colored("FAIL", Color::kBad), name);
  fmt::print("{}", text::render(component_test::told(*outcome.failure)));
  for (const std::string& one : component_test::findings(*outcome.failure)) fmt::print("      = {}\n", one);
}

void run_file(const text::SourcePtr& source, const TestOptions& options, Tally& tally) {
  const std::string folder = fs::path(source->name()).parent_path().string();
  RunOptions code;
  code.no_cell = options.no_cell;
  const robot::ProgramSources sources =
      program_sources(folder, permission_to_run(code, cell::Grounds::People::kHere, folder));
  text::Diagnostics sink;
  const component_test::Tests all = component_test::load(
      source, sources, sink, [&](std::string_view name) { return is_asked_for(options, name); });
  tell(sink);
  if (sink.has_errors()) {
    ++tally.unread;
    return;
  }
  tally.names.insert(tally.names.end(), all.names.begin(), all.names.end());
  bool has_title = false;
  for (const Test& test : all.tests) {
    if (!has_title && !options.quiet) fmt::print("{}\n", text::shown(source->name(), kLongestName));
    has_title = true;
    show_progress(test);
    const Outcome outcome = component_test::run(test, {.seed = options.seed});
    tell_outcome(options, outcome);
    ++(outcome.has_passed() ? tally.passed : tally.failed);
  }
  if (all.names.empty()) fmt::print("{}: no tests\n", text::shown(source->name(), kLongestName));
}

bool is_configuration(const text::SourcePtr& source) {
  if (assist::language_of(*source) == assist::Language::kConfiguration) return true;
  text::Diagnostics sink;
  sink.error("unknown-language", {source, {0, 0}}, "this is no configuration").hints = {
      "tests of components stand in configurations (.cdl)"};
  tell(sink);
  return false;
}

void run_named(const std::string& file, const TestOptions& options, Tally& tally) {
  std::error_code ignored;
  if (!is_standard_input(file) && fs::is_directory(file, ignored)) {
    Folder found;
    look_for_tests(file, found);
    std::ranges::sort(found.files);
    for (const std::string& problem : found.unread) fmt::print(stderr, "mlab test-components: {}\n", problem);
    tally.unread += found.unread.size();
    for (const std::string& one : found.files) run_named(one, options, tally);
    return;
  }
  const text::Result<text::SourcePtr> source = read_input(file);
  if (!source) tell(source.error());
  if (!source || !is_configuration(*source)) {
    ++tally.unread;
    return;
  }
  run_file(*source, options, tally);
}

}  // namespace

int test_components(const TestOptions& options) {
  Tally tally;
  const std::vector<std::string> here = {"."};
  for (const std::string& file : options.files.empty() ? here : options.files)
    run_named(file, options, tally);
  const std::size_t all = tally.passed + tally.failed;
  if (all == 0 && !options.only.empty() && tally.unread == 0) {
    const std::string nearest = text::nearest_name(options.only, tally.names);
    fmt::print(stderr, "mlab test-components: no test has `{}` in its name{}\n", text::shown(options.only),
               nearest.empty() ? "" : fmt::format("; did you mean `{}`?", text::shown(nearest)));
    return kBadInput;
  }
  fmt::print("{}: {}\n", base::counted(all, "test"),
             tally.failed == 0 ? (all == 0 ? "nothing to do" : "all passed")
                               : fmt::format("{} failed", tally.failed));
  if (tally.unread > 0) return kBadInput;
  return tally.failed > 0 ? kFailed : kDone;
}

}  // namespace mlab::cli
