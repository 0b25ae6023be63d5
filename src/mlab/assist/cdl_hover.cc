// What the things of a configuration are.

#include <fmt/core.h>

#include "mlab/assist/cdl_world.h"
#include "mlab/assist/languages.h"
#include "mlab/assist/words.h"
#include "mlab/lang/cdl/test_words.h"

namespace mlab::assist {
namespace {

std::string code(const std::string& line, const std::string& help) {
  return fmt::format("```cdl\n{}\n```\n{}", line, help.empty() ? "" : "\n" + help + "\n");
}

std::string of_type(const ValueType& type) {
  return type.type.empty() ? "" : ": " + shown_type(type);
}

class CdlHover {
 public:
  explicit CdlHover(const CdlWorld& world) : world_(world) {}

  std::string of(const CdlName& name) const {
    const Name meant = world_.resolve(name);
    switch (meant.kind) {
      case NameKind::kAssemblage:
      case NameKind::kProcedure:
      case NameKind::kBinding:
        return component(meant.text);
      case NameKind::kClass:
      case NameKind::kRobot:
      case NameKind::kOperator:
      case NameKind::kSociety:
        return declaration(meant);
      case NameKind::kArgument:
        return argument(name);
      case NameKind::kParameter:
      case NameKind::kLet:
        return variable(name);
      case NameKind::kNode:
        return node(name);
      case NameKind::kState:
        return state(name);
      case NameKind::kDevice:
        return device(name, meant);
      case NameKind::kType:
        return type(name.text);
      case NameKind::kUnit:
        return unit(name);
      case NameKind::kWord:
        return word(name);
      case NameKind::kPercept:
        return percept(name.text);
      case NameKind::kBodySetting:
        return code(name.text, "a number of the simulated body");
      default:
        return "";
    }
  }

 private:
  const CdlDeclaration* around(const CdlName& name) const {
    return name.declaration < 0 ? nullptr
                                : &world_.own().declarations[static_cast<std::size_t>(name.declaration)];
  }

  /// Or an action.
  static std::string percept(const std::string& name) {
    if (const cdl::TestAction* action = cdl::test_action_named(name))
      return code("action " + name, std::string(action->help));
    const cdl::TestPerceptInfo* const info = cdl::test_percept_named(name);
    if (info == nullptr) return "";
    std::string out = code("given " + name, std::string(info->help));
    for (const cdl::TestInput& input : info->inputs)
      out += fmt::format("\n- `{}`: {}; {}", input.name, input.type, input.help);
    return out;
  }

  std::string component(const std::string& name) const {
    const Component* const found = world_.component(name);
    return found == nullptr ? "" : markdown_of(*found);
  }

  std::string declaration(const Name& name) const {
    const CdlWorld::FoundDeclaration found = world_.find(name.kind, name.text);
    if (!found) return "";
    const CdlDeclaration& one = *found.declaration;
    std::string line = fmt::format("{} {}", name_of(one.kind), one.name);
    for (std::size_t i = 0; i < one.parameters.size(); ++i)
      line += (i == 0 ? "(" : ", ") + shown_input(one.parameters[i].input);
    if (!one.parameters.empty()) line += ")";
    if (!one.class_name.empty()) line += " is " + one.class_name;
    std::string out = code(line, one.help);
    for (const CdlDevice& device : one.devices)
      out += fmt::format("\n- `{}`: {} for `{}`", device.name, device.by, device.binds);
    return out;
  }

  std::string argument(const CdlName& name) const {
    const ComponentInput* const input = world_.input_of(name.wanted, world_.own());
    return input == nullptr ? "" : markdown_of(*input);
  }

  std::string variable(const CdlName& name) const {
    const CdlDeclaration* const in = around(name);
    const CdlWorld::Variable found =
        in == nullptr ? CdlWorld::Variable{} : CdlWorld::variable(*in, name.text);
    if (!found) return "";
    if (found.parameter != nullptr) return markdown_of(found.parameter->input);
    return code(fmt::format("let {}{}", found.let->name, of_type(world_.type_of(found.let->value, in))),
                found.let->help);
  }

  std::string node(const CdlName& name) const {
    const CdlDeclaration* const in = around(name);
    if (in == nullptr) return "";
    for (const CdlNode& one : in->nodes) {
      if (one.name == name.text)
        return code(fmt::format("node {}{}", one.name, of_type(world_.type_of(one.value, in))), "");
    }
    return "";
  }

  std::string state(const CdlName& name) const {
    const CdlDeclaration* const in = around(name);
    if (in == nullptr) return "";
    for (const CdlState& one : in->states) {
      if (one.name != name.text || one.sequence != name.sequence) continue;
      return code(
          fmt::format("{}{}state {}", one.is_start ? "start " : "", one.is_final ? "final " : "", one.name),
          one.help);
    }
    return "";
  }

  std::string device(const CdlName& name, const Name& meant) const {
    for (const CdlWorld::FoundDeclaration& of : world_.all(NameKind::kClass)) {
      for (const CdlDevice& one : of.declaration->devices) {
        if (one.name != name.text || of.scan->source != meant.target.source || one.span != meant.target.span)
          continue;
        return code(fmt::format("{} {}: {} binds {}", one.is_actuator ? "actuator" : "sensor", one.name,
                                one.by, one.binds),
                    one.help);
      }
    }
    return "";
  }

  static std::string type(const std::string& name) {
    const ValueType value = value_type(name, "");
    std::string help;
    for (const std::string& word : words_of(value.type)) help += (help.empty() ? "one of `" : "`, `") + word;
    if (!help.empty()) help += "`";
    return code(
        value.type == name && value.unit.empty() ? name : fmt::format("{} = {}", name, shown_type(value)),
        help);
  }

  std::string unit(const CdlName& name) const {
    const ValueType wanted = world_.wanted_type(name.wanted, world_.own());
    if (wanted.unit.empty() || wanted.unit == name.text) return fmt::format("unit `{}`", name.text);
    return fmt::format("unit `{}`, converted to {}", name.text, wanted.unit);
  }

  std::string word(const CdlName& name) const {
    const ValueType wanted = world_.wanted_type(name.wanted, world_.own());
    return wanted.type.empty() ? "" : code(fmt::format("{}: {}", name.text, wanted.type), "");
  }

  const CdlWorld& world_;
};

}  // namespace

// On a sign, or on a number beside it: what the innermost formula gives.
static std::optional<Hover> hover_formula(const CdlWorld& world, const Text& text, std::uint32_t cursor) {
  std::optional<Hover> out;
  for (const CdlDeclaration& declaration : world.own().declarations) {
    for (const cdl::Expression* formula : declaration.formulas) {
      const text::Span span = formula->place.span;
      if (cursor < span.begin || cursor > span.end) continue;
      const ValueType type = world.type_of(formula, &declaration);
      if (type.type.empty()) continue;
      out = Hover{code(std::string(text.source->text(span)) + of_type(type), ""), span};
    }
  }
  return out;
}

std::optional<Hover> hover_cdl(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const CdlWorld world(text.source, around);
  for (const CdlName& name : world.own().names) {
    if (name.span.begin > cursor || cursor > name.span.end) continue;
    std::string markdown = CdlHover(world).of(name);
    if (!markdown.empty()) return Hover{std::move(markdown), name.span};
  }
  for (const text::Span word : world.own().written.words) {
    if (word.begin > cursor || cursor > word.end) continue;
    const std::string_view help = cdl_word_help(text.source->text(word));
    if (!help.empty()) return Hover{std::string(help), word};
  }
  return hover_formula(world, text, cursor);
}

namespace {

Symbol symbol(const std::string& name, NameKind kind, std::string detail, text::Span whole, text::Span span) {
  return {name, std::string(name_of(kind)), std::move(detail), whole, span, {}};
}

}  // namespace

std::vector<Symbol> symbols_cdl(const Text& text, const Surroundings& around) {
  const CdlWorld world(text.source, around);
  std::vector<Symbol> out;
  for (const CdlDeclaration& one : world.own().declarations) {
    if (one.name.empty()) continue;
    const Component* const component = one.kind == NameKind::kAssemblage || one.kind == NameKind::kBinding
                                           ? world.component(one.name)
                                           : nullptr;
    Symbol& made = out.emplace_back(
        symbol(one.name, one.kind, component == nullptr ? one.class_name : shown_type(component->output),
               one.whole, one.span));
    made.help = first_sentence(one.help);
    for (const CdlParameter& parameter : one.parameters)
      made.parts.push_back(symbol(parameter.input.name, NameKind::kParameter,
                                  shown_type(parameter.input.value), parameter.whole, parameter.span));
    for (const CdlLet& let : one.lets)
      made.parts.push_back(
          symbol(let.name, NameKind::kLet, shown_type(world.type_of(let.value, &one)), let.whole, let.span));
    for (const CdlDevice& device : one.devices)
      made.parts.push_back(symbol(device.name, NameKind::kDevice, device.binds, device.whole, device.span));
    for (const CdlState& state : one.states)
      made.parts.push_back(symbol(state.name, NameKind::kState, "", state.whole, state.span));
  }
  return out;
}

std::vector<Hint> hints_cdl(const Text& text, const Surroundings& around) {
  const CdlWorld world(text.source, around);
  std::vector<Hint> out;
  for (const CdlScan::Literal& one : world.own().literals) {
    const ComponentInput* const input = world.input_of(one.wanted, world.own());
    if (input == nullptr) continue;
    const std::string help = first_sentence(input->help);
    if (one.wanted.argument.empty()) out.push_back({one.span.begin, input->name + ":", false, help});
    if (one.lacks_unit && !input->value.unit.empty())
      out.push_back({one.span.end, input->value.unit, true, help});
  }
  return out;
}

std::vector<Shade> tokens_cdl(const Text& text) {
  const CdlScan scan = scan_cdl(text.source);
  std::vector<Shade> out;
  for (const cdl::Comment& comment : scan.written.tokens.comments)
    out.push_back({comment.span, Shade::Kind::kComment});
  for (const text::Span word : scan.written.words) out.push_back({word, Shade::Kind::kKeyword});
  for (const cdl::Token& token : scan.written.tokens.tokens) {
    if (token.kind == cdl::Token::Kind::kNumber) out.push_back({token.span, Shade::Kind::kNumber});
    if (token.kind == cdl::Token::Kind::kText || token.kind == cdl::Token::Kind::kUnclosed)
      out.push_back({token.span, Shade::Kind::kText});
  }
  return out;
}

std::vector<Name> names_cdl(const Text& text, const Surroundings& around) {
  return CdlWorld(text.source, around).names();
}

}  // namespace mlab::assist
