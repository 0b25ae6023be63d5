#include "mlab/lang/cdl/lower/arguments.h"

#include <algorithm>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/flow/type_words.h"

namespace mlab::cdl {

std::vector<GivenArgument> given_by(const Call& call, Scope& scope) {
  std::vector<GivenArgument> out;
  for (const Argument& argument : call.arguments)
    out.push_back({argument.name, argument.value, &scope, {}, argument.value->place});
  return out;
}

int Arguments::index_of_name(const Word& callee, const Word& name, const std::vector<std::string>& names,
                             const Assemblage* assemblage) {
  const auto found = std::ranges::find(names, name.text);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  // Where the assemblage misses that name itself, its parameter is misspelt.
  if (assemblage != nullptr && findings_.misses_name(*assemblage, name.text)) return -1;
  text::Diagnostic& d = findings_.error("unknown-argument", name.place,
                                        fmt::format("`{}` has no input `{}`", callee.text, name.text));
  const std::string nearest = text::nearest_name(name.text, names);
  d.hints.push_back(!nearest.empty() ? fmt::format("did you mean `{}`?", nearest)
                    : names.empty()  ? "it takes no arguments"
                                     : fmt::format("its inputs are {}", fmt::join(names, ", ")));
  return -1;
}

std::vector<int> Arguments::match(const Word& callee, const std::vector<GivenArgument>& given,
                                  const std::vector<std::string>& names, const Assemblage* assemblage) {
  std::vector<int> out;
  std::vector<const GivenArgument*> taken(names.size(), nullptr);
  bool had_name = false;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const GivenArgument& one = given[i];
    const text::Place& place = one.name.text.empty() ? one.place : one.name.place;
    int index = -1;
    if (!one.name.text.empty()) {
      had_name = true;
      index = index_of_name(callee, one.name, names, assemblage);
    } else if (had_name) {
      findings_.error("argument-without-name", place, "behind an argument with a name all have one").hints = {
          fmt::format("the inputs of `{}` are {}", callee.text, fmt::join(names, ", "))};
    } else if (i >= names.size()) {
      findings_.error("too-many-arguments", place,
                      names.empty() ? fmt::format("`{}` takes no arguments", callee.text)
                                    : fmt::format("`{}` takes no more than {} argument{}", callee.text,
                                                  names.size(), names.size() == 1 ? "" : "s"));
    } else {
      index = static_cast<int>(i);
    }
    if (index >= 0 && taken[static_cast<std::size_t>(index)] != nullptr) {
      findings_
          .error("double-argument", place,
                 fmt::format("`{}` is given twice", names[static_cast<std::size_t>(index)]))
          .notes.push_back({"first here", taken[static_cast<std::size_t>(index)]->place});
      index = -1;
    }
    if (index >= 0) taken[static_cast<std::size_t>(index)] = &one;
    out.push_back(index);
  }
  return out;
}

void Arguments::say_missing(const Word& callee, const std::string& name, const PortType& type,
                            const std::string& help) {
  findings_.error("missing-argument", callee.place, fmt::format("`{}` needs `{}`", callee.text, name))
      .hints.push_back(fmt::format("`{} = ...` takes {}{}{}", name,
                                   type.type == nullptr ? "a value" : flow::value_of(*type.type, type.unit),
                                   help.empty() ? "" : ": ", help));
}

}  // namespace mlab::cdl
