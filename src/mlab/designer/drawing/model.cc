#include "mlab/designer/drawing/model.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "mlab/lang/cdl/formula/formula.h"
#include "mlab/lang/cdl/lower/lower.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::designer {
namespace {

template <class Kind>
const Kind* declared(const cdl::Tree& tree, std::string_view name) {
  for (const cdl::Item& item : tree.items) {
    const auto* one = std::get_if<Kind>(&item);
    if (one != nullptr && one->name.text == name) return one;
  }
  return nullptr;
}

}  // namespace

std::string_view owner_of(std::string_view page) {
  return page.substr(0, page.find_first_of("./"));
}

std::optional<TriggerPath> trigger_path(std::string_view path) {
  const std::size_t last = path.rfind('/');
  const std::size_t first = path.find('/');
  if (last == std::string_view::npos || first == last) return std::nullopt;
  TriggerPath out{path.substr(0, first), path.substr(first + 1, last - first - 1), 0};
  const char* const end = path.data() + path.size();
  const auto [read, error] = std::from_chars(path.data() + last + 1, end, out.index);
  if (error != std::errc{} || read != end) return std::nullopt;
  return out;
}

Model::Model(text::SourcePtr source, const cdl::Environment& environment)
    : source_(std::move(source)),
      configuration_(cdl::load(source_, environment, problems_)),
      library_(robot::component_library()),
      components_(configuration_, library_) {
  is_loaded_ = !problems_.has_errors();
  is_readable_ = std::ranges::none_of(problems_.items(), [&](const text::Diagnostic& d) {
    const bool is_slip = d.kind == "syntax" || d.kind.starts_with("unclosed") ||
                         d.kind == "nested-too-deep" || d.kind == "number-out-of-range" ||
                         d.kind == "unknown-operator";
    return is_slip && d.severity == text::Severity::kError && d.place.source == source_;
  });
  is_readable_ = is_readable_ && !cdl::looks_like_formula(text());
  if (!is_loaded_) return;
  for (const auto& tree : configuration_.procedures) {
    const cnl::Signatures& own =
        signatures_.emplace_back(*tree, [this](std::string_view name) { return library_.find_type(name); });
    library_.add(own.behaviors());
  }
}

void Model::check() {
  if (std::exchange(is_loaded_, false)) cdl::check(configuration_, library_, problems_);
}

const cdl::Assemblage* Model::assemblage(std::string_view name) const {
  return declared<cdl::Assemblage>(tree(), name);
}
const cdl::Robot* Model::robot(std::string_view name) const {
  return declared<cdl::Robot>(tree(), name);
}
const cdl::Society* Model::society(std::string_view name) const {
  return declared<cdl::Society>(tree(), name);
}
const cdl::RobotClass* Model::robot_class(std::string_view name) const {
  return declared<cdl::RobotClass>(tree(), name);
}
const cdl::SocietyOperator* Model::society_operator(std::string_view name) const {
  return declared<cdl::SocietyOperator>(tree(), name);
}
const cdl::Binding* Model::binding(std::string_view name) const {
  return declared<cdl::Binding>(tree(), name);
}

const cdl::Layout* Model::layout(std::string_view page) const {
  for (const cdl::Item& item : tree().items) {
    const auto* layout = std::get_if<cdl::Layout>(&item);
    if (layout != nullptr && layout->owner.text == page) return layout;
  }
  return nullptr;
}

const OwnerGraph* Model::graph(std::string_view owner) const {
  if (const auto found = graphs_.find(owner); found != graphs_.end()) return found->second.get();
  std::multimap<std::string, std::string> shown;
  for (const cdl::Item& item : tree().items) {
    const auto* layout = std::get_if<cdl::Layout>(&item);
    if (layout == nullptr || owner_of(layout->owner.text) != owner || layout->owner.text == owner) continue;
    for (const cdl::LayoutEntry& entry : layout->entries) shown.emplace(layout->owner.text, entry.node.text);
  }
  std::unique_ptr<OwnerGraph> made;
  if (const cdl::Assemblage* one = assemblage(owner)) {
    made = std::make_unique<OwnerGraph>(cdl::model_of(*one, components_.elaboration(), shown));
  } else if (const cdl::Robot* other = robot(owner)) {
    made = std::make_unique<OwnerGraph>(cdl::model_of(*other, components_.elaboration(), shown));
  }
  return graphs_.emplace(owner, std::move(made)).first->second.get();
}

const OwnerGraph* Model::trigger(std::string_view path) const {
  if (const auto found = triggers_.find(path); found != triggers_.end()) return found->second.get();
  const std::optional<TriggerPath> parts = trigger_path(path);
  const FoundPage states = parts ? page(parts->page) : FoundPage{};
  if (states.graph == nullptr) return nullptr;
  const GraphPage& page = states.graph->pages[static_cast<std::size_t>(states.page)];
  if (page.sequence == nullptr) return nullptr;
  for (const cdl::State& state : page.sequence->states) {
    if (state.name.text != parts->state || parts->index >= state.transitions.size()) continue;
    auto made = std::make_unique<OwnerGraph>(
        cdl::trigger_model(*states.graph, page, state.transitions[parts->index], std::string(path)));
    return triggers_.emplace(path, std::move(made)).first->second.get();
  }
  return nullptr;
}

Model::FoundPage Model::page(std::string_view path) const {
  if (path.find('/') != std::string_view::npos) {
    const OwnerGraph* asked = trigger(path);
    return asked == nullptr ? FoundPage{} : FoundPage{asked, static_cast<int>(asked->pages.size()) - 1};
  }
  const OwnerGraph* graph = this->graph(owner_of(path));
  if (graph == nullptr) return {};
  const int page = graph->find_page(path);
  return page < 0 ? FoundPage{} : FoundPage{graph, page};
}

}  // namespace mlab::designer
