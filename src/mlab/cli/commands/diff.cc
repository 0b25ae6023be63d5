#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "mlab/assist/service.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/input.h"
#include "mlab/cli/terminal.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/difference/tell.h"
#include "mlab/git/git.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

using difference::Comparison;
using difference::Difference;
using difference::What;
using Json = nlohmann::ordered_json;

/// One of the two versions.
struct Compared {
  text::SourcePtr source;
  text::Files files;       // those that it names, as they were
  bool has_files = false;  // false: those on disk
  std::unique_ptr<designer::Model> model;
};

text::Diagnostic usage(const std::string& message, const std::string& hint) {
  text::Diagnostic out;
  out.kind = "usage";
  out.message = message;
  out.hints = {hint};
  return out;
}

text::Result<Compared> on_disk(const std::string& file) {
  text::Result<text::SourcePtr> source = read_input(file);
  if (!source) return std::unexpected(source.error());
  Compared out;
  out.source = *source;
  return out;
}

text::Result<Compared> in_git(const std::string& file, const std::string& revision) {
  if (is_standard_input(file))
    return std::unexpected(usage("git knows nothing of standard input", "name a file, or two to compare"));
  const git::TrackedFile tracked(file);
  const text::Result<git::FileThen> then = tracked.find(revision);
  if (!then) return std::unexpected(then.error());
  text::Result<text::SourcePtr> source = tracked.at(*then);
  if (!source) return std::unexpected(source.error());
  Compared out;
  out.source = *source;
  out.files = tracked.files_at(*then);
  out.has_files = true;
  return out;
}

text::Result<std::pair<Compared, Compared>> versions(const DiffOptions& options) {
  const auto both = [](text::Result<Compared> before,
                       const auto& after_of) -> text::Result<std::pair<Compared, Compared>> {
    if (!before) return std::unexpected(before.error());
    text::Result<Compared> after = after_of();
    if (!after) return std::unexpected(after.error());
    return std::pair(std::move(*before), std::move(*after));
  };
  const std::string& file = options.file;
  if (!options.after.empty()) {
    if (!options.revision.empty())
      return std::unexpected(
          usage("two files are compared as they are", "leave --rev out, or name one file"));
    if (is_standard_input(file) && is_standard_input(options.after))
      return std::unexpected(usage("only one of two can come from standard input", "name a file"));
    return both(on_disk(file), [&] { return on_disk(options.after); });
  }
  const std::string revision = options.revision.empty() ? "HEAD" : options.revision;
  const std::size_t dots = revision.find("..");
  if (dots == std::string::npos) return both(in_git(file, revision), [&] { return on_disk(file); });
  const std::string from = revision.substr(0, dots);
  const std::string to = revision.substr(dots + 2);
  if (to.starts_with('.'))
    return std::unexpected(usage("A...B is not known here", "two revisions are named as A..B"));
  return both(in_git(file, from.empty() ? "HEAD" : from),
              [&] { return in_git(file, to.empty() ? "HEAD" : to); });
}

// What language it is; says so where it is none that can be compared.
bool is_comparable(const Compared& one) {
  const std::optional<assist::Language> language = assist::language_of(*one.source);
  if (language == assist::Language::kConfiguration) return true;
  text::Diagnostics sink;
  sink.error("not-compared", {one.source, {0, 0}}, "`mlab diff` compares configurations (.cdl)").hints = {
      "for missions, overlays and procedures there is `git diff`"};
  tell(sink);
  return false;
}

void read(Compared& one) {
  cdl::Environment environment = robot::library_environment();
  if (one.has_files) environment.files = &one.files;
  one.model = std::make_unique<designer::Model>(one.source, environment);
}

// ---- for people

std::string in_color(const std::string& text, What what) {
  switch (what) {
    case What::kAdded:
      return colored(text, Color::kGood);
    case What::kRemoved:
      return colored(text, Color::kBad);
    case What::kChanged:
    case What::kRenamed:
    case What::kMoved:
      break;
  }
  return colored(text, Color::kWarning);
}

// What a text says may hold control characters, which are for no terminal to obey.
std::string on_terminal(const std::string& text) {
  return text::shown(text, text.size());
}

void print_all(const std::vector<Difference>& all) {
  bool is_first = true;
  std::string last;
  for (const Difference& one : all) {
    const std::string place = difference::place_of(one);
    if (is_first || place != last) fmt::print("{}\n", place.empty() ? "The file" : on_terminal(place));
    is_first = false;
    last = place;
    const std::string line = on_terminal(difference::sentence(one));
    fmt::print("{}\n", in_color(fmt::format("  {} {}", difference::sign_of(one.what), line), one.what));
  }
}

void print_sum(const std::vector<Difference>& all) {
  if (all.empty()) return;
  std::string out;
  for (const What what : {What::kAdded, What::kRemoved, What::kChanged, What::kRenamed, What::kMoved}) {
    const auto count = std::ranges::count(all, what, &Difference::what);
    if (count > 0) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, difference::word_of(what));
  }
  fmt::print("{}\n", out);
}

void print(const Comparison& comparison, const DiffOptions& options) {
  std::vector<Difference> all = comparison.meaning;
  if (options.layout) all.insert(all.end(), comparison.layout.begin(), comparison.layout.end());
  print_all(all);
  print_sum(all);
  for (const std::string& remark : difference::remarks(comparison)) fmt::print("({})\n", remark);
}

// ---- for programs

Json position_json(const text::Place& place) {
  if (!place.source) return nullptr;
  const text::LineColumn at = place.source->line_column(place.span.begin);
  return {{"line", at.line}, {"column", at.column}};
}

Json difference_json(const Difference& one) {
  const auto name = [](const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); };
  Json out;
  out["what"] = difference::word_of(one.what);
  out["thing"] = difference::word_of(one.thing);
  out["kind"] = one.kind;
  out["page"] = {{"before", one.page_before}, {"after", one.page_after}};
  out["name"] = {{"before", name(one.name_before)}, {"after", name(one.name_after)}};
  if (one.index_before >= 0 || one.index_after >= 0)
    out["index"] = {{"before", one.index_before < 0 ? Json(nullptr) : Json(one.index_before)},
                    {"after", one.index_after < 0 ? Json(nullptr) : Json(one.index_after)}};
  out["place"] = {{"before", position_json(one.place_before)}, {"after", position_json(one.place_after)}};
  out["details"] = Json::array();
  for (const difference::Detail& detail : one.details)
    out["details"].push_back(
        {{"what", detail.what}, {"before", name(detail.before)}, {"after", name(detail.after)}});
  out["text"] = difference::sentence(one);
  return out;
}

void print_json(const Comparison& comparison, const Compared& before, const Compared& after, Json is_same) {
  Json out;
  out["before"] = before.source->name();
  out["after"] = after.source->name();
  out["same"] = std::move(is_same);
  out["differences"] = Json::array();
  for (const Difference& one : comparison.meaning) out["differences"].push_back(difference_json(one));
  out["layout"] = Json::array();
  for (const Difference& one : comparison.layout) out["layout"].push_back(difference_json(one));
  out["remarks"] = difference::remarks(comparison);
  out["errors"] = {{"before", before.model->problems().error_count()},
                   {"after", after.model->problems().error_count()}};
  fmt::print("{}\n", out.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

int diff(const DiffOptions& options) {
  text::Result<std::pair<Compared, Compared>> both = versions(options);
  if (!both) {
    tell(both.error());
    return kBadInput;
  }
  auto& [before, after] = *both;
  if (!is_comparable(before) || !is_comparable(after)) return kBadInput;
  read(before);
  read(after);
  const bool before_errs = before.model->problems().has_errors();
  const bool after_errs = after.model->problems().has_errors();
  const Comparison comparison =
      difference::compare({before.model->tree(), before.model->components().elaboration(), before_errs},
                          {after.model->tree(), after.model->components().elaboration(), after_errs});
  const bool is_same = comparison.is_same() && (!options.layout || comparison.layout.empty());
  if (options.json) {
    const bool is_open = is_same && comparison.is_partial && !comparison.is_same_text;
    print_json(comparison, before, after, is_open ? Json(nullptr) : Json(is_same));
  } else {
    print(comparison, options);
  }
  tell(before.model->problems());
  tell(after.model->problems());
  if (comparison.is_partial) {
    fmt::print(stderr, "mlab diff: what could be read was compared; the errors above hide the rest\n");
    return kBadInput;
  }
  return is_same ? kDone : kFailed;
}

}  // namespace mlab::cli
