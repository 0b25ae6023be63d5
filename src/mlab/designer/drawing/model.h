#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/designer/drawing/components.h"
#include "mlab/designer/drawing/graph.h"
#include "mlab/flow/library.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cnl/signatures.h"
#include "mlab/text/diagnostic.h"

namespace mlab::designer {

/// One text of CDL and what it means. Does not change; a new text is a new model.
class Model {
 public:
  /// Reads the text and the files that it uses. Whatever is wrong is in `problems`; what could be read is
  /// there all the same.
  Model(text::SourcePtr source, const cdl::Environment& environment);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const text::SourcePtr& source() const { return source_; }
  std::string_view text() const { return source_->text(); }
  const cdl::Tree& tree() const { return *configuration_.trees.front(); }
  const cdl::Configuration& configuration() const { return configuration_; }
  const flow::Library& library() const { return library_; }
  const Components& components() const { return components_; }
  /// The text itself has no slip of grammar: it can be drawn and edited.
  bool is_readable() const { return is_readable_; }

  /// Everything that reading said; with `check`, also what is wrong with what it means.
  const text::Diagnostics& problems() const { return problems_; }
  /// Adds what the checker says. No native code is compiled.
  void check();

  /// Declarations of the text itself; null where there is none.
  const cdl::Assemblage* assemblage(std::string_view name) const;
  const cdl::Robot* robot(std::string_view name) const;
  const cdl::Society* society(std::string_view name) const;
  const cdl::RobotClass* robot_class(std::string_view name) const;
  const cdl::SocietyOperator* society_operator(std::string_view name) const;
  const cdl::Binding* binding(std::string_view name) const;

  /// The levels of an assemblage or robot of the text; null where there is none.
  const OwnerGraph* graph(std::string_view owner) const;
  /// The graph that a page belongs to and which of its pages it is; null where there is none.
  struct FoundPage {
    const OwnerGraph* graph = nullptr;
    int page = -1;
  };
  /// @param path  also of a trigger: `Forage/Searching/0`, the first that the state asks
  FoundPage page(std::string_view path) const;
  /// Where things stand on a page; null: nothing is said.
  const cdl::Layout* layout(std::string_view page) const;

 private:
  text::SourcePtr source_;
  text::Diagnostics problems_;
  cdl::Configuration configuration_;
  std::deque<cnl::Signatures> signatures_;
  flow::Library library_;
  Components components_;
  bool is_readable_ = true;
  bool is_loaded_ = true;
  const OwnerGraph* trigger(std::string_view path) const;

  mutable std::map<std::string, std::unique_ptr<OwnerGraph>, std::less<>> graphs_;
  mutable std::map<std::string, std::unique_ptr<OwnerGraph>, std::less<>> triggers_;
};

/// The first part of a page's path: `Forage` of `Forage.Searching`, `Forage/Searching/0`.
std::string_view owner_of(std::string_view page);

/// The path of a trigger's page in its parts; nothing where it is the path of no trigger.
struct TriggerPath {
  std::string_view page;  ///< of the states
  std::string_view state;
  std::size_t index = 0;  ///< among the transitions of the state
};
std::optional<TriggerPath> trigger_path(std::string_view path);

}  // namespace mlab::designer
