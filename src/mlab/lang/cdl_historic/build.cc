#include "mlab/lang/cdl_historic/build.h"

#include <algorithm>
#include <iterator>

#include <fmt/core.h>

#include "mlab/lang/cdl/syntax/signs.h"
#include "mlab/text/shown.h"

namespace mlab::cdl_historic {
namespace {

constexpr std::size_t kMaxHelp = 200;  // characters

constexpr std::string_view kWords[] = {
    "active", "alias",  "and",    "architecture", "as",       "assemblage", "binding",   "binds",
    "body",   "by",     "case",   "caste",        "class",    "compete",    "cooperate", "coordinate",
    "delay",  "false",  "final",  "for",          "fuse",     "goto",       "in",        "is",
    "layout", "let",    "not",    "of",           "operator", "or",         "otherwise", "restart",
    "robot",  "select", "sensor", "actuator",     "sequence", "society",    "start",     "team",
    "true",   "use",    "when",   "priority",     "strength"};

void write(const cdl::ExpressionPtr& expression, std::string& out);

void write(const std::vector<cdl::Argument>& arguments, std::string& out) {
  for (const cdl::Argument& argument : arguments) {
    out += argument.name.text + "=";
    write(argument.value, out);
    out += ",";
  }
}

void write(const std::vector<cdl::Member>& members, std::string& out) {
  for (const cdl::Member& member : members) {
    write(member.weight, out);
    out += ":";
    write(member.value, out);
    out += ";";
  }
}

struct Writer {
  std::string& out;
  void operator()(const cdl::Hole& /*nothing stands there*/) const {}
  void operator()(const cdl::Number& n) const { out += fmt::format("{}{}", n.value, n.unit.text); }
  void operator()(const cdl::Text& t) const { out += fmt::format("\"{}\"", t.value); }
  void operator()(const cdl::Name& n) const { out += n.name.text; }
  void operator()(const cdl::List& list) const {
    out += "[";
    for (const cdl::ExpressionPtr& item : list.items) write(item, out), out += ",";
    out += "]";
  }
  void operator()(const cdl::Call& called) const {
    out += called.callee.text + "(";
    write(called.arguments, out);
    out += ")";
  }
  void operator()(const cdl::Logic& logic) const {
    out += fmt::format("logic{}(", static_cast<int>(logic.connective));
    for (const cdl::ExpressionPtr& operand : logic.operands) write(operand, out), out += ",";
    out += ")";
  }
  void operator()(const cdl::Arithmetic& arithmetic) const {
    for (const cdl::Operation operation : arithmetic.operations) out += cdl::sign_of(operation);
    out += "(";
    for (const cdl::ExpressionPtr& operand : arithmetic.operands) write(operand, out), out += ",";
    out += ")";
  }
  void operator()(const cdl::Cooperate& c) const { out += "cooperate{", write(c.members, out), out += "}"; }
  void operator()(const cdl::Compete& c) const { out += "compete{", write(c.members, out), out += "}"; }
  void operator()(const cdl::Coordinate& c) const {
    out += "coordinate ", (*this)(c.by), out += "{", write(c.members, out), out += "}";
  }
  void operator()(const cdl::Fuse& c) const {
    out += "fuse ", (*this)(c.by), out += "{", write(c.members, out), out += "}";
  }
  void operator()(const cdl::Sequence& sequence) const {
    out += "sequence{";
    for (const cdl::State& state : sequence.states) {
      out += fmt::format("{}{}{}:", state.is_start ? "start " : "", state.is_final ? "final " : "",
                         state.name.text);
      write(state.member, out);
      for (const cdl::Transition& transition : state.transitions) {
        out += " when ", write(transition.trigger, out), out += " goto " + transition.target.text;
      }
      out += ";";
    }
    out += "}";
  }
  void operator()(const cdl::Select& select) const {
    out += "select ", write(select.by, out), out += "{";
    for (const cdl::Case& c : select.cases) {
      for (const cdl::Word& value : c.values) out += value.text + ",";
      out += ":", write(c.member, out), out += ";";
    }
    out += "}";
  }
  void operator()(const cdl::Delay& delay) const {
    out += "delay(", write(delay.value, out), out += ",", write(delay.initial, out), out += ")";
  }
};

void write(const cdl::ExpressionPtr& expression, std::string& out) {
  if (expression == nullptr) return;
  std::visit(Writer{out}, expression->what);
}

}  // namespace

std::string legal_name(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool is_digit = c >= '0' && c <= '9';
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (out.empty() && is_digit) out += '_';
    if (is_letter || is_digit) {
      out += c;
    } else if (!out.empty() && out.back() != '_') {
      out += '_';
    }
  }
  while (!out.empty() && out.back() == '_') out.pop_back();
  if (out.empty()) out = "unnamed";
  if (std::ranges::find(kWords, out) != std::end(kWords)) out += '_';
  return out;
}

std::string help_text(std::string_view label) {
  constexpr std::string_view kBlank = " \t\r\n\f\v";
  const std::size_t begin = label.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text::shown(label.substr(begin, label.find_last_not_of(kBlank) - begin + 1), kMaxHelp);
}

std::string fingerprint(const cdl::Expression& expression) {
  std::string out;
  std::visit(Writer{out}, expression.what);
  return out;
}

}  // namespace mlab::cdl_historic
