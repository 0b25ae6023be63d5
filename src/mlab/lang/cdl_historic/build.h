#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::cdl_historic {

/// An expression under construction; the finished tree holds it as const.
using Draft = std::shared_ptr<cdl::Expression>;

/// An expression of our language and the flow type of its value. An empty draft: nothing could be made.
struct TypedDraft {
  Draft expr;
  std::string type;
};

template <class What>
Draft draft(What what, text::Place place) {
  auto out = std::make_shared<cdl::Expression>();
  out->what = std::move(what);
  out->place = std::move(place);
  return out;
}

inline Draft number(double value, std::string unit, text::Place place) {
  return draft(cdl::Number{value, {std::move(unit), place}}, place);
}
inline Draft name(std::string text, text::Place place) {
  return draft(cdl::Name{{std::move(text), place}}, place);
}
/// Our texts stand on one line, and know no quotes in quotes.
inline Draft quoted(std::string text, text::Place place) {
  for (char& c : text) {
    if (c == '"') c = '\'';
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return draft(cdl::Text{std::move(text)}, std::move(place));
}
inline Draft call(std::string callee, text::Place place, std::vector<cdl::Argument> arguments = {}) {
  return draft(cdl::Call{{std::move(callee), place}, std::move(arguments)}, place);
}

/// A name as our language takes it, made of historic text: other characters become `_`, words of the language
/// get a `_` at their end.
std::string legal_name(std::string_view text);

/// What a historic file wrote beside something, as one line of documentation.
std::string help_text(std::string_view label);

/// The drawn form of an expression, to see whether two of them say the same; places and the names of nodes
/// do not count.
std::string fingerprint(const cdl::Expression& expression);

}  // namespace mlab::cdl_historic
