#include "mlab/assist/cdl_world.h"

#include <algorithm>

#include "mlab/assist/languages.h"
#include "mlab/library/library.h"
#include "mlab/robot/program/brought_code.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::assist {
CdlWorld::CdlWorld() {
  for (const library::ConfigurationText& one : library::configuration_texts())
    scans_.push_back(
        scan_cdl(std::make_shared<const text::Source>(std::string(one.file), std::string(one.text))));
  for (const flow::Behavior* behavior : robot::component_library().behaviors())
    procedures_.push_back(assist::component_of(*behavior));
  for (const cdl::Function& function : cdl::functions())
    procedures_.push_back(assist::component_of(function, robot::component_library()));
  types_.emplace(robot::library_configuration(), robot::component_library());
  declare();
  components();  // all are made now: from here on, threads only read
}

CdlWorld::CdlWorld(const text::SourcePtr& source, const Surroundings& around) : library_(&library()) {
  const CdlScan& first = scans_.emplace_back(scan_cdl(source));
  text::Diagnostics unsaid;
  const std::shared_ptr<const cdl::Tree> own(std::shared_ptr<const void>(), &first.written.tree);
  configuration_ = cdl::configuration_of(own, {robot::library_environment().built_in, &around.files}, unsaid);
  for (std::size_t i = 1; i < std::min(configuration_.trees.size(), kMostFiles); ++i)
    scans_.push_back(scan_cdl(configuration_.trees[i]->source));
  for (const auto& file : configuration_.procedures) add_procedures(*file);
  described_ = robot::describe_library(configuration_.procedures);
  types_.emplace(configuration_, described_->library);
  declare();
}

CdlWorld::~CdlWorld() = default;

const CdlWorld& CdlWorld::library() {
  static const CdlWorld kLibrary;
  return kLibrary;
}

void CdlWorld::add_procedures(const cnl::Tree& file) {
  for (const cnl::Item& item : file.items) {
    if (const auto* procedure = std::get_if<cnl::Procedure>(&item))
      procedures_.push_back(assist::component_of(*procedure));
  }
}

void CdlWorld::declare() {
  for (const Component& one : procedures_) procedure_by_name_.try_emplace(one.name, &one);
  for (const CdlScan& scan : scans_) {
    for (const CdlDeclaration& one : scan.declarations) {
      if (!one.name.empty())
        declared_.try_emplace({one.kind, one.name}, FoundDeclaration{&one, &scan, library_ == nullptr});
    }
  }
}

CdlWorld::FoundDeclaration CdlWorld::find(NameKind kind, std::string_view name) const {
  const auto found = declared_.find(std::pair{kind, std::string(name)});
  if (found != declared_.end()) return found->second;
  return library_ == nullptr ? FoundDeclaration{} : library_->find(kind, name);
}

CdlWorld::FoundDeclaration CdlWorld::find_member(std::string_view name) const {
  const FoundDeclaration robot = find(NameKind::kRobot, name);
  return robot ? robot : find(NameKind::kSociety, name);
}

std::vector<CdlWorld::FoundDeclaration> CdlWorld::all(NameKind kind) const {
  std::vector<FoundDeclaration> out;
  for (const auto& [key, found] : declared_) {
    if (key.first == kind) out.push_back(found);
  }
  if (library_ == nullptr) return out;
  for (const FoundDeclaration& found : library_->all(kind)) {
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
  if (declaration.assemblage != nullptr) out.output = value_type(types_->result_of(*declaration.assemblage));
  if (declaration.kind == NameKind::kBinding) out.output = value_type(declaration.result_type, "");
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
    if (found == declared_.end()) continue;
    auto made = std::make_unique<Component>(component_of(*found->second.declaration, *found->second.scan));
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

cdl::Types::Names CdlWorld::names_in(const CdlDeclaration* declaration) const {
  if (declaration != nullptr && declaration->assemblage != nullptr)
    return types_->names_of(declaration->assemblage->parameters, declaration->assemblage->lets);
  if (declaration != nullptr && declaration->robot != nullptr)
    return types_->names_of(declaration->robot->parameters, declaration->robot->lets);
  return [](const std::string&, cdl::Types::Question&) { return cdl::PortType{}; };
}

ValueType CdlWorld::type_of(const cdl::Expression* expression, const CdlDeclaration* in) const {
  if (expression == nullptr) return {};
  ValueType out = value_type(types_->of(*expression, names_in(in)));
  if (const auto* number = std::get_if<cdl::Number>(&expression->what)) out.unit = number->unit.text;
  return out;
}

ValueType CdlWorld::type_of(const Variable& variable, const CdlDeclaration& in) const {
  return variable.let != nullptr ? type_of(variable.let->value, &in) : variable.parameter->input.value;
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

}  // namespace mlab::assist
