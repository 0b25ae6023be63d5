// What could stand at the cursor of a configuration.

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/core.h>

#include "mlab/assist/candidates.h"
#include "mlab/assist/cdl_world.h"
#include "mlab/assist/languages.h"
#include "mlab/assist/words.h"
#include "mlab/flow/value_types.h"
#include "mlab/lang/cdl/test_words.h"
#include "mlab/lang/cdl/types/body.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::assist {
namespace {

constexpr int kBest = 0;
constexpr int kGood = 2;
constexpr int kLikely = 4;
constexpr int kPossible = 6;
constexpr int kUnlikely = 8;

/// The token that the cursor is inside of.
struct Inside {
  bool is_comment = false;
  std::optional<text::Span> text;  ///< between the quotes
};

Inside inside(const CdlScan& scan, std::uint32_t cursor) {
  Inside out;
  for (const cdl::Comment& comment : scan.written.tokens.comments) {
    const bool is_line = scan.source->text(comment.span).starts_with("//");
    const bool is_in =
        comment.span.begin < cursor && (cursor < comment.span.end || is_line || !comment.is_closed);
    if (is_in && cursor <= comment.span.end) out.is_comment = true;
  }
  for (const cdl::Token& token : scan.written.tokens.tokens) {
    const bool is_closed = token.kind == cdl::Token::Kind::kText;
    if (!is_closed && token.kind != cdl::Token::Kind::kUnclosed) continue;
    if (token.span.begin < cursor && (is_closed ? cursor < token.span.end : cursor <= token.span.end))
      out.text = {token.span.begin + 1, is_closed ? token.span.end - 1 : cursor};
  }
  return out;
}

class CdlCompleter {
 public:
  CdlCompleter(const CdlWorld& world, const CdlScan& before, const Text& text, const Surroundings& around,
               CandidateList& out)
      : world_(world), before_(before), text_(text), around_(around), out_(out) {}

  void run() {
    for (const CdlWant& want : before_.wants) add(want);
  }

  void files() {
    if (!around_.list) return;
    const std::string folder = std::filesystem::path(text_.source->name()).parent_path().string();
    const std::string own = std::filesystem::path(text_.source->name()).filename().string();
    for (const std::string& file : around_.list(folder)) {
      if ((file.ends_with(".cdl") || file.ends_with(".cnl")) && file != own)
        out_.add(file, "file", "", kBest);
    }
  }

  void words(const ValueType& wanted) {
    for (const std::string& word : words_of(wanted.type))
      out_.add({.text = word, .kind = "word", .detail = wanted.type, .help = ""}, kBest);
  }

 private:
  const CdlDeclaration* open() const {
    // The whole text knows more of the declaration than what stands before the cursor: lets further down.
    if (before_.open_declaration < 0) return nullptr;
    const CdlDeclaration& one = before_.declarations[static_cast<std::size_t>(before_.open_declaration)];
    for (const CdlDeclaration& whole : world_.own().declarations) {
      if (whole.whole.begin == one.whole.begin) return &whole;
    }
    return &one;
  }

  // NOLINTNEXTLINE(readability-function-size): a row for each kind
  void add(const CdlWant& want) {
    switch (want.kind) {
      case CdlWant::Kind::kKeyword:
        for (const std::string& word : want.words) keyword(word, kGood);
        break;
      case CdlWant::Kind::kArgument:
        arguments(want);
        [[fallthrough]];
      case CdlWant::Kind::kValue:
        values(world_.wanted_type(want.wanted, before_), want);
        break;
      case CdlWant::Kind::kUnit:
        units(world_.wanted_type(want.wanted, before_));
        break;
      case CdlWant::Kind::kUnitName:
        for (const std::string& unit : cdl::unit_names()) out_.add(unit, "unit");
        break;
      case CdlWant::Kind::kType:
        types();
        break;
      case CdlWant::Kind::kState:
        states(want.sequence);
        break;
      case CdlWant::Kind::kOperator:
        operators();
        break;
      case CdlWant::Kind::kClass:
        declarations(NameKind::kClass);
        break;
      case CdlWant::Kind::kMember:
        declarations(NameKind::kRobot);
        declarations(NameKind::kSociety);
        break;
      case CdlWant::Kind::kSocietyOperator:
        declarations(NameKind::kOperator);
        break;
      case CdlWant::Kind::kDevice:
        devices();
        break;
      case CdlWant::Kind::kBinding:
        bindings(want.device);
        break;
      case CdlWant::Kind::kActuator:
        actuators();
        break;
      case CdlWant::Kind::kBodySetting:
        body_settings();
        break;
      case CdlWant::Kind::kCaseValue:
        words(world_.type_of(want.selector, open()));
        break;
      case CdlWant::Kind::kNode:
        nodes(want);
        break;
      case CdlWant::Kind::kOwner:
        for (const NameKind kind : {NameKind::kAssemblage, NameKind::kRobot, NameKind::kSociety}) own(kind);
        break;
      case CdlWant::Kind::kPercept:
        for (const cdl::TestPerceptInfo& one : cdl::kTestPercepts)
          out_.add({.text = std::string(one.name),
                    .kind = "percept",
                    .detail = inputs_of(one),
                    .help = std::string(one.help),
                    .is_call = true},
                   kBest);
        break;
      case CdlWant::Kind::kAction:
        for (const cdl::TestAction& one : cdl::test_actions())
          out_.add(std::string(one.name), "action", std::string(one.help), kBest);
        break;
      case CdlWant::Kind::kTestState:
        tested_states(want.wanted.call);
        break;
      case CdlWant::Kind::kFile:
        out_.add("\"", "keyword", "the name of a file", kBest);
        break;
    }
  }

  void body_settings() {
    const auto add = [&](std::string_view name, std::string_view unit, std::string_view help) {
      out_.add({.text = std::string(name),
                .kind = "body setting",
                .detail = unit.empty() ? "" : fmt::format("[{}]", unit),
                .help = std::string(help),
                .is_call = false,
                .has_more = true});
    };
    add("drive", "", cdl::kDriveHelp);
    for (const cdl::BodyProperty& property : cdl::body_properties())
      add(property.name, property.unit, property.help);
  }

  void keyword(const std::string& word, int rank) {
    out_.add(word, "keyword", cdl_word_help(word.substr(0, word.find_first_of(" :="))), rank);
  }

  void arguments(const CdlWant& want) {
    const std::string& name = before_.names[static_cast<std::size_t>(want.wanted.call)].text;
    const Component* const called = world_.component(name);
    if (called == nullptr) return;
    for (std::size_t i = 0; i < called->inputs.size(); ++i) {
      const ComponentInput& input = called->inputs[i];
      if (want.given.contains(input.name) || static_cast<int>(i) < want.positional) continue;
      const bool is_needed = input.initial.empty() && !input.is_list;
      out_.add({.text = input.name,
                .kind = "argument",
                .detail = shown_input(input).substr(input.name.size() + 2),
                .help = first_sentence(input.help),
                .is_call = false,
                .has_more = true},
               is_needed ? kBest - 1 : kBest);
    }
  }

  void values(const ValueType& wanted, const CdlWant& want) {
    words(wanted);
    variables(wanted);
    const bool is_number = wanted.type == "double" || wanted.type == "int";
    for (const Component* one : world_.components()) {
      if (one->is_sink || !out_.matches(one->name) || !fits(one->output, wanted)) continue;
      out_.add({.text = one->name,
                .kind = one->kind,
                .detail = shown_signature(*one).substr(one->name.size()),
                .help = first_sentence(one->help),
                .is_call = true},
               one->is_own ? kLikely : kPossible);
    }
    if (wanted.type == "Vector" || wanted.type.empty()) {
      keyword("cooperate", kLikely - 1);
      for (const char* word : {"compete by priority", "compete by strength", "coordinate by"})
        keyword(word, kLikely);
    }
    if (wanted.type == "bool" || wanted.type.empty()) keyword("not", kLikely);
    if (!is_number && want.kind == CdlWant::Kind::kValue) {
      for (const char* word : {"sequence", "select by"}) keyword(word, kPossible);
      if (wanted.type != "Vector") keyword("fuse by", kPossible);
    }
    keyword("delay", kUnlikely);
  }

  void variables(const ValueType& wanted) {
    const CdlDeclaration* const in = open();
    if (in == nullptr) return;
    for (const CdlLet& let : in->lets) {
      const ValueType type = world_.type_of(let.value, in);
      out_.add(
          {.text = let.name, .kind = "let", .detail = shown_type(type), .help = first_sentence(let.help)},
          fits(type, wanted) ? kGood : kUnlikely);
    }
    for (const CdlParameter& parameter : in->parameters) {
      out_.add({.text = parameter.input.name,
                .kind = "parameter",
                .detail = shown_input(parameter.input).substr(parameter.input.name.size() + 2),
                .help = first_sentence(parameter.input.help)},
               fits(parameter.input.value, wanted) ? kGood : kUnlikely);
    }
  }

  void units(const ValueType& wanted) {
    const std::vector<std::string> like = units_like(wanted.unit);
    for (const std::string& unit : like)
      out_.add(unit, "unit", unit == wanted.unit ? "as it is declared" : "is converted",
               unit == wanted.unit ? kBest : kGood);
    if (like.empty() && wanted.type.empty()) {
      for (const std::string& unit : cdl::unit_names()) out_.add(unit, "unit", "", kLikely);
    }
  }

  void types() {
    for (const flow::QuantityInfo& one : flow::kQuantities) {
      const std::string type(flow::info(one.type).name);
      out_.add(one.name, "type", one.unit.empty() ? type : fmt::format("{} in {}", type, one.unit), kGood);
    }
    for (const flow::ValueTypeInfo& one : flow::kValueTypes) out_.add(one.name, "type", "", kLikely);
  }

  void states(std::uint32_t sequence) {
    const CdlDeclaration* const in = open();
    if (in == nullptr) return;
    // Sequences are counted through the file; the same one has the same number in the whole text.
    for (const CdlState& state : in->states) {
      if (state.sequence == sequence)
        out_.add({.text = state.name, .kind = "state", .detail = "", .help = first_sentence(state.help)});
    }
  }

  /// `(at: Point, radius: length = 0.2)`
  static std::string inputs_of(const cdl::TestPerceptInfo& percept) {
    std::string out;
    for (const cdl::TestInput& input : percept.inputs)
      out += fmt::format("{}{}: {}", out.empty() ? "(" : ", ", input.name, input.type);
    return out + ")";
  }

  void tested_states(int call) {
    const CdlWorld::FoundDeclaration tested =
        world_.find(NameKind::kAssemblage, before_.names[static_cast<std::size_t>(call)].text);
    if (!tested) return;
    for (const CdlState& state : tested.declaration->states)
      out_.add({.text = state.name, .kind = "state", .detail = "", .help = first_sentence(state.help)});
  }

  void operators() {
    for (const Component* one : world_.components()) {
      if (!std::ranges::any_of(one->inputs, &ComponentInput::is_list)) continue;
      out_.add({.text = one->name,
                .kind = one->kind,
                .detail = shown_signature(*one).substr(one->name.size()),
                .help = first_sentence(one->help),
                .is_call = true});
    }
  }

  void declarations(NameKind kind) {
    for (const CdlWorld::FoundDeclaration& one : world_.all(kind))
      out_.add({.text = one.declaration->name,
                .kind = std::string(name_of(kind)),
                .detail = "",
                .help = first_sentence(one.declaration->help)},
               one.is_library ? kPossible : kGood);
  }

  void own(NameKind kind) {
    for (const CdlDeclaration& one : world_.own().declarations) {
      if (one.kind == kind)
        out_.add({.text = one.name,
                  .kind = std::string(name_of(kind)),
                  .detail = "",
                  .help = first_sentence(one.help)});
    }
  }

  CdlWorld::FoundDeclaration robot_class() const {
    const CdlDeclaration* const in = open();
    return in == nullptr ? CdlWorld::FoundDeclaration{} : world_.find(NameKind::kClass, in->class_name);
  }

  void devices() {
    const CdlWorld::FoundDeclaration of = robot_class();
    if (!of) return;
    for (const CdlDevice& device : of.declaration->devices)
      out_.add({.text = device.name,
                .kind = "device",
                .detail = fmt::format("{} for {}", device.by, device.binds),
                .help = first_sentence(device.help)});
  }

  void bindings(const std::string& device) {
    const CdlWorld::FoundDeclaration of = device.empty() ? CdlWorld::FoundDeclaration{} : robot_class();
    if (of) {
      for (const CdlDevice& one : of.declaration->devices) {
        if (one.name == device) out_.add(one.binds, "binding", "", kBest);
      }
    }
    for (const CdlWorld::FoundDeclaration& one : world_.all(NameKind::kBinding)) {
      if (const Component* binding = world_.component(one.declaration->name))
        out_.add({.text = binding->name,
                  .kind = "binding",
                  .detail = shown_signature(*binding).substr(binding->name.size()),
                  .help = first_sentence(binding->help)},
                 kLikely);
    }
  }

  void actuators() {
    const CdlWorld::FoundDeclaration of = robot_class();
    std::set<std::string> names;
    if (of) {
      for (const CdlDevice& device : of.declaration->devices) {
        if (device.is_actuator) names.insert(device.binds);
        if (device.is_actuator) actuator(device.name, first_sentence(device.help), kLikely);
      }
    }
    for (const CdlWorld::FoundDeclaration& one : world_.all(NameKind::kBinding)) {
      const std::string& name = one.declaration->name;
      const Component* const binding = world_.component(name);
      if (binding == nullptr || (!binding->is_sink && !names.contains(name))) continue;
      actuator(name, first_sentence(one.declaration->help), names.contains(name) || !of ? kBest : kUnlikely);
    }
  }

  void actuator(const std::string& name, const std::string& help, int rank) {
    out_.add(
        {.text = name, .kind = "binding", .detail = "", .help = help, .is_call = false, .has_more = true},
        rank);
  }

  void nodes(const CdlWant& want) {
    if (want.wanted.call < 0) return;
    const std::string& owner = before_.names[static_cast<std::size_t>(want.wanted.call)].text;
    CdlWorld::FoundDeclaration found = world_.find(NameKind::kAssemblage, owner);
    if (!found) found = world_.find_member(owner);
    if (!found) return;
    for (const CdlState& state : found.declaration->states) out_.add(state.name, "state");
    for (const CdlLet& let : found.declaration->lets) out_.add(let.name, "let");
    for (const CdlNode& node : found.declaration->nodes) out_.add(node.name, "node");
  }

  const CdlWorld& world_;
  const CdlScan& before_;
  const Text& text_;
  const Surroundings& around_;
  CandidateList& out_;
};

// The declaration that a place is in, as far as it stands before that place; everything keeps its offset.
CdlScan scan_before(const CdlScan& whole, std::uint32_t end) {
  std::uint32_t begin = 0;
  for (const CdlDeclaration& one : whole.declarations) {
    if (one.whole.begin < end) begin = one.whole.begin;
  }
  std::string before(begin, ' ');
  before += whole.source->text({begin, end});
  return scan_cdl(std::make_shared<const text::Source>(whole.source->name(), std::move(before)));
}

}  // namespace

Completions complete_cdl(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const std::string_view all = text.source->text();
  const CdlWorld world(text.source, around);
  const Inside in = inside(world.own(), cursor);
  if (in.is_comment) return {{cursor, cursor}, {}, false};
  if (in.text) {
    const CdlScan before = scan_before(world.own(), in.text->begin - 1);
    const std::size_t bar = all.substr(in.text->begin, cursor - in.text->begin).rfind('|');
    const auto begin =
        static_cast<std::uint32_t>(in.text->begin + (bar == std::string_view::npos ? 0 : bar + 1));
    CandidateList out(std::string(all.substr(begin, cursor - begin)));
    CdlCompleter completer(world, before, text, around, out);
    for (const CdlWant& want : before.wants) {
      if (want.kind == CdlWant::Kind::kFile) completer.files();
      if (want.kind == CdlWant::Kind::kValue || want.kind == CdlWant::Kind::kArgument)
        completer.words(world.wanted_type(want.wanted, before));
    }
    return out.take({begin, std::max(cursor, begin)});
  }
  const std::uint32_t begin = word_begin(all, cursor);
  const bool is_number =
      begin == cursor && begin > 0 && std::string_view("0123456789").contains(all[begin - 1]);
  if (is_number) return {{cursor, cursor}, {}, false};
  CandidateList out(std::string(all.substr(begin, cursor - begin)));
  const CdlScan before = scan_before(world.own(), begin);
  CdlCompleter(world, before, text, around, out).run();
  return out.take({begin, cursor});
}

std::optional<Signature> signature_cdl(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const CdlWorld world(text.source, around);
  const CdlScan before = scan_before(world.own(), cursor);
  if (before.open_calls.empty()) return std::nullopt;
  const CdlScan::OpenCall& call = before.open_calls.back();
  const Component* const called = world.component(before.names[static_cast<std::size_t>(call.callee)].text);
  if (called == nullptr) return std::nullopt;
  Signature out;
  out.help = called->help;
  out.label = called->name + "(";
  out.active = static_cast<std::size_t>(call.position);
  for (const ComponentInput& input : called->inputs) {
    if (!out.parts.empty()) out.label += ", ";
    const auto begin = static_cast<std::uint32_t>(out.label.size());
    out.label += shown_input(input);
    if (input.name == call.argument) out.active = out.parts.size();
    out.parts.push_back({{begin, static_cast<std::uint32_t>(out.label.size())}, input.help});
  }
  out.label += ")";
  if (!called->output.type.empty()) out.label += " -> " + shown_type(called->output);
  return out;
}

}  // namespace mlab::assist
