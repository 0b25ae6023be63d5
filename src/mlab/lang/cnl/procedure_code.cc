#include "mlab/lang/cnl/procedure_code.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/flow/limit.h"
#include "mlab/lang/cnl/alias_signature.h"
#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/user_code.h"

namespace mlab::cnl {
namespace {

std::string cpp_type(const Word& type) {
  const flow::ValueTypeInfo* known = find_port_type(type.text);
  return known ? std::string(known->cpp) : "::" + type.text;
}

// One thing that the sections of a procedure see: how they take it, and how `fire` makes it.
struct Argument {
  std::string name;
  std::string parameter_type;
  std::string made;  ///< a statement of `fire`
};

Argument input_argument(const InputDecl& input) {
  const std::string type = cpp_type(input.type);
  const flow::ValueTypeInfo* known = find_port_type(input.type.text);
  const std::string& name = input.name.text;
  if (input.is_list) {
    return {name, fmt::format("const mlab::flow::InputList<{}>&", type),
            fmt::format("const auto {} = mlab::flow::take_list<{}>(mlab_call, mlab_next);", name, type)};
  }
  const std::string made = fmt::format(
      "[[maybe_unused]] decltype(auto) {} = mlab::flow::take<{}>(mlab_call, mlab_next);", name, type);
  if (known && is_reading(*known)) return {name, fmt::format("const mlab::flow::ViewOf<{}>&", type), made};
  return {name, fmt::format("const {}{}", type, known && is_scalar(*known) ? "" : "&"), made};
}

Argument context_argument(std::string_view name) {
  if (name == "percepts")
    return {"percepts", "const mlab::percept::Percepts&",
            "const auto& percepts = *mlab_call.cycle->percepts;"};
  if (name == "action")
    return {"action", "mlab::percept::Action&", "auto& action = *mlab_call.cycle->action;"};
  if (name == "random")
    return {"random", "mlab::base::Random&", "mlab::base::Random random = mlab_call.random();"};
  if (name == "cycle")
    return {"cycle", "const std::uint64_t", "const std::uint64_t cycle = mlab_call.cycle->number;"};
  if (name == "time") return {"time", "const double", "const double time = mlab_call.cycle->percepts->time;"};
  return {"cycle_duration", "const double",
          "const double cycle_duration = mlab_call.cycle->percepts->cycle_duration;"};
}

std::vector<Argument> arguments_of(const Procedure& procedure) {
  std::vector<Argument> out;
  if (!procedure.is_sink()) {
    const std::string type = cpp_type(procedure.output_type);
    out.push_back(
        {"output", type + "&", fmt::format("auto& output = mlab_call.at<{}>(mlab_call.output);", type)});
  }
  for (const InputDecl& input : procedure.inputs) {
    out.push_back(input_argument(input));
    if (!input.is_list) continue;
    const std::string count = input.name.text + "_num";
    out.push_back({count, "const int",
                   fmt::format("const int {} = static_cast<int>({}.size());", count, input.name.text)});
  }
  for (const std::string_view name : used_context(procedure)) out.push_back(context_argument(name));
  return out;
}

class ProcedureCode {
 public:
  ProcedureCode(CppWriter& out, const Procedure& procedure)
      : out_(out), procedure_(procedure), arguments_(arguments_of(procedure)) {
    if (procedure.once) once_code_ = *procedure.once;
    if (procedure.header) header_code_ = *procedure.header;
    if (procedure.body) body_code_ = *procedure.body;
    const UserCode once(once_code_);
    once_ = once.variables();
    std::erase_if(once_, [](const UserCode::Variable& v) { return v.is_constant; });
    has_once_ = !once.is_blank();
    has_header_ = !UserCode(header_code_).is_blank();
  }

  void write() {
    out_.line("using namespace mlab::schema;");
    out_.line("namespace {");
    if (has_once_) write_once();
    if (has_header_) {
      write_header();
    } else {
      write_body();
    }
    if (has_once_ || has_header_) write_state();
    write_fire();
    out_.line("}  // namespace");
    write_descriptor();
  }

 private:
  // Parameters of a section: what `once` kept (except for `once` itself), then everything else.
  std::string parameters(bool with_once) const {
    std::string out;
    const auto add = [&](std::string_view type, std::string_view name) {
      out += fmt::format("{}[[maybe_unused]] {} {}", out.empty() ? "" : ", ", type, name);
    };
    if (with_once) {
      for (std::size_t i = 0; i < once_.size(); ++i)
        add(fmt::format("std::tuple_element_t<{}, mlab_Kept>", i), once_[i].name);
    }
    for (const Argument& argument : arguments_) add(argument.parameter_type, argument.name);
    return out;
  }

  std::string argument_names() const {
    std::string out;
    for (const Argument& argument : arguments_) out += (out.empty() ? "" : ", ") + argument.name;
    return out;
  }

  void section(const Code& code) {
    out_.line("{");
    out_.user_code(code);
    out_.line("}");
  }

  // State is copied byte by byte. Says so at the variable, in words of this language.
  void assert_copyable(const UserCode::Variable& variable, std::string_view section_word) {
    out_.line("static_assert(");
    out_.at(variable.place, fmt::format("is_state<decltype({})>,", variable.name));
    out_.line(fmt::format(
        "{});",
        cpp_string(fmt::format("the {} variable `{}` cannot be copied byte by byte, as state has to be",
                               section_word, variable.name))));
  }

  void write_once() {
    out_.line(fmt::format("auto mlab_once_section({}) {{", parameters(false)));
    out_.line("{");
    out_.user_code(once_code_);
    std::string names;
    for (const UserCode::Variable& variable : once_) {
      assert_copyable(variable, "once");
      names += (names.empty() ? "" : ", ") + variable.name;
    }
    out_.line(fmt::format("return [{}](auto&& mlab_use) mutable {{ return mlab_use({}); }};", names, names));
    out_.line("}");
    out_.line("}");
    out_.line("using mlab_Once = mlab::flow::Result<decltype(mlab_once_section)>;");
    out_.line("using mlab_Kept = decltype(std::declval<mlab_Once&>()(mlab::flow::tie));");
  }

  void write_header() {
    out_.line(fmt::format("auto mlab_header_section({}) {{", parameters(has_once_)));
    out_.line("{");
    out_.user_code(header_code_);
    const UserCode header(header_code_);
    const UserCode body(body_code_);
    for (const UserCode::Variable& variable : header.variables()) {
      const bool is_kept = !variable.is_constant && body.mentions(variable.name);
      if (is_kept) assert_copyable(variable, "header");
    }
    out_.line(fmt::format("return [=]({}) mutable {{", parameters(has_once_)));
    section(body_code_);
    out_.line("};");
    out_.line("}");
    out_.line("}");
    out_.line("using mlab_Body = mlab::flow::Result<decltype(mlab_header_section)>;");
    out_.line("static_assert(");
    out_.at(header_code_.place, "is_state<mlab_Body>,");
    out_.line("\"something that the header declares cannot be copied byte by byte, as state has to be\");");
  }

  void write_body() {
    out_.line(fmt::format("void mlab_body_section({}) {{", parameters(has_once_)));
    section(body_code_);
    out_.line("}");
  }

  void write_state() {
    out_.line("struct mlab_State {");
    if (has_once_) out_.line("  mlab::flow::Slot<mlab_Once> once;");
    if (has_header_) out_.line("  mlab::flow::Slot<mlab_Body> body;");
    out_.line("};");
  }

  // The names of all arguments, behind the references to what `once` kept.
  std::string call_of(std::string_view function, bool with_once) const {
    if (!with_once) return fmt::format("{}({})", function, argument_names());
    std::string names = "mlab_kept...";
    for (const Argument& argument : arguments_) names += ", " + argument.name;
    return fmt::format("mlab_state.once.get()([&](auto&... mlab_kept) {{ return {}({}); }})", function,
                       names);
  }

  void write_fire() {
    out_.line("void fire(mlab::flow::Call& mlab_call) {");
    if (!procedure_.inputs.empty())
      out_.line("  [[maybe_unused]] const std::uint32_t* mlab_next = mlab_call.inputs;");
    for (const Argument& argument : arguments_) out_.line("  " + argument.made);
    if (has_once_ || has_header_)
      out_.line("  mlab_State& mlab_state = mlab_call.at<mlab_State>(mlab_call.state);");
    if (has_once_)
      out_.line(fmt::format("  if (mlab_call.is_first()) mlab_state.once.put({});",
                            call_of("mlab_once_section", false)));
    if (has_header_) {
      out_.line(fmt::format("  if (mlab_call.is_restart()) mlab_state.body.put({});",
                            call_of("mlab_header_section", has_once_)));
      out_.line(fmt::format("  {};", call_of("mlab_state.body.get()", has_once_)));
    } else {
      out_.line(fmt::format("  {};", call_of("mlab_body_section", has_once_)));
    }
    if (arguments_.empty() && !has_once_ && !has_header_) out_.line("  static_cast<void>(mlab_call);");
    out_.line("}");
  }

  void write_descriptor() {
    out_.line("const mlab::flow::Behavior& behavior() {");
    write_inputs();
    write_aliases();
    write_needs();
    out_.line("  static const mlab::flow::Behavior kBehavior = {");
    field("name", cpp_string(procedure_.name.text));
    field("help", cpp_string(procedure_.help));
    field("source", cpp_string(procedure_.source));
    const text::Place& place = procedure_.name.place;
    field("file", cpp_string(fmt::format("{}:{}", base_name(place.source->name()),
                                         place.source->line_column(place.span.begin).line)));
    const std::string type = procedure_.is_sink() ? "" : cpp_type(procedure_.output_type);
    const bool has_state = has_once_ || has_header_;
    field("output", type.empty() ? "nullptr" : fmt::format("&mlab::flow::type_info<{}>()", type));
    field("output_unit", cpp_string(procedure_.output_unit.text));
    field("inputs", procedure_.inputs.empty() ? "{}" : "kInputs");
    field("aliases", procedure_.aliases.empty() ? "{}" : "kAliases");
    field("needs", procedure_.needs.empty() ? "{}" : "kNeeds");
    field("is_pure", procedure_.is_pure ? "true" : "false");
    field("latency_cycles", fmt::format("{}", procedure_.latency.value_or(0)));
    field("state_size", has_state ? "sizeof(mlab_State)" : "0");
    field("state_alignment", has_state ? "alignof(mlab_State)" : "1");
    field("has_header", has_header_ ? "true" : "false");
    field("fire", "fire");
    field("write_initial_output",
          type.empty() ? "nullptr" : fmt::format("mlab::flow::write_initial<{}>", type));
    out_.line("  };");
    out_.line("  return kBehavior;");
    out_.line("}");
  }

  void field(std::string_view name, std::string_view value) {
    out_.line(fmt::format("      .{} = {},", name, value));
  }

  void write_inputs() {
    if (procedure_.inputs.empty()) return;
    out_.line("  static const mlab::flow::Input kInputs[] = {");
    for (const InputDecl& input : procedure_.inputs) {
      std::string text = fmt::format(
          "      {{.name = {}, .type = &mlab::flow::type_info<{}>(), .unit = {}, .help = {}, .is_list = {}",
          cpp_string(input.name.text), cpp_type(input.type), cpp_string(input.unit.text),
          cpp_string(input.help), input.is_list);
      text += fmt::format(", .default_text = {}", cpp_string(input.initial ? input.initial->text : ""));
      text += fmt::format(", .min = {:.17g}, .max = {:.17g}", input.low.value_or(-flow::kNoLimit),
                          input.high.value_or(flow::kNoLimit));
      out_.line(text + "},");
    }
    out_.line("  };");
  }

  void write_aliases() {
    if (procedure_.aliases.empty()) return;
    std::vector<std::string> rows;
    for (std::size_t i = 0; i < procedure_.aliases.size(); ++i) {
      const AliasDecl& alias = procedure_.aliases[i];
      const AliasSignature as = signature_of(procedure_, alias);
      std::string ports;
      std::string ignored;
      for (const auto& [name, unit] : as.inputs)
        ports += fmt::format("{{{}, {}}}, ", cpp_string(name), cpp_string(unit));
      for (const std::string& name : as.ignored) ignored += cpp_string(name) + ", ";
      if (!ports.empty())
        out_.line(fmt::format("  static constexpr mlab::flow::Alias::Port kPorts{}[] = {{{}}};", i, ports));
      if (!ignored.empty())
        out_.line(fmt::format("  static constexpr std::string_view kIgnored{}[] = {{{}}};", i, ignored));
      rows.push_back(fmt::format("      {{{}, {}, {}, {}}},", cpp_string(alias.name.text),
                                 ports.empty() ? "{}" : fmt::format("kPorts{}", i),
                                 ignored.empty() ? "{}" : fmt::format("kIgnored{}", i),
                                 cpp_string(as.output_unit)));
    }
    out_.line("  static const mlab::flow::Alias kAliases[] = {");
    for (const std::string& row : rows) out_.line(row);
    out_.line("  };");
  }

  void write_needs() {
    if (procedure_.needs.empty()) return;
    out_.line("  static constexpr mlab::flow::Need kNeeds[] = {");
    for (const NeedDecl& need : procedure_.needs) {
      std::string sensor = need.sensor.text;
      sensor[0] = static_cast<char>(sensor[0] - 'a' + 'A');
      const auto input = std::ranges::find_if(
          procedure_.inputs, [&](const InputDecl& i) { return i.name.text == need.range.text; });
      const bool by_input = input != procedure_.inputs.end();
      out_.line(fmt::format("      {{mlab::percept::Sensor::k{}, {}, {}}},", sensor,
                            by_input ? std::distance(procedure_.inputs.begin(), input) : -1,
                            by_input || need.range.text.empty() ? "0.0" : need.range.text));
    }
    out_.line("  };");
  }

  CppWriter& out_;
  const Procedure& procedure_;
  std::vector<Argument> arguments_;
  std::vector<UserCode::Variable> once_;
  Code once_code_;
  Code header_code_;
  Code body_code_;
  bool has_once_ = false;
  bool has_header_ = false;
};

}  // namespace

void write_procedure(CppWriter& out, const Procedure& procedure) {
  ProcedureCode(out, procedure).write();
}

}  // namespace mlab::cnl
