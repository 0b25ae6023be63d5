#include "mlab/lang/cnl/check.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/cnl/lexer.h"
#include "mlab/lang/cnl/types.h"
#include "mlab/lang/cnl/user_code.h"
#include "mlab/percept/sensors.h"

namespace mlab::cnl {
namespace {

/// The sections of a procedure, cut into words once.
struct Sections {
  std::optional<UserCode> once;
  std::optional<UserCode> header;
  std::optional<UserCode> body;

  explicit Sections(const Procedure& procedure) {
    if (procedure.once) once.emplace(*procedure.once);
    if (procedure.header) header.emplace(*procedure.header);
    if (procedure.body) body.emplace(*procedure.body);
  }
  template <class Visit>
  void visit(const Visit& visit) const {
    for (const auto* section : {&once, &header, &body}) {
      if (*section) visit(**section);
    }
  }
};

const InputDecl* find_input(const Procedure& procedure, std::string_view name) {
  const auto found =
      std::ranges::find_if(procedure.inputs, [&](const InputDecl& input) { return input.name.text == name; });
  return found == procedure.inputs.end() ? nullptr : &*found;
}

std::vector<std::string> input_names(const Procedure& procedure) {
  std::vector<std::string> out;
  for (const InputDecl& input : procedure.inputs) out.push_back(input.name.text);
  return out;
}

void add_nearest(text::Diagnostic& diagnostic, std::string_view name, const std::vector<std::string>& known) {
  const std::string nearest = text::nearest_name(name, known);
  if (!nearest.empty()) diagnostic.hints.push_back(fmt::format("did you mean `{}`?", nearest));
}

class Checker {
 public:
  Checker(const Tree& tree, text::Diagnostics& diagnostics) : tree_(tree), diagnostics_(diagnostics) {}

  void run() {
    const bool has_init = !items_of<Init>(tree_).empty();
    for (const TypeDecl* type : items_of<TypeDecl>(tree_)) check_type_decl(*type, has_init);
    check_modules();
    for (const Procedure* procedure : items_of<Procedure>(tree_)) check_procedure(*procedure);
  }

 private:
  void check_type_decl(const TypeDecl& type, bool has_init) {
    const auto [at, is_new] = own_types_.emplace(type.name.text, type.name.place);
    if (!is_new) {
      duplicate("duplicate-type", "type", type.name, at->second);
    } else if (!find_port_type(type.name.text) && !has_init) {
      diagnostics_
          .error("undefined-type", type.name.place,
                 fmt::format("nothing defines the type `{}`", type.name.text))
          .hints.emplace_back("write its `struct` into `init ... iend`, or include a header there");
    }
  }

  void check_modules() {
    std::map<std::string, text::Place, std::less<>> peers;
    const ModuleDecl* own = nullptr;
    for (const ModuleDecl* module : items_of<ModuleDecl>(tree_)) {
      if (module->is_own) {
        if (own) duplicate("duplicate-module", "modulename", module->name, own->name.place);
        own = module;
      } else if (const auto [at, is_new] = peers.emplace(module->name.text, module->name.place); !is_new) {
        duplicate("duplicate-module", "module", module->name, at->second);
      }
    }
  }

  void duplicate(std::string kind, std::string_view what, const Word& name, const text::Place& first) {
    diagnostics_.error(std::move(kind), name.place, fmt::format("a second {} `{}`", what, name.text))
        .notes.push_back({"the first is here", first});
  }

  void check_type(const Word& type) {
    if (find_port_type(type.text) || own_types_.contains(type.text)) return;
    auto& diagnostic =
        diagnostics_.error("unknown-type", type.place, fmt::format("unknown type `{}`", type.text));
    if (is_lost_historic_type(type.text)) {
      diagnostic.hints.emplace_back(
          "this historic type has no counterpart; declare your own with `type` and `init`");
      return;
    }
    std::vector<std::string> known = port_type_names();
    for (const auto& [name, place] : own_types_) known.push_back(name);
    add_nearest(diagnostic, type.text, known);
  }

  void check_procedure(const Procedure& procedure) {
    auto& seen = procedure.is_external ? externals_ : procedures_;
    const auto [at, is_new] = seen.emplace(procedure.name.text, &procedure);
    if (!is_new) duplicate("duplicate-procedure", "procedure", procedure.name, at->second->name.place);
    if (!procedure.is_sink()) check_type(procedure.output_type);
    check_inputs(procedure);
    if (procedure.is_external) return;
    if (const auto external = externals_.find(procedure.name.text); external != externals_.end()) {
      check_same_inputs(procedure, *external->second);
    }
    if (procedure.is_new_style) {
      diagnostics_
          .error("new-style-procedure", procedure.name.place,
                 fmt::format("`{}` is an `nprocedure`, which chooses by itself what it needs",
                             procedure.name.text))
          .hints.emplace_back(
              "write a `sequence` or a `select`: they evaluate only what the active part needs");
      return;
    }
    check_aliases(procedure);
    check_needs(procedure);
    check_code(procedure);
  }

  void check_inputs(const Procedure& procedure) {
    std::map<std::string, text::Place, std::less<>> names;
    for (const InputDecl& input : procedure.inputs) {
      if (input.type.text == "void") {
        diagnostics_.error("unknown-type", input.type.place, "an input can't be `void`");
      } else {
        check_type(input.type);
      }
      const auto [at, is_new] = names.emplace(input.name.text, input.name.place);
      if (!is_new) duplicate("duplicate-input", "input", input.name, at->second);
      if (input.is_list) names.emplace(input.name.text + "_num", input.name.place);
      check_input_name(input);
      if (input.low && input.high && *input.low > *input.high) {
        diagnostics_.error("empty-range", input.range_place, "no value is in this range");
      }
      if (input.initial && input.is_list) {
        diagnostics_.error("list-default", input.initial->place,
                           "a list has no default: without links it is empty");
      }
    }
  }

  void check_input_name(const InputDecl& input) {
    const std::string& name = input.name.text;
    const bool is_type = find_port_type(name) != nullptr || own_types_.contains(name);
    if (name == "output") {
      diagnostics_.error("reserved-name", input.name.place,
                         "`output` is the value that the procedure gives, not an input");
    } else if (name.find('-') != std::string::npos || is_cpp_keyword(name) || is_type) {
      diagnostics_
          .error("reserved-name", input.name.place,
                 fmt::format("C++ code cannot use `{}` as the name of an input", name))
          .label = is_type ? "this is the name of a type" : "";
    }
  }

  // The historic compiler lost inputs when the order differed; here inputs go by name, so only their set
  // counts.
  void check_same_inputs(const Procedure& procedure, const Procedure& external) {
    const auto signature = [](const Procedure& p) {
      std::set<std::pair<std::string, std::string>> out;
      for (const InputDecl& input : p.inputs) out.emplace(input.name.text, input.type.text);
      return out;
    };
    if (signature(procedure) == signature(external) &&
        procedure.output_type.text == external.output_type.text)
      return;
    diagnostics_
        .error("different-signature", procedure.name.place,
               fmt::format("`{}` differs from its `external` declaration", procedure.name.text))
        .notes.push_back({"declared here", external.name.place});
  }

  void check_aliases(const Procedure& procedure) {
    for (const AliasDecl& alias : procedure.aliases) {
      std::map<std::string, text::Place, std::less<>> names;
      for (const AliasPort& port : alias.ports) {
        const auto [at, is_new] = names.emplace(port.name.text, port.name.place);
        if (!is_new) duplicate("duplicate-input", "input", port.name, at->second);
        if (port.input.text == "none" || find_input(procedure, port.input.text)) continue;
        auto& diagnostic =
            diagnostics_.error("unknown-input", port.input.place,
                               fmt::format("`{}` has no input `{}`", procedure.name.text, port.input.text));
        add_nearest(diagnostic, port.input.text, input_names(procedure));
      }
    }
  }

  void check_needs(const Procedure& procedure) {
    for (const NeedDecl& need : procedure.needs) {
      if (percept::sensor_named(need.sensor.text) == nullptr) {
        std::vector<std::string> known;
        for (const percept::SensorInfo& sensor : percept::kSensors) known.emplace_back(sensor.name);
        auto& diagnostic = diagnostics_.error("unknown-device", need.sensor.place,
                                              fmt::format("unknown sensor `{}`", need.sensor.text));
        add_nearest(diagnostic, need.sensor.text, known);
      }
      if (need.range.text.empty() || !is_name(need.range.text)) continue;
      const InputDecl* input = find_input(procedure, need.range.text);
      if (!input) {
        auto& diagnostic =
            diagnostics_.error("unknown-input", need.range.place,
                               fmt::format("`{}` has no input `{}`", procedure.name.text, need.range.text));
        add_nearest(diagnostic, need.range.text, input_names(procedure));
      } else if (const flow::ValueTypeInfo* type = find_port_type(input->type.text);
                 !type || type->name != "double" || input->is_list) {
        diagnostics_.error(
            "unknown-input", need.range.place,
            fmt::format("the range of a sensor is a `double`, and `{}` is none", need.range.text));
      }
    }
  }

  void check_code(const Procedure& procedure) {
    const Sections sections(procedure);
    sections.visit([&](const UserCode& code) { code.check(diagnostics_); });
    if (sections.once) check_state(procedure, *sections.once, "once");
    if (sections.header) check_state(procedure, *sections.header, "header");
    if (sections.once) check_returns(*sections.once);
    if (sections.header) check_returns(*sections.header);
    if (procedure.is_pure) check_pure(procedure, sections);
  }

  // A header goes over into the body; it has no caller to return to. (Lambdas in it return values.)
  void check_returns(const UserCode& code) {
    const auto& tokens = code.tokens();
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
      if (tokens[i].text != "return" || tokens[i + 1].text != ";") continue;
      diagnostics_
          .error("return-in-header", code.place(tokens[i]),
                 "`return;` stands in `body`, not in `once` or `header`")
          .hints.emplace_back("`body` runs behind them in any case; put what depends into an `if`");
    }
  }

  // What `once` and `header` declare is kept in the frame, which is copied byte by byte.
  void check_state(const Procedure& procedure, const UserCode& code, std::string_view section) {
    std::map<std::string, text::Place, std::less<>> names;
    for (const UserCode::Variable& variable : code.variables()) {
      const auto [at, is_new] = names.emplace(variable.name, variable.place);
      if (!is_new) duplicate("duplicate-variable", "variable", {variable.name, variable.place}, at->second);
      if (variable.is_pointer && !variable.is_constant) {
        diagnostics_
            .error("pointer-state", variable.place,
                   fmt::format("the {} variable `{}` points at something", section, variable.name))
            .hints.emplace_back("state is copied byte by byte: keep values, or indices into an array");
      } else if (variable.holds_references) {
        diagnostics_
            .error("pointer-state", variable.place,
                   fmt::format("the lambda `{}` captures by reference", variable.name))
            .hints.emplace_back("capture by value, with `[=]`: it outlives what it refers to");
      }
      check_hidden(procedure, variable);
    }
    if (section != "once") return;
    for (const UserCode::LocalType& type : code.local_types()) {
      diagnostics_
          .error(
              "type-in-once", type.place,
              fmt::format("`{}` in `once` declares something that `header` and `body` do not see", type.word))
          .hints.emplace_back("types belong into `init ... iend`");
    }
  }

  void check_hidden(const Procedure& procedure, const UserCode::Variable& variable) {
    if (const InputDecl* input = find_input(procedure, variable.name)) {
      diagnostics_
          .error("hidden-name", variable.place,
                 fmt::format("`{}` is an input of this procedure", variable.name))
          .notes.push_back({"declared here", input->name.place});
      return;
    }
    const bool is_context = std::ranges::find(kContextNames, variable.name) != std::end(kContextNames);
    const bool is_list_size =
        variable.name.ends_with("_num") &&
        find_input(procedure, variable.name.substr(0, variable.name.size() - 4)) != nullptr;
    if (is_context || is_list_size || variable.name == "output") {
      diagnostics_.error("hidden-name", variable.place,
                         fmt::format("`{}` has a meaning of its own in every procedure", variable.name));
    }
  }

  void check_pure(const Procedure& procedure, const Sections& sections) {
    const auto impure = [&](const text::Place& place, std::string message) {
      diagnostics_.error("not-pure", place, std::move(message))
          .notes.push_back(
              {fmt::format("`{}` says that it is pure: no state, no randomness, neither percepts nor time",
                           procedure.name.text),
               procedure.pure.place});
    };
    if (procedure.once) impure(procedure.name.place, "a pure procedure has no `once`");
    if (procedure.latency) impure(procedure.name.place, "a pure procedure has no latency");
    if (!procedure.needs.empty()) impure(procedure.needs[0].sensor.place, "a pure procedure reads no sensor");
    if (sections.header) {
      for (const UserCode::Variable& variable : sections.header->variables()) {
        if (!variable.is_constant) impure(variable.place, fmt::format("`{}` is state", variable.name));
      }
    }
    sections.visit([&](const UserCode& code) { check_pure_code(procedure, code, impure); });
  }

  template <class Report>
  void check_pure_code(const Procedure& procedure, const UserCode& code, const Report& impure) {
    const auto& tokens = code.tokens();
    for (const std::string_view name : kContextNames) {
      if (find_input(procedure, name)) continue;
      for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].kind != CppToken::Kind::kWord || tokens[i].text != name) continue;
        const std::string_view before = i > 0 ? tokens[i - 1].text : std::string_view();
        if (before == "." || before == "->" || before == "::") continue;
        // `double time = ...` declares a variable of its own: from there on the name is that variable's.
        const bool declares = i > 0 && before != "return" &&
                              (tokens[i - 1].kind == CppToken::Kind::kWord || before == "&" || before == ">");
        if (!declares) impure(code.place(tokens[i]), fmt::format("a pure procedure does not use `{}`", name));
        break;
      }
    }
  }

  const Tree& tree_;
  text::Diagnostics& diagnostics_;
  std::map<std::string, text::Place, std::less<>> own_types_;
  std::map<std::string, const Procedure*, std::less<>> procedures_;
  std::map<std::string, const Procedure*, std::less<>> externals_;
};

}  // namespace

void check_declarations(const Tree& tree, text::Diagnostics& diagnostics) {
  Checker(tree, diagnostics).run();
}

std::vector<std::string_view> used_context(const Procedure& procedure) {
  std::vector<std::string_view> out;
  if (procedure.is_pure) return out;
  const Sections sections(procedure);
  for (const std::string_view name : kContextNames) {
    bool is_used = false;
    sections.visit([&](const UserCode& code) { is_used = is_used || code.mentions(name); });
    if (is_used && !find_input(procedure, name)) out.push_back(name);
  }
  return out;
}

}  // namespace mlab::cnl
