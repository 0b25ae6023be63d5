#include <algorithm>
#include <charconv>

#include <fmt/core.h>

#include "mlab/lang/cnl/cursor.h"

namespace mlab::cnl {
namespace {

// A node that forgot its `nend` must not swallow the next one.
const std::initializer_list<std::string_view> kAfterLinks = {"nend", "node", "sequence", "select", "delay"};

bool read_node_name(Cursor& cursor, Word& into, std::string_view what) {
  const std::optional<Word> name = cursor.expect_node_name(what);
  if (name) into = *name;
  return name.has_value();
}

// A source; `MODULE : NODE` is read whole and refused.
std::optional<flow::Source> parse_link_source(Cursor& cursor) {
  auto source = cursor.expect_source("a constant or the name of a node");
  if (!source || source->kind != flow::Source::Kind::kName || !cursor.is(":")) return source;
  cursor.advance();
  const auto node = cursor.expect_name("the name of the node in that module");
  if (!node) return std::nullopt;
  cursor
      .error("remote-node", source->place,
             fmt::format("`{}:{}` is a node of another robot", source->text, node->text))
      .hints.emplace_back("robots tell each other things by notifications");
  source->text += ":" + node->text;
  return source;
}

void parse_link(Cursor& cursor, flow::Node& node) {
  cursor.line(2, !node.links.empty());  // links that pair by position may share a line
  flow::Link link;
  const auto input = cursor.expect_name("an input of the node, or `nend`");
  if (!input || !cursor.expect("=", "after the input")) {
    cursor.skip_past_semicolon_or_to(kAfterLinks);
    return;
  }
  link.input = input->text;
  link.place = input->place;
  const auto source = parse_link_source(cursor);
  if (!source) {
    cursor.skip_past_semicolon_or_to(kAfterLinks);
    return;
  }
  link.source = *source;
  cursor.expect(";", "after the link");
  node.links.push_back(std::move(link));
}

// True at the word that closes a node; says so where something else follows.
void finish_node(Cursor& cursor, const flow::Node& node) {
  if (cursor.take("nend")) return;
  auto& diagnostic = cursor.expected("`nend`");
  diagnostic.notes.push_back({fmt::format("to close `{}`", node.name), node.place});
}

std::string take_description(Cursor& cursor) {
  if (!cursor.is(Token::Kind::kDescription)) return {};
  std::string text(cursor.text().substr(1, cursor.text().size() - 2));
  cursor.advance();
  return text;
}

void parse_links(Cursor& cursor, flow::Node& node) {
  // An input may be called `delay`.
  while (!cursor.at_end() && (!cursor.is_any(kAfterLinks) || cursor.is_before("="))) parse_link(cursor, node);
}

// `when [not] TRIGGER goto STATE [restart];`
bool parse_transition(Cursor& cursor, flow::State& state) {
  cursor.line(4);
  flow::Transition transition;
  transition.place = cursor.here();
  cursor.advance();
  transition.is_negated = cursor.take("not");
  auto trigger = cursor.expect_source("the trigger of the transition");
  if (!trigger || !cursor.expect("goto", "after the trigger")) return false;
  transition.trigger = std::move(*trigger);
  const text::Place target_place = cursor.here();
  const auto target = cursor.expect_name("the state to go to");
  if (!target) return false;
  transition.target = target->text;
  transition.place = target_place;
  transition.restarts = cursor.take("restart");
  cursor.expect(";", "after the transition");
  state.transitions.push_back(std::move(transition));
  return true;
}

// `[start] [final] state NAME is MEMBER;` and its transitions.
bool parse_state(Cursor& cursor, flow::Node& node) {
  cursor.line(2);
  flow::State state;
  for (;;) {
    if (cursor.take("start")) {
      state.is_start = true;
    } else if (cursor.take("final")) {
      state.is_final = true;
    } else {
      break;
    }
  }
  if (!cursor.expect("state", "of the sequence, or `nend`")) return false;
  const auto name = cursor.expect_name("the name of the state");
  if (!name || !cursor.expect("is", "after the name of the state")) return false;
  state.name = name->text;
  state.place = name->place;
  auto member = parse_link_source(cursor);
  if (!member) return false;
  state.member = std::move(*member);
  cursor.expect(";", "after the member of the state");
  while (cursor.is("when")) {
    if (!parse_transition(cursor, state)) {
      cursor.skip_past_semicolon_or_to({"when", "start", "final", "state", "nend"});
    }
  }
  node.states.push_back(std::move(state));
  return true;
}

void parse_sequence_body(Cursor& cursor, flow::Node& node) {
  while (!cursor.at_end() && !cursor.is("nend")) {
    if (!parse_state(cursor, node)) cursor.skip_past_semicolon_or_to({"start", "final", "state", "nend"});
    if (cursor.is_any({"node", "sequence", "select", "delay"})) return;
  }
}

std::optional<std::int64_t> parse_case_value(Cursor& cursor) {
  if (cursor.is(Token::Kind::kCharacter) && cursor.text().size() == 3) {
    const auto value = static_cast<std::int64_t>(cursor.text()[1]);
    cursor.advance();
    return value;
  }
  const text::Place at = cursor.here();
  const std::string text(cursor.text());
  if (!cursor.expect_number("a whole number")) return std::nullopt;
  const std::string digits = canonical_number(text);
  std::int64_t value = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (failure != std::errc() || end != digits.data() + digits.size()) {
    cursor.error("syntax", at, fmt::format("a case is a whole number, `{}` is none", digits));
  }
  return value;
}

// `case 2, 4: MEMBER;` or `otherwise: MEMBER;`
bool parse_case(Cursor& cursor, flow::Node& node) {
  cursor.line(2);
  flow::Case one;
  one.place = cursor.here();
  if (!cursor.take("otherwise")) {
    if (!cursor.expect("case", "or `otherwise`, or `nend`")) return false;
    do {
      const auto value = parse_case_value(cursor);
      if (!value) return false;
      one.values.push_back(*value);
    } while (cursor.take(","));
  }
  if (!cursor.expect(":", "before the member")) return false;
  auto member = cursor.expect_source("the member: a node or a constant");
  if (!member) return false;
  one.member = std::move(*member);
  cursor.expect(";", "after the member");
  node.cases.push_back(std::move(one));
  return true;
}

void parse_select_body(Cursor& cursor, flow::Node& node) {
  while (!cursor.at_end() && !cursor.is("nend")) {
    if (!parse_case(cursor, node)) cursor.skip_past_semicolon_or_to({"case", "otherwise", "nend"});
    if (cursor.is_any({"node", "sequence", "select", "delay"})) return;
  }
}

// Behind the links of a delay: `value` first, and there.
void order_delay(Cursor& cursor, flow::Node& node) {
  const auto value = std::ranges::find_if(node.links, [](const flow::Link& l) { return l.input == "value"; });
  if (value == node.links.end()) {
    cursor.error("missing-value", node.place, fmt::format("the delay `{}` has no `value = ...;`", node.name));
  } else {
    std::rotate(node.links.begin(), value, value + 1);
  }
}

// May stay on one line where its author wrote it on one.
void note_one_liner(Cursor& cursor, std::uint32_t begin) {
  cursor.layout().one_liners.push_back({begin, cursor.last_end()});
}

}  // namespace

// `[public] node NAME is PROCEDURE [|text|] with LINKS nend`, `remote node MODULE : NAME is PROCEDURE`
void parse_node(Cursor& cursor, Tree& tree) {
  cursor.line(0);
  NodeDecl decl;
  const std::uint32_t begin = cursor.token().span.begin;
  const text::Place first = cursor.here();
  decl.is_public = cursor.take("public");
  const bool is_remote = cursor.take("remote");
  if (is_remote) {
    cursor.error("remote-node", first, "a `remote node` is a node of another robot")
        .hints.emplace_back("robots tell each other things by notifications");
  }
  Word name;
  if (!cursor.expect("node", decl.is_public ? "after `public`" : "after `remote`") ||
      !read_node_name(cursor, name, "the name of the node")) {
    cursor.skip_to(kDeclarationWords);
    return;
  }
  if (is_remote) {
    decl.remote_module = name;
    if (!cursor.expect(":", "after the module") ||
        !cursor.read_name(name, "the name of the node in that module")) {
      cursor.skip_to(kDeclarationWords);
      return;
    }
  }
  decl.node.name = name.text;
  decl.node.place = name.place;
  Word behavior;
  if (!cursor.expect("is", "after the name of the node") ||
      !cursor.read_name(behavior, "the procedure that the node is an instance of")) {
    cursor.skip_to({"nend", "node"});
    cursor.take("nend");
    return;
  }
  decl.node.behavior = behavior.text;
  decl.node.behavior_place = behavior.place;
  if (!is_remote) {
    decl.description = take_description(cursor);
    const bool is_whole = cursor.expect("with", "before the links of the node");
    parse_links(cursor, decl.node);
    if (cursor.is("nend") && !decl.node.links.empty()) cursor.line(0);
    if (is_whole || cursor.is("nend")) finish_node(cursor, decl.node);
    if (!is_whole) return;
    note_one_liner(cursor, begin);
  }
  tree.items.emplace_back(std::move(decl));
}

// `sequence NAME of TYPE with ...`, `select NAME of TYPE by SOURCE with ...`, `delay NAME of TYPE with ...`
void parse_operator(Cursor& cursor, Tree& tree) {
  cursor.line(0);
  NodeDecl decl;
  flow::Node& node = decl.node;
  const std::uint32_t begin = cursor.token().span.begin;
  node.kind = cursor.is("sequence") ? flow::Node::Kind::kSequence
              : cursor.is("select") ? flow::Node::Kind::kSelect
                                    : flow::Node::Kind::kDelay;
  const std::string word(cursor.text());
  cursor.advance();
  Word name;
  Word type;
  if (!read_node_name(cursor, name, fmt::format("the name of the {}", word)) ||
      !cursor.expect("of", "and the type of its output") ||
      !cursor.read_name(type, "the type of the output")) {
    cursor.skip_to({"nend", "node"});
    cursor.take("nend");
    return;
  }
  node.name = name.text;
  node.place = name.place;
  node.behavior = type.text;
  node.behavior_place = type.place;
  if (node.kind == flow::Node::Kind::kSelect && cursor.expect("by", "and what selects")) {
    if (auto selector = cursor.expect_source("the node that selects")) node.selector = std::move(*selector);
  }
  decl.description = take_description(cursor);
  cursor.expect("with", fmt::format("before the parts of the {}", word));
  switch (node.kind) {
    case flow::Node::Kind::kSequence:
      parse_sequence_body(cursor, node);
      break;
    case flow::Node::Kind::kSelect:
      parse_select_body(cursor, node);
      break;
    default:
      parse_links(cursor, node);
      order_delay(cursor, node);
  }
  if (cursor.is("nend")) cursor.line(0);
  finish_node(cursor, node);
  if (node.kind == flow::Node::Kind::kDelay) note_one_liner(cursor, begin);
  tree.items.emplace_back(std::move(decl));
}

// `parameter TYPE [unit] NAME = CONSTANT [in LOW .. HIGH];`
void parse_parameter(Cursor& cursor, Tree& tree) {
  cursor.line(0);
  flow::Parameter parameter;
  const std::string help = cursor.doc_above().help;
  cursor.advance();
  const auto type = cursor.expect_name("the type of the parameter");
  const Word unit = type ? cursor.take_unit() : Word{};
  const auto name = type ? cursor.expect_name("the name of the parameter") : std::nullopt;
  if (!name || !cursor.expect("=", "and the value that the parameter starts with")) {
    cursor.skip_past_semicolon_or_to(kDeclarationWords);
    return;
  }
  auto initial = cursor.expect_source("the value that the parameter starts with");
  std::optional<double> low;
  std::optional<double> high;
  text::Place range;
  if (!initial || !parse_range(cursor, low, high, range)) {
    cursor.skip_past_semicolon_or_to(kDeclarationWords);
    return;
  }
  parameter.name = name->text;
  parameter.place = name->place;
  parameter.type = type->text;
  parameter.unit = unit.text;
  parameter.initial = std::move(*initial);
  if (low) parameter.min = *low;
  if (high) parameter.max = *high;
  if (low && high && *low > *high) cursor.error("empty-range", range, "no value is in this range");
  cursor.expect(";", "after the parameter");
  parameter.help = cursor.doc_behind();
  if (parameter.help.empty()) parameter.help = help;
  tree.items.emplace_back(ParameterDecl{std::move(parameter)});
}

}  // namespace mlab::cnl
