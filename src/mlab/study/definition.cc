#include "mlab/study/definition.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/study/row.h"
#include "mlab/text/shown.h"

namespace mlab::study {
namespace {

constexpr auto kFields = std::to_array<Field>({
    {"mission", "MISSION.mdl", "the mission", true},
    {"against", "OTHER.mdl",
     "another version of the mission: it runs with the same seeds and values, and both are "
     "compared in pairs",
     true},
    {"runs", "N", "how many runs of each combination of values; with --until, at most"},
    {"seed", "N", "of the first run of each combination; the others follow it"},
    {"set", "NAME=VALUES",
     "values in place of what the mission says: 1,2,5 or 1:5:1 (from 1 to 5 by 1), each a "
     "combination; or 1..5, drawn anew for each run; again for each name",
     false, true},
    {"combine", "crossed|paired",
     "lists: each value with each, or the first of all lists together, then the second "
     "ones"},
    {"draw", "random|latin",
     "drawn values: each by itself, or spread over their ranges as a Latin hypercube"},
    {"success", "CONDITION",
     "when a run is a success: outcome == done and contacts == 0 (default: outcome == done)"},
    {"require", "REQUIREMENT",
     "decides the exit status: success >= 0.95 @ 0.99, met where the whole interval of that "
     "confidence is there, of each combination; again for each",
     false, true},
    {"until", "UNTIL",
     "no more runs of a combination once its requirements are `decided`, or once the share is known "
     "so well: success +- 0.05 @ 0.95"},
    {"confidence", "SHARE", "of the intervals that are shown (default: of the first requirement, or 0.95)"},
    {"start-time", "TIME",
     "what the mission's clock shows at the start of every run: \"YYYY-MM-DD HH:MM[:SS]\" "
     "(default: now)"},
    {"patience", "SECONDS", "simulated seconds without progress after which a command has failed"},
    {"for", "SECONDS", "each run goes on for so many simulated seconds, and is done"},
    {"limit", "SECONDS", "each run ends after so many simulated seconds, as interrupted"},
    {"environment", "FILE", "change the world while the mission runs, as this file says", true},
    {"table", "FILE.csv|FILE.json", "write a row for each run", true},
    {"html", "FILE.html", "write a page with plots, in one file", true},
    {"recordings", "FOLDER|none",
     "record one run of each cause of failure there, by running it again (default: beside --html or "
     "--table, out.failures)",
     true},
    {"results", "FILE",
     "keep what is done in this file (default: beside --table or --html until all is done)", true},
});

std::optional<text::Diagnostic> expected(const Written& value, std::string_view what) {
  text::Diagnostic out;
  out.kind = "expected";
  out.message = value.empty() ? fmt::format("expected {}, and it is empty", what)
                              : fmt::format("expected {}, found `{}`", what, text::shown(value.text));
  out.place = value.place;
  return out;
}

template <class Whole>
std::optional<text::Diagnostic> take_whole(const Written& value, Whole least, Whole most, Whole& out) {
  Whole number = 0;
  const char* const last = value.text.data() + value.text.size();
  const auto [end, error] = std::from_chars(value.text.data(), last, number);
  if (error != std::errc{} || end != last || number < least || number > most)
    return expected(value, fmt::format("a whole number from {} to {}", least, most));
  out = number;
  return std::nullopt;
}

template <class Out>
std::optional<text::Diagnostic> take_positive(const Written& value, Out& out) {
  double number = 0.0;
  const char* const last = value.text.data() + value.text.size();
  const auto [end, error] = std::from_chars(value.text.data(), last, number);
  if (error != std::errc{} || end != last || !std::isfinite(number) || !(number > 0.0))
    return expected(value, "a number above 0");
  out = number;
  return std::nullopt;
}

std::optional<text::Diagnostic> take_word(const Written& value, std::string_view no, std::string_view yes,
                                          bool& out) {
  if (value.text != no && value.text != yes) return expected(value, fmt::format("`{}` or `{}`", no, yes));
  out = value.text == yes;
  return std::nullopt;
}

// A file that some field names.
template <class Out>
std::optional<text::Diagnostic> take_file(const Written& value, Out& out) {
  if (value.empty() || value.text.find('\0') != std::string::npos)
    return expected(value, "the name of a file");
  if constexpr (std::is_same_v<Out, Written>) {
    out = value;
  } else {
    out = value.text;
  }
  return std::nullopt;
}

template <class Parsed, class Keep>
std::optional<text::Diagnostic> take_parsed(text::Result<Parsed> parsed, Keep keep) {
  if (!parsed) return std::move(parsed.error());
  keep(std::move(*parsed));
  return std::nullopt;
}

std::optional<text::Diagnostic> take_confidence(const Written& value, double& out) {
  if (auto problem = take_positive(value, out)) return problem;
  return out >= 0.5 && out < 1.0 ? std::nullopt : expected(value, "a confidence from 0.5 to below 1");
}

constexpr double kUsualConfidence = 0.95;
constexpr std::uint32_t kMostRuns = 10'000'000;

}  // namespace

std::span<const Field> fields() {
  return kFields;
}

std::optional<text::Diagnostic> take(Definition& d, std::string_view field, const Written& value) {
  if (field == "mission") return take_file(value, d.mission);
  if (field == "against") return take_file(value, d.against);
  if (field == "environment") return take_file(value, d.environment);
  if (field == "table") return take_file(value, d.table);
  if (field == "html") return take_file(value, d.page);
  if (field == "recordings") return take_file(value, d.recordings);
  if (field == "results") return take_file(value, d.results);
  if (field == "runs") return take_whole<std::uint32_t>(value, 1, kMostRuns, d.runs);
  // A mission's file means a seed by a number that others read as well.
  if (field == "seed") return take_whole<std::uint64_t>(value, 0, std::uint64_t{1} << 53, d.seed);
  if (field == "combine") return take_word(value, "crossed", "paired", d.is_paired);
  if (field == "draw") return take_word(value, "random", "latin", d.is_latin);
  if (field == "patience") return take_positive(value, d.patience);
  if (field == "limit") return take_positive(value, d.limit);
  if (field == "for") return take_positive(value, d.duration);
  if (field == "confidence") return take_confidence(value, d.confidence);
  if (field == "start-time") {
    d.start_time = value.text;
    d.start_time_place = value.place;
    return std::nullopt;
  }
  if (field == "set")
    return take_parsed(dimension_of(value), [&](Dimension one) { d.dimensions.push_back(std::move(one)); });
  if (field == "success")
    return take_parsed(Condition::parse(value), [&](Condition one) { d.success = std::move(one); });
  if (field == "until") return take_parsed(Until::parse(value), [&](Until one) { d.until = std::move(one); });
  if (field == "require")
    return take_parsed(Requirement::parse(value),
                       [&](Requirement one) { d.requirements.push_back(std::move(one)); });
  return expected(value, fmt::format("no field `{}`", field));
}

namespace {

// Of several that are paired what they have together, else what each has.
std::optional<text::Diagnostic> told_of_repeated(const Definition& d) {
  std::vector<const Dimension*> lists;
  for (const Dimension& one : d.dimensions) {
    if (!one.is_drawn()) lists.push_back(&one);
  }
  const std::size_t together = d.is_paired ? std::max<std::size_t>(lists.size(), 1) : 1;
  for (std::size_t i = 0; i < lists.size(); i += together) {
    const std::span<const Dimension* const> some(&lists[i], together);
    const auto repeated = repeated_values(some);
    if (!repeated) continue;
    std::string values;
    for (const Dimension* const one : some)
      values += fmt::format("{}`{}={}`", values.empty() ? "" : " with ", text::shown(one->name.text),
                            text::shown(one->values[*repeated].text));
    text::Diagnostic out;
    out.kind = "repeated-value";
    out.message =
        fmt::format("{} is given twice: expected each once, as the same runs would be done again", values);
    out.place = some.front()->values[*repeated].place;
    out.hints.emplace_back("`runs` says how many runs there are of each");
    return out;
  }
  return std::nullopt;
}

}  // namespace

std::optional<text::Diagnostic> settle(Definition& d) {
  if (d.confidence == 0.0)
    d.confidence = !d.requirements.empty() ? d.requirements.front().confidence
                   : d.until               ? d.until->confidence
                                           : kUsualConfidence;
  const auto wrong = [](std::string kind, const text::Place& place, std::string message) {
    text::Diagnostic out;
    out.kind = std::move(kind);
    out.message = std::move(message);
    out.place = place;
    return out;
  };
  if (d.mission.empty())
    return wrong("no-mission", {}, "no mission is named: expected `mission = \"FILE.mdl\"`");
  for (const Dimension& one : d.dimensions) {
    if (is_table_column(one.name.text))
      return wrong(
          "set-column", one.name.place,
          fmt::format("`{}` can't be set: the table has a column of this name{}", text::shown(one.name.text),
                      one.name.text == "seed" ? "; the seeds of runs are set by `seed` (--seed)" : ""));
  }
  const Dimension* first = nullptr;
  for (std::size_t i = 0; i < d.dimensions.size(); ++i) {
    const Dimension& one = d.dimensions[i];
    for (std::size_t k = 0; k < i; ++k) {
      if (d.dimensions[k].name.text == one.name.text)
        return wrong("set-twice", one.name.place,
                     fmt::format("`{}` is set twice", text::shown(one.name.text)));
    }
    if (one.is_drawn()) continue;
    if (first == nullptr) first = &one;
    if (d.is_paired && one.values.size() != first->values.size())
      return wrong(
          "unpaired", one.name.place,
          fmt::format("lists are paired, and `{}` has {} values, `{}` {}", text::shown(first->name.text),
                      first->values.size(), text::shown(one.name.text), one.values.size()));
  }
  if (auto repeated = told_of_repeated(d)) return repeated;
  if (d.until && d.until->is_decided && d.requirements.empty())
    return wrong("nothing-to-decide", {}, "`until decided` goes with a requirement (--require)");
  return std::nullopt;
}

}  // namespace mlab::study
