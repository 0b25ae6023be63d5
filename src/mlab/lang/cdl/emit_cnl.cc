#include "mlab/lang/cdl/emit_cnl.h"

#include <charconv>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mlab/flow/limit.h"
#include "mlab/text/shown.h"

namespace mlab::cdl {
namespace {

bool is_number(std::string_view text) {
  double value = 0.0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failure == std::errc() && end == text.data() + text.size() && !text.ends_with('.') &&
         text.find_first_of("0123456789") != std::string_view::npos;
}

std::string source_text(const flow::Source& source) {
  if (source.kind == flow::Source::Kind::kName) return source.text;
  const bool is_initializer = source.text.starts_with('{') && source.text.ends_with('}');
  return is_number(source.text) || is_initializer ? source.text : fmt::format("\"{}\"", source.text);
}

void put_parameter(std::string& out, const flow::Parameter& parameter) {
  out += fmt::format("parameter {}{} {} = {}", parameter.type,
                     parameter.unit.empty() ? "" : fmt::format(" [{}]", parameter.unit), parameter.name,
                     source_text(parameter.initial));
  if (flow::is_limit(parameter.min) || flow::is_limit(parameter.max))
    out += fmt::format(" in {} .. {}", parameter.min, parameter.max);
  out += ';';
  if (!parameter.help.empty()) out += "  ///< " + parameter.help;
  out += '\n';
}

void put_links(std::string& out, const flow::Node& node) {
  if (node.links.empty()) {
    out += " nend\n";
    return;
  }
  out += '\n';
  for (const flow::Link& link : node.links)
    out += fmt::format("  {} = {};\n", link.input, source_text(link.source));
  out += "nend\n";
}

void put_states(std::string& out, const flow::Node& node) {
  out += '\n';
  for (const flow::State& state : node.states) {
    out += fmt::format("  {}{}state {} is {};\n", state.is_start ? "start " : "",
                       state.is_final ? "final " : "", state.name, source_text(state.member));
    for (const flow::Transition& transition : state.transitions) {
      out += fmt::format("    when {}{} goto {}{};\n", transition.is_negated ? "not " : "",
                         source_text(transition.trigger), transition.target,
                         transition.restarts ? " restart" : "");
    }
  }
  out += "nend\n";
}

void put_cases(std::string& out, const flow::Node& node) {
  out += '\n';
  for (const flow::Case& one : node.cases) {
    out += one.values.empty() ? "  otherwise" : fmt::format("  case {}", fmt::join(one.values, ", "));
    out += fmt::format(": {};\n", source_text(one.member));
  }
  out += "nend\n";
}

void put_node(std::string& out, const flow::Node& node) {
  switch (node.kind) {
    case flow::Node::Kind::kBehavior:
      out += fmt::format("\n{}node {} is {} with", node.is_public ? "public " : "", node.name, node.behavior);
      put_links(out, node);
      return;
    case flow::Node::Kind::kSequence:
      out += fmt::format("\nsequence {} of {} with", node.name, node.behavior);
      put_states(out, node);
      return;
    case flow::Node::Kind::kSelect:
      out +=
          fmt::format("\nselect {} of {} by {} with", node.name, node.behavior, source_text(node.selector));
      put_cases(out, node);
      return;
    case flow::Node::Kind::kDelay:
      out += fmt::format("\ndelay {} of {} with", node.name, node.behavior);
      put_links(out, node);
      return;
  }
}

}  // namespace

void check_for_cnl(const flow::Network& network, text::Diagnostics& sink) {
  for (const flow::Parameter& parameter : network.parameters) {
    if (parameter.place_name.text.empty()) continue;
    sink.error("place-in-cnl", parameter.place_name.place,
               fmt::format("`{}` is a place of the mission's overlay, and a network in CNL knows none",
                           text::shown(parameter.place_name.text)))
        .hints = {"coordinates can be written in CNL: `[12 m, 30 m]`; `--emit cpp` keeps the place"};
  }
}

std::string cnl_text(const flow::Network& network) {
  std::string out = fmt::format("modulename = {};\n", network.name);
  if (!network.parameters.empty()) out += '\n';
  for (const flow::Parameter& parameter : network.parameters) put_parameter(out, parameter);
  for (const flow::Node& node : network.nodes) put_node(out, node);
  return out;
}

}  // namespace mlab::cdl
