// What is answered about procedures and networks.

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <set>

#include <fmt/core.h>

#include "mlab/assist/candidates.h"
#include "mlab/assist/cnl_scan.h"
#include "mlab/assist/component.h"
#include "mlab/assist/languages.h"
#include "mlab/assist/words.h"
#include "mlab/lang/cdl/types/units.h"
#include "mlab/lang/cnl/parser.h"

namespace mlab::assist {
namespace {

namespace fs = std::filesystem;

const std::map<std::string_view, Component>& library_procedures() {
  static const std::map<std::string_view, Component> kProcedures = [] {
    std::map<std::string_view, Component> out;
    for (const flow::Behavior* behavior : robot::component_library().behaviors())
      out.emplace(behavior->name, component_of(*behavior));
    return out;
  }();
  return kProcedures;
}

/// A network file with what it includes.
class CnlWorld {
 public:
  CnlWorld(const text::SourcePtr& source, const Surroundings& around) : around_(around) {
    seen_.insert(canonical_path(source->name()));
    scan_ = scan_cnl(source);
    read(source, scan_);
  }

  const CnlScan& own() const { return scan_; }

  const Component* component(const std::string& name) const {
    for (const Component& one : procedures_) {
      if (one.name == name) return &one;
    }
    const auto known = library_procedures().find(name);
    if (known != library_procedures().end()) return &known->second;
    const flow::Library::Entry entry = robot::component_library().find(name);
    if (entry.behavior == nullptr) return nullptr;
    const auto named = library_procedures().find(entry.behavior->name);
    return named == library_procedures().end() ? nullptr : &named->second;
  }

  std::vector<const Component*> components() const {
    std::map<std::string_view, const Component*> out;
    for (const auto& [name, one] : library_procedures()) out[name] = &one;
    for (const Component& one : procedures_) out[one.name] = &one;
    std::vector<const Component*> list;
    for (const auto& [name, one] : out) list.push_back(one);
    return list;
  }

  const CnlDeclaration* node(std::string_view name) const {
    for (const CnlDeclaration& one : scan_.declarations) {
      if ((one.kind == NameKind::kNode || one.kind == NameKind::kParameter) && one.name == name) return &one;
    }
    return nullptr;
  }

  ValueType type_of(const CnlDeclaration& one) const {
    if (one.word != "node") return value_type(one.of, one.unit);
    const Component* const called = component(one.of);
    return called == nullptr ? ValueType{} : called->output;
  }

  ValueType wanted(int declaration, const std::string& input, const CnlScan& scan) const {
    if (declaration < 0) return {};
    const CnlDeclaration& in = scan.declarations[static_cast<std::size_t>(declaration)];
    if (input == "trigger") return {"bool", ""};
    if (in.word != "node") return input == "selector" ? ValueType{} : value_type(in.of, "");
    const Component* const called = component(in.of);
    const ComponentInput* const found = called == nullptr ? nullptr : find_input(*called, input);
    return found == nullptr ? ValueType{} : found->value;
  }

  Name resolve(const CnlName& name) const {
    Name out{name.span, name.kind, name.is_declaration, name.text, {}, false};
    if (name.is_declaration) {
      out.target = {scan_.source, name.span};
      return out;
    }
    if (name.is_source) {
      if (const CnlDeclaration* found = node(name.text)) {
        out.kind = found->kind;
        out.target = {scan_.source, found->span};
      }
    } else if (name.kind == NameKind::kProcedure) {
      if (const Component* found = component(name.text)) {
        out.target = found->declaration;
        out.is_library = !found->is_own;
      }
    } else if (name.kind == NameKind::kState && name.declaration >= 0) {
      for (const CnlState& state : scan_.declarations[static_cast<std::size_t>(name.declaration)].states) {
        if (state.name == name.text) out.target = {scan_.source, state.span};
      }
    } else if (name.kind == NameKind::kArgument && name.declaration >= 0) {
      resolve_input(name, out);
    } else if (name.kind == NameKind::kType) {
      for (const CnlDeclaration& one : scan_.declarations) {
        if (one.kind == NameKind::kType && one.name == name.text) out.target = {scan_.source, one.span};
      }
    }
    return out;
  }

  std::vector<Name> names() const {
    std::vector<Name> out;
    for (const CnlName& name : scan_.names) out.push_back(resolve(name));
    for (const CnlName& include : scan_.includes) {
      Name file{include.span, NameKind::kFile, false, include.text, {}, false};
      for (const text::SourcePtr& source : sources_) {
        if (source->name().ends_with(include.text)) file.target = {source, {0, 0}};
      }
      out.push_back(std::move(file));
    }
    for (Name& name : code_names(scan_)) out.push_back(std::move(name));
    std::ranges::sort(out, {}, [](const Name& name) { return name.span.begin; });
    return out;
  }

 private:
  void resolve_input(const CnlName& name, Name& out) const {
    const Component* const called =
        component(scan_.declarations[static_cast<std::size_t>(name.declaration)].of);
    const ComponentInput* const input = called == nullptr ? nullptr : find_input(*called, name.text);
    if (input != nullptr) out.target = input->declaration;
  }

  void read(const text::SourcePtr& source, const CnlScan& scan) {
    text::Diagnostics unsaid;
    const cnl::Tree tree = cnl::parse(source, unsaid);
    for (const cnl::Item& item : tree.items) {
      const auto* procedure = std::get_if<cnl::Procedure>(&item);
      if (procedure == nullptr) continue;
      procedures_.push_back(component_of(*procedure));
    }
    for (const CnlName& include : scan.includes) {
      if (include.text.find('\0') != std::string::npos || seen_.size() > kMostFiles) continue;
      const std::string path = (fs::path(source->name()).parent_path() / include.text).string();
      if (!seen_.insert(canonical_path(path)).second) continue;
      if (const auto file = around_.files.read(path)) {
        sources_.push_back(*file);
        read(*file, scan_cnl(*file));
      }
    }
  }

  const Surroundings& around_;
  CnlScan scan_;
  std::set<std::string> seen_;
  std::vector<text::SourcePtr> sources_;
  std::deque<Component> procedures_;
};

class CnlCompleter {
 public:
  CnlCompleter(const CnlWorld& world, const CnlScan& before, CandidateList& out)
      : world_(world), before_(before), out_(out) {}

  void run() {
    for (const CnlWant& want : before_.wants) add(want);
  }

 private:
  const CnlDeclaration* open() const {
    if (before_.open < 0) return nullptr;
    const CnlDeclaration& one = before_.declarations[static_cast<std::size_t>(before_.open)];
    for (const CnlDeclaration& whole : world_.own().declarations) {
      if (whole.whole.begin == one.whole.begin) return &whole;
    }
    return &one;
  }

  void add(const CnlWant& want) {
    switch (want.kind) {
      case CnlWant::Kind::kKeyword:
        for (const std::string& word : want.words)
          out_.add(word, "keyword", cnl_word_help(word.substr(0, word.find_first_of(" :"))));
        break;
      case CnlWant::Kind::kProcedure:
        for (const Component* one : world_.components())
          out_.add({.text = one->name,
                    .kind = "procedure",
                    .detail = shown_signature(*one).substr(one->name.size()),
                    .help = first_sentence(one->help)},
                   one->is_own ? 0 : 1);
        break;
      case CnlWant::Kind::kInput:
        inputs(want);
        break;
      case CnlWant::Kind::kSource:
        sources(want);
        break;
      case CnlWant::Kind::kType:
        types();
        break;
      case CnlWant::Kind::kState:
        if (const CnlDeclaration* in = open()) {
          for (const CnlState& state : in->states) out_.add(state.name, "state");
        }
        break;
      case CnlWant::Kind::kUnit:
      case CnlWant::Kind::kRange:
        for (const std::string& unit : cdl::unit_names()) out_.add(unit, "unit");
        break;
      case CnlWant::Kind::kCode:
        code();
        break;
    }
  }

  void inputs(const CnlWant& want) {
    const CnlDeclaration* const in = open();
    if (in == nullptr) return;
    if (in->word == "delay") {
      for (const char* name : {"value", "initial"}) out_.add(input_named(name, in->of, ""));
      return;
    }
    const Component* const called = world_.component(in->of);
    if (called == nullptr) return;
    for (const ComponentInput& input : called->inputs) {
      if (want.given.contains(input.name) && !input.is_list) continue;
      out_.add(input_named(input.name, shown_input(input).substr(input.name.size() + 2),
                           first_sentence(input.help)),
               input.initial.empty() ? 0 : 1);
    }
  }

  static Candidate input_named(const std::string& name, const std::string& detail, const std::string& help) {
    return {
        .text = name, .kind = "argument", .detail = detail, .help = help, .is_call = false, .has_more = true};
  }

  void sources(const CnlWant& want) {
    const ValueType wanted = world_.wanted(before_.open, want.input, before_);
    for (const std::string& word : words_of(wanted.type))
      out_.add({.text = word, .kind = "word", .detail = wanted.type}, 0);
    for (const CnlDeclaration& one : world_.own().declarations) {
      if (one.kind != NameKind::kNode && one.kind != NameKind::kParameter) continue;
      const ValueType type = world_.type_of(one);
      out_.add({.text = one.name,
                .kind = std::string(name_of(one.kind)),
                .detail = type.type + bracketed(type.unit)},
               fits(type, wanted) ? 1 : 5);
    }
    if (want.input == "trigger") out_.add("not", "keyword", "", 2);
  }

  void types() {
    for (const CnlDeclaration& one : world_.own().declarations) {
      if (one.kind == NameKind::kType) out_.add(one.name, "type", "", 0);
    }
    out_.add("void", "type", "a sink: it has no output", 2);
    for (const flow::ValueTypeInfo& one : flow::kValueTypes) out_.add(one.name, "type");
  }

  void code() {
    for (const char* word : {"header", "body", "pend"}) out_.add(word, "keyword", cnl_word_help(word), 3);
    for (const auto& [name, help] : {std::pair{"output", "the value to give"},
                                     {"percepts", "what the robot perceives"},
                                     {"action", "what it does"},
                                     {"random", "random numbers of this node in this cycle"},
                                     {"time", "seconds since the start of the run"},
                                     {"cycle", "number of the cycle"},
                                     {"cycle_duration", "in seconds"}})
      out_.add(name, "let", help, 1);
    const CnlDeclaration* const in = open();
    const Component* const called = in == nullptr ? nullptr : world_.component(in->name);
    if (called == nullptr) return;
    for (const ComponentInput& input : called->inputs)
      out_.add({.text = input.name,
                .kind = "parameter",
                .detail = shown_input(input).substr(input.name.size() + 2),
                .help = first_sentence(input.help)},
               0);
  }

  const CnlWorld& world_;
  const CnlScan& before_;
  CandidateList& out_;
};

bool is_in_comment(const CnlScan& scan, std::uint32_t cursor) {
  return std::ranges::any_of(scan.comments, [&](const cnl::Comment& comment) {
    const bool is_line = scan.source->text(comment.span).starts_with("//");
    return comment.span.begin < cursor &&
           (cursor < comment.span.end || (cursor == comment.span.end && (is_line || !comment.is_closed)));
  });
}

std::string hover_of(const CnlWorld& world, const CnlName& name) {
  const Name meant = world.resolve(name);
  if (meant.kind == NameKind::kProcedure) {
    const Component* const found = world.component(name.text);
    return found == nullptr ? "" : markdown_of(*found);
  }
  if (meant.kind == NameKind::kArgument && name.declaration >= 0) {
    const Component* const called =
        world.component(world.own().declarations[static_cast<std::size_t>(name.declaration)].of);
    const ComponentInput* const input = called == nullptr ? nullptr : find_input(*called, name.text);
    return input == nullptr ? "" : markdown_of(*input);
  }
  if (meant.kind == NameKind::kParameter && name.declaration >= 0) {
    const CnlDeclaration& in = world.own().declarations[static_cast<std::size_t>(name.declaration)];
    const Component* const procedure = in.word == "procedure" ? world.component(in.name) : nullptr;
    const ComponentInput* const input = procedure == nullptr ? nullptr : find_input(*procedure, name.text);
    if (input != nullptr) return markdown_of(*input);
  }
  if (meant.kind == NameKind::kNode || meant.kind == NameKind::kParameter) {
    const CnlDeclaration* const node = world.node(name.text);
    if (node == nullptr) return "";
    const ValueType type = world.type_of(*node);
    return fmt::format("```cnl\n{} {}: {}{}\n```\n{}", node->word, node->name, type.type,
                       bracketed(type.unit),
                       node->word == "node" ? fmt::format("\nan instance of `{}`\n", node->of) : "");
  }
  if (meant.kind == NameKind::kState) return fmt::format("state `{}`", name.text);
  if (meant.kind == NameKind::kType) return fmt::format("```cnl\n{}\n```\n", value_type(name.text, "").type);
  return "";
}

}  // namespace

Completions complete_cnl(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const std::string_view all = text.source->text();
  const CnlWorld world(text.source, around);
  if (is_in_comment(world.own(), cursor)) return {{cursor, cursor}, {}, false};
  const std::uint32_t begin = word_begin(all, cursor);
  const bool is_number =
      begin == cursor && begin > 0 && std::string_view("0123456789").contains(all[begin - 1]);
  if (is_number) return {{cursor, cursor}, {}, false};
  CandidateList out(std::string(all.substr(begin, cursor - begin)));
  const CnlScan before =
      scan_cnl(std::make_shared<const text::Source>(text.source->name(), std::string(all.substr(0, begin))));
  if (is_in_comment(before, begin)) return {{cursor, cursor}, {}, false};
  CnlCompleter(world, before, out).run();
  return out.take({begin, cursor});
}

std::vector<Name> names_cnl(const Text& text, const Surroundings& around) {
  return CnlWorld(text.source, around).names();
}

std::optional<Hover> hover_cnl(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const CnlWorld world(text.source, around);
  for (const CnlName& name : world.own().names) {
    if (name.span.begin > cursor || cursor > name.span.end) continue;
    std::string markdown = hover_of(world, name);
    if (!markdown.empty()) return Hover{std::move(markdown), name.span};
  }
  for (const text::Span word : world.own().words) {
    if (word.begin > cursor || cursor > word.end) continue;
    const std::string_view help = cnl_word_help(text.source->text(word));
    if (!help.empty()) return Hover{std::string(help), word};
  }
  return std::nullopt;
}

std::vector<Symbol> symbols_cnl(const Text& text, const Surroundings& around) {
  const CnlWorld world(text.source, around);
  std::vector<Symbol> out;
  for (const CnlDeclaration& one : world.own().declarations) {
    if (one.name.empty()) continue;
    const ValueType type = world.type_of(one);
    Symbol& made = out.emplace_back(Symbol{
        one.name, std::string(name_of(one.kind)), type.type + bracketed(type.unit), one.whole, one.span, {}});
    for (const CnlState& state : one.states)
      made.parts.push_back({state.name, "state", "", state.span, state.span, {}});
    for (const CnlState& input : one.inputs)
      made.parts.push_back({input.name, "parameter", "", input.span, input.span, {}});
  }
  return out;
}

std::vector<Hint> hints_cnl(const Text& text, const Surroundings& around) {
  const CnlWorld world(text.source, around);
  std::vector<Hint> out;
  for (const CnlName& name : world.own().names) {
    if (name.kind != NameKind::kArgument || name.declaration < 0) continue;
    const Component* const called =
        world.component(world.own().declarations[static_cast<std::size_t>(name.declaration)].of);
    const ComponentInput* const input = called == nullptr ? nullptr : find_input(*called, name.text);
    if (input == nullptr || input->value.unit.empty()) continue;
    const auto next = std::ranges::find_if(world.own().tokens, [&](const cnl::Token& token) {
      return token.kind == cnl::Token::Kind::kNumber && token.span.begin >= name.span.end;
    });
    if (next == world.own().tokens.end()) continue;
    const std::string_view between = text.source->text({name.span.end, next->span.begin});
    const bool is_given = between.find('=') != std::string_view::npos &&
                          between.find_first_not_of(" \t\n=-") == std::string_view::npos;
    if (is_given) out.push_back({next->span.end, input->value.unit, true, first_sentence(input->help)});
  }
  return out;
}

std::vector<Shade> tokens_cnl(const Text& text) {
  const CnlScan scan = scan_cnl(text.source);
  std::vector<Shade> out;
  for (const cnl::Comment& comment : scan.comments) out.push_back({comment.span, Shade::Kind::kComment});
  for (const text::Span word : scan.words) out.push_back({word, Shade::Kind::kKeyword});
  for (const cnl::Token& token : scan.tokens) {
    switch (token.kind) {
      case cnl::Token::Kind::kNumber:
        out.push_back({token.span, Shade::Kind::kNumber});
        break;
      case cnl::Token::Kind::kString:
      case cnl::Token::Kind::kCharacter:
      case cnl::Token::Kind::kInitializer:
      case cnl::Token::Kind::kDescription:
      case cnl::Token::Kind::kUnclosed:
        out.push_back({token.span, Shade::Kind::kText});
        break;
      case cnl::Token::Kind::kDirective:
        out.push_back({token.span, Shade::Kind::kMacro});
        break;
      default:
        break;
    }
  }
  return out;
}

}  // namespace mlab::assist
