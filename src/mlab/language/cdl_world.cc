#include "mlab/language/cdl_world.h"

#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

#include "mlab/lang/cnl/load.h"
#include "mlab/lang/cnl/parser.h"
#include "mlab/language/languages.h"
#include "mlab/library/library.h"

namespace mlab::language {
namespace {

namespace fs = std::filesystem;

constexpr int kMostTypeSteps = 32;

}  // namespace

CdlWorld::CdlWorld() {
  for (const library::ConfigurationText& one : library::configuration_texts())
    scans_.push_back(
        scan_cdl(std::make_shared<const text::Source>(std::string(one.file), std::string(one.text))));
  for (const flow::Behavior* behavior : robot::component_library().behaviors())
    procedures_.push_back(language::component_of(*behavior));
  declare();
  components();  // all are made now: from here on, threads only read
}

CdlWorld::CdlWorld(const text::SourcePtr& source, const Surroundings& around)
    : around_(&around), library_(&library()) {
  seen_.push_back(canonical_path(source->name()));
  read(source);
  declare();
}

const CdlWorld& CdlWorld::library() {
  static const CdlWorld kLibrary;
  return kLibrary;
}

void CdlWorld::read(const text::SourcePtr& source) {
  follow(scans_.emplace_back(scan_cdl(source)));
}

void CdlWorld::follow(const CdlScan& scan) {
  for (const CdlName& use : scan.uses) {
    if (use.text.empty() || use.text.find('\0') != std::string::npos || seen_.size() > kMostFiles) continue;
    const std::string path = (fs::path(scan.source->name()).parent_path() / use.text).string();
    const std::string key = canonical_path(path);
    if (std::ranges::find(seen_, key) != seen_.end()) continue;
    seen_.push_back(key);
    const auto source = around_->files.read(path);
    if (!source) continue;
    const std::string ending = fs::path(use.text).extension().string();
    if (ending == ".cnl" || (ending != ".cdl" && cnl::looks_like_cnl((*source)->text()))) {
      add_procedures(*source);
    } else {
      read(*source);
    }
  }
}

void CdlWorld::add_procedures(const text::SourcePtr& source) {
  text::Diagnostics unsaid;
  const cnl::Tree tree = cnl::parse(source, unsaid);
  for (const cnl::Item& item : tree.items) {
    if (const auto* procedure = std::get_if<cnl::Procedure>(&item))
      procedures_.push_back(language::component_of(*procedure));
  }
}

void CdlWorld::declare() {
  for (const Component& one : procedures_) procedure_by_name_.try_emplace(one.name, &one);
  for (const CdlScan& scan : scans_) {
    for (const CdlDeclaration& one : scan.declarations) {
      if (!one.name.empty())
        declared_.try_emplace({one.kind, one.name}, Found{&one, &scan, library_ == nullptr});
    }
  }
}

CdlWorld::Found CdlWorld::find(NameKind kind, std::string_view name) const {
  const auto found = declared_.find(std::pair{kind, std::string(name)});
  if (found != declared_.end()) return found->second;
  return library_ == nullptr ? Found{} : library_->find(kind, name);
}

CdlWorld::Found CdlWorld::find_member(std::string_view name) const {
  const Found robot = find(NameKind::kRobot, name);
  return robot ? robot : find(NameKind::kSociety, name);
}

std::vector<CdlWorld::Found> CdlWorld::all(NameKind kind) const {
  std::vector<Found> out;
  for (const auto& [key, found] : declared_) {
    if (key.first == kind) out.push_back(found);
  }
  if (library_ == nullptr) return out;
  for (const Found& found : library_->all(kind)) {
    if (!declared_.contains({kind, found.declaration->name})) out.push_back(found);
  }
  return out;
}

Component CdlWorld::component_of(const CdlDeclaration& declaration, const CdlScan& scan) const {
  Component out;
  out.name = declaration.name;
  out.kind = name_of(declaration.kind);
  out.help = declaration.help;
  for (const CdlParameter& parameter : declaration.parameters) out.inputs.push_back(parameter.input);
  out.is_own = library_ != nullptr;
  out.file = scan.source->name();
  out.declaration = {scan.source, declaration.span};
  out.is_sink = declaration.kind == NameKind::kBinding && declaration.result_type.empty();
  if (!declaration.result_type.empty()) {
    out.output = value_type(declaration.result_type, "");
  } else if (!out.is_sink) {
    out.output = type_of(declaration.result, &declaration, depth_);
  }
  return out;
}

const Component* CdlWorld::component(std::string_view name) const {
  const auto known = components_.find(name);
  if (known != components_.end()) {
    if (known->second) return known->second.get();
    return library_ == nullptr ? nullptr : library_->component(name);
  }
  for (const NameKind kind : {NameKind::kBinding, NameKind::kAssemblage}) {
    const auto found = declared_.find(std::pair{kind, std::string(name)});
    if (found == declared_.end() || depth_ > kMostTypeSteps) continue;
    ++depth_;
    auto made = std::make_unique<Component>(component_of(*found->second.declaration, *found->second.scan));
    --depth_;
    return (components_[std::string(name)] = std::move(made)).get();
  }
  const auto procedure = procedure_by_name_.find(name);
  if (procedure != procedure_by_name_.end()) return procedure->second;
  return library_ == nullptr ? nullptr : library_->component(name);
}

std::vector<const Component*> CdlWorld::components() const {
  std::map<std::string_view, const Component*> by_name;
  if (library_ != nullptr) {
    for (const Component* one : library_->components()) by_name[one->name] = one;
  }
  for (const Component& one : procedures_) by_name[one.name] = &one;
  for (const auto& [key, found] : declared_) {
    if (key.first != NameKind::kAssemblage && key.first != NameKind::kBinding) continue;
    if (const Component* one = component(key.second)) by_name[one->name] = one;
  }
  std::vector<const Component*> out;
  out.reserve(by_name.size());
  for (const auto& [name, one] : by_name) out.push_back(one);
  return out;
}

CdlWorld::Variable CdlWorld::variable(const CdlDeclaration& in, std::string_view name) {
  for (const CdlLet& let : in.lets) {
    if (let.name == name) return {.let = &let};
  }
  for (const CdlParameter& parameter : in.parameters) {
    if (parameter.input.name == name) return {.parameter = &parameter};
  }
  return {};
}

ValueType CdlWorld::type_of(const CdlGuess& guess, const CdlDeclaration* in) const {
  return type_of(guess, in, 0);
}

ValueType CdlWorld::type_of(const Variable& variable, const CdlDeclaration& in) const {
  return variable.let != nullptr ? type_of(variable.let->guess, &in, 1) : variable.parameter->input.value;
}

ValueType CdlWorld::type_of(const CdlGuess& guess, const CdlDeclaration* in, int depth) const {
  if (depth > kMostTypeSteps) return {};
  switch (guess.kind) {
    case CdlGuess::Kind::kUnknown:
      return {};
    case CdlGuess::Kind::kType:
      return {guess.text, guess.unit};
    case CdlGuess::Kind::kCall: {
      if (depth_ > kMostTypeSteps) return {};
      const Component* const called = component(guess.text);
      return called == nullptr ? ValueType{} : called->output;
    }
    case CdlGuess::Kind::kName: {
      if (in == nullptr) return {};
      const Variable found = variable(*in, guess.text);
      if (!found) return {};
      return found.let != nullptr ? type_of(found.let->guess, in, depth + 1) : found.parameter->input.value;
    }
  }
  return {};
}

const ComponentInput* CdlWorld::input_of(const CdlWanted& wanted, const CdlScan& scan) const {
  if (wanted.call < 0) return nullptr;
  const Component* const called = component(scan.names[static_cast<std::size_t>(wanted.call)].text);
  if (called == nullptr) return nullptr;
  if (!wanted.argument.empty()) return find_input(*called, wanted.argument);
  const auto i = static_cast<std::size_t>(wanted.position);
  return i < called->inputs.size() ? &called->inputs[i] : nullptr;
}

ValueType CdlWorld::wanted_type(const CdlWanted& wanted, const CdlScan& scan) const {
  const ComponentInput* const input = input_of(wanted, scan);
  if (input == nullptr) return wanted.type;
  const bool is_vector = input->value.type == "Vector" || input->value.type == "Point";
  if (wanted.in_list && !input->is_list && is_vector) return {"double", input->value.unit};
  return input->value;
}

}  // namespace mlab::language
