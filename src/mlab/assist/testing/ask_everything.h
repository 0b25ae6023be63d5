#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "mlab/assist/service.h"

// All that can be asked of a text, for tests and fuzzers.
namespace mlab::assist::testing {

/// A world without files.
inline Surroundings nowhere() {
  Surroundings out;
  out.checks_code = false;
  out.files.is_file = [](const std::string&) { return false; };
  out.files.read = [](const std::string& path) -> text::Result<text::SourcePtr> {
    text::Diagnostic problem;
    problem.kind = "cannot-read";
    problem.message = "cannot read `" + path + "`";
    return std::unexpected(problem);
  };
  return out;
}

inline bool is_within(text::Span span, const text::SourcePtr& source) {
  return span.begin <= span.end && span.end <= source->text().size();
}

inline bool are_within(const std::vector<Symbol>& symbols, const text::SourcePtr& source) {
  return std::ranges::all_of(symbols, [&](const Symbol& symbol) {
    return is_within(symbol.span, source) && is_within(symbol.name_span, source) &&
           are_within(symbol.parts, source);
  });
}

/// Asks everything at a place.
/// @return  what is wrong with an answer; empty: nothing
// NOLINTNEXTLINE(readability-function-size): a line for each question
inline std::string ask_everything(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const text::SourcePtr& source = text.source;
  const Completions offered = complete(text, cursor, around);
  if (!is_within(offered.replaced, source)) return "completion replaces what is not there";
  if (offered.candidates.size() > kMostCandidates) return "too many candidates";
  for (const Candidate& one : offered.candidates) {
    if (one.text.empty() || one.kind.empty()) return "an empty candidate";
  }
  if (const auto call = signature(text, cursor, around)) {
    for (const Signature::Part& part : call->parts) {
      if (part.span.begin > part.span.end || part.span.end > call->label.size())
        return "a part beside the label";
    }
  }
  if (const auto told = hover(text, cursor, around); told && !is_within(told->span, source))
    return "hovers over what is not there";
  if (const auto place = definition(text, cursor, around); place && !is_within(place->span, place->source))
    return "declared where nothing is";
  for (const Use& use : uses(text, cursor, around).places) {
    if (!is_within(use.place.span, use.place.source)) return "named where nothing is";
  }
  if (const auto span = renamable(text, cursor, around); span && !is_within(*span, source))
    return "renames what is not there";
  if (const auto changes = rename(text, cursor, "Other_Name", around)) {
    for (const Change& change : changes->changes) {
      std::uint32_t last = 0;
      for (const Splice& splice : change.splices) {
        if (!is_within(splice.span, change.source) || splice.span.begin < last) return "changes in disorder";
        last = splice.span.end;
      }
    }
  }
  if (!are_within(symbols(text, around), source)) return "a symbol of what is not there";
  for (const Fold& fold : folds(text, around)) {
    if (fold.first >= fold.last || fold.last > source->line_count()) return "folds what is not there";
  }
  for (const Hint& hint : hints(text, around)) {
    if (hint.at > source->text().size() || hint.text.empty()) return "a hint where nothing is";
  }
  std::uint32_t last = 0;
  for (const Shade& shade : shades(text, around)) {
    if (!is_within(shade.span, source) || shade.span.begin < last || shade.span.begin == shade.span.end)
      return "colours in disorder";
    last = shade.span.end;
  }
  text::Diagnostics sink;
  static_cast<void>(formatted(text, sink));
  const text::Diagnostics wrong = problems(text, around);
  if (!wrong.items().empty()) {
    for (const Fix& fix : fixes(text, wrong.items().front(), around)) {
      for (const Splice& splice : fix.splices) {
        if (!is_within(splice.span, source)) return "mends what is not there";
      }
    }
  }
  return "";
}

}  // namespace mlab::assist::testing
