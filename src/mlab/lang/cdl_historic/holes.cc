#include "mlab/lang/cdl_historic/holes.h"

#include <algorithm>
#include <optional>

#include <fmt/core.h>

#include "mlab/lang/cdl_historic/constants.h"
#include "mlab/text/shown.h"

namespace mlab::cdl_historic {
namespace {

// Cut so that a value of the type Text can hold it and a line can show it.
std::string short_text(const std::string& constant) {
  std::string out;
  for (const char c : unquoted(constant).value_or(constant)) {
    if (out.size() == kMaxTextBytes) break;
    const auto byte = static_cast<unsigned char>(c);
    out += byte < 0x20 || byte >= 0x7f ? ' ' : c;
  }
  return out;
}

}  // namespace

// Inputs that take values of their own have no constant for a default, so each set of them is a declaration.
std::string Holes::key(const std::string& historic, const std::string& result,
                       const std::vector<HoleArgument>& given) {
  std::string out = historic + ">" + result;
  for (const HoleArgument& g : given) {
    if (g.made.expr != nullptr) out += "," + g.name + ":" + g.made.type;
  }
  return out;
}

bool Holes::knows(const std::string& historic, const std::string& result,
                  const std::vector<HoleArgument>& given) const {
  return by_key_.contains(key(historic, result, given));
}

TypedDraft Holes::use(const std::string& historic, const std::string& result, std::vector<HoleArgument> given,
                      const text::Place& place, const std::string& declared_as) {
  const auto [it, is_new] = by_key_.emplace(key(historic, result, given), holes_.size());
  if (is_new) holes_.push_back({historic, declared_as, result, {}});
  Hole& hole = holes_[it->second];
  std::vector<cdl::Argument> arguments;
  for (HoleArgument& g : given) {
    const std::string name = legal_name(g.name);
    auto parameter = std::ranges::find(hole.parameters, name, &Parameter::name);
    if (parameter == hole.parameters.end()) {
      hole.parameters.push_back({name, g.made.type, {}});
      parameter = hole.parameters.end() - 1;
    }
    Draft value = g.made.expr;
    if (value == nullptr) {
      value = quoted(short_text(g.constant.text), g.constant.place);
      parameter->values.emplace_back(std::move(g.constant), value);
    }
    arguments.push_back({{name, place}, value});
  }
  return {call(hole.name, place, std::move(arguments)), result};
}

void Holes::settle(Parameter& parameter, cdl::Assemblage& into) {
  cdl::Parameter out;
  out.name.text = parameter.name;
  out.type.text = parameter.type;
  if (!parameter.values.empty()) {
    std::string type(type_of_constant(parameter.values[0].first.text));
    for (const auto& [said, value] : parameter.values) {
      if (type_of_constant(said.text) != type) type = "Text";
    }
    for (const auto& [said, value] : parameter.values) {
      if (type == "Text") continue;  // as it was drafted
      if (const Draft typed = constant(said, type, "")) value->what = typed->what;
    }
    out.type.text = type;
    out.initial = std::make_shared<cdl::Expression>(*parameter.values[0].second);
  }
  into.parameters.push_back(std::move(out));
}

std::vector<cdl::Assemblage> Holes::declarations() {
  std::vector<cdl::Assemblage> out;
  for (Hole& hole : holes_) {
    cdl::Assemblage assemblage;
    assemblage.name.text = hole.name;
    assemblage.result_type.text = hole.result;
    const auto reason = reasons_.find(hole.historic);
    assemblage.help =
        fmt::format("Empty: nothing here answers to the historic `{}`{}.", text::shown(hole.historic),
                    reason == reasons_.end() ? "" : ", " + reason->second);
    for (Parameter& parameter : hole.parameters) settle(parameter, assemblage);
    out.push_back(std::move(assemblage));
  }
  return out;
}

}  // namespace mlab::cdl_historic
