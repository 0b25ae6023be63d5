#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "mlab/lang/cnl/parser.h"

namespace mlab::cnl::testing {

/// Everything that a file says, without its places: two files with the same meaning differ in their layout
/// alone.
// NOLINTNEXTLINE(readability-function-size): a line for each part of a network
inline std::string meaning(const text::SourcePtr& source) {
  text::Diagnostics sink;
  const Tree tree = parse(source, sink);
  std::string out = std::to_string(sink.error_count()) + "\n";
  const auto say = [&](const std::string& word) { out += word + "|"; };
  const auto say_source = [&](const flow::Source& s) {
    say(s.text + (s.kind == flow::Source::Kind::kName ? "@" : ""));
  };
  const auto say_code = [&](const std::optional<Code>& code) {
    if (!code) {
      say("-");
      return;
    }
    std::string_view lines = code->text();
    lines.remove_prefix(std::min(lines.find_first_not_of(" \t\r\n"), lines.size()));
    say(std::string(lines.substr(0, lines.find_last_not_of(" \t\r\n") + 1)));
  };
  for (const Item& item : tree.items) {
    say(std::to_string(item.index()));
    if (const auto* p = std::get_if<Procedure>(&item)) {
      for (const Word& w : {p->output_type, p->output_unit, p->name}) say(w.text);
      say(p->help + p->source + std::to_string(p->latency.value_or(0)) + (p->is_pure ? "pure" : ""));
      for (const auto& i : p->inputs) {
        say(i.type.text + i.unit.text + i.name.text + i.help + std::to_string(i.low.value_or(0)));
        if (i.initial) say_source(*i.initial);
      }
      for (const auto& a : p->aliases) {
        say(a.name.text + a.output_unit.text);
        for (const auto& port : a.ports) say(port.name.text + port.unit.text + port.input.text);
      }
      for (const auto& n : p->needs) say(n.sensor.text + n.range.text);
      say_code(p->once);
      say_code(p->header);
      say_code(p->body);
    } else if (const auto* i = std::get_if<Init>(&item)) {
      say_code(i->code);
    } else if (const auto* c = std::get_if<Include>(&item)) {
      say(c->path.text);
    } else if (const auto* n = std::get_if<NodeDecl>(&item)) {
      say(n->node.name + n->node.behavior + n->description);
      for (const auto& link : n->node.links) {
        say(link.input);
        say_source(link.source);
      }
      for (const auto& state : n->node.states) {
        say(state.name + (state.is_start ? "start" : ""));
        say_source(state.member);
        for (const auto& t : state.transitions) {
          say(t.target + (t.is_negated ? "not" : "") + (t.restarts ? "restart" : ""));
          say_source(t.trigger);
        }
      }
      for (const auto& c2 : n->node.cases) {
        for (const auto v : c2.values) say(std::to_string(v));
        say_source(c2.member);
      }
    } else if (const auto* q = std::get_if<ParameterDecl>(&item)) {
      say(q->parameter.name + q->parameter.type + q->parameter.unit + q->parameter.help +
          std::to_string(q->parameter.max));
      say_source(q->parameter.initial);
    }
    out += "\n";
  }
  return out;
}

}  // namespace mlab::cnl::testing
