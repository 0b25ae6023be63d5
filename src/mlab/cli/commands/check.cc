#include <cstdio>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "mlab/assist/service.h"
#include "mlab/base/counted.h"
#include "mlab/cli/batch_study.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/failsafe_table.h"
#include "mlab/cli/files.h"
#include "mlab/cli/input.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/terminal.h"
#include "mlab/study/study_file.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {

using assist::Language;
using assist::language_of;
namespace {

using Json = nlohmann::ordered_json;

struct Checked {
  std::string file;
  std::optional<Language> language;
  bool is_study = false;  ///< the definition of a batch, which is in none of the languages
  text::Diagnostics sink;
  std::vector<FailsafeRow> failsafes;  ///< where they were asked for
};

void check_source(const text::SourcePtr& source, const CheckOptions& options, Checked& out) {
  out.is_study = study::is_study_file(source->name());
  if (out.is_study) {
    check_study(source, options.no_cell, out.sink);
    return;
  }
  out.language = language_of(*source);
  if (!out.language) {
    out.sink
        .error("unknown-language", {source, {0, 0}}, "this is no mission, overlay, network or configuration")
        .hints = {"the name may say it: .mdl, .odl, .cnl, .cdl; .toml: the definition of a batch"};
    return;
  }
  out.sink =
      assist::problems({source, *out.language}, surroundings(permission_to_check(true, options.no_cell)));
  if (options.failsafes && out.language == Language::kMission) out.failsafes = failsafe_rows(source);
}

std::string_view language_name(const Checked& checked) {
  return checked.is_study ? "study" : checked.language ? name(*checked.language) : "";
}

Json place_json(const text::Place& place) {
  if (!place.source) return nullptr;
  const text::LineColumn begin = place.source->line_column(place.span.begin);
  const text::LineColumn end = place.source->line_column(place.span.end);
  return {{"file", place.source->name()},
          {"line", begin.line},
          {"column", begin.column},
          {"end_line", end.line},
          {"end_column", end.column}};
}

Json diagnostic_json(const text::Diagnostic& d) {
  Json out;
  out["level"] = name(d.severity);
  out["kind"] = d.kind;
  out["message"] = d.message;
  out["place"] = place_json(d.place);
  out["label"] = d.label;
  out["hints"] = d.hints;
  out["notes"] = Json::array();
  for (const text::Note& note : d.notes)
    out["notes"].push_back({{"message", note.message}, {"place", place_json(note.place)}});
  return out;
}

Json checked_json(const Checked& checked) {
  Json out;
  out["file"] = checked.file;
  out["language"] = language_name(checked).empty() ? Json(nullptr) : Json(language_name(checked));
  out["errors"] = checked.sink.error_count();
  out["warnings"] = checked.sink.warning_count();
  out["diagnostics"] = Json::array();
  for (const text::Diagnostic& d : checked.sink.items()) out["diagnostics"].push_back(diagnostic_json(d));
  for (const FailsafeRow& row : checked.failsafes) {
    out["failsafes"].push_back({{"rank", row.rank},
                                {"robots", row.robots.empty() ? Json(nullptr) : Json(row.robots)},
                                {"condition", row.condition},
                                {"after", row.after},
                                {"action", row.action},
                                {"stated", row.stated}});
  }
  return out;
}

}  // namespace

int check(const CheckOptions& options) {
  std::size_t errors = 0;
  std::size_t warnings = 0;
  Json files = Json::array();
  for (const std::string& file : options.files) {
    Checked checked;
    checked.file = file;
    if (text::Result<text::SourcePtr> source = read_input(file)) {
      check_source(*source, options, checked);
    } else {
      checked.sink.report(source.error());
    }
    errors += checked.sink.error_count();
    warnings += checked.sink.warning_count();
    if (options.format == "json") {
      files.push_back(checked_json(checked));
      continue;
    }
    tell(checked.sink);
    fmt::print("{}: {}", file, language_name(checked).empty() ? "unreadable" : language_name(checked));
    if (checked.sink.items().empty()) {
      fmt::print(", ok\n");
    } else {
      fmt::print(
          ", {}, {}{}\n", base::counted(checked.sink.error_count(), "error"),
          base::counted(checked.sink.warning_count(), "warning"),
          checked.sink.note_count() == 0 ? "" : ", " + base::counted(checked.sink.note_count(), "note"));
    }
    fmt::print("{}", table_of(checked.failsafes));
  }
  if (options.format == "json") {
    const Json out = {{"version", 1}, {"files", files}};
    fmt::print("{}\n", out.dump(2, ' ', false, Json::error_handler_t::replace));
  }
  if (errors > 0) return kBadInput;
  return options.strict && warnings > 0 ? kFailed : kDone;
}

}  // namespace mlab::cli
