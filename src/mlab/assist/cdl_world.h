#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/assist/cdl_scan.h"
#include "mlab/assist/component.h"
#include "mlab/assist/service.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/types/types.h"
#include "mlab/lang/cnl/tree.h"

namespace mlab::robot {
struct DescribedLibrary;
}

namespace mlab::assist {

/// A configuration with all that it uses: what its names stand for, and of which type its values are.
class CdlWorld {
 public:
  CdlWorld(const text::SourcePtr& source, const Surroundings& around);
  ~CdlWorld();
  CdlWorld(const CdlWorld&) = delete;
  CdlWorld& operator=(const CdlWorld&) = delete;

  const CdlScan& own() const { return scans_.front(); }

  /// A declaration and the text that it stands in.
  struct FoundDeclaration {
    const CdlDeclaration* declaration = nullptr;
    const CdlScan* scan = nullptr;
    bool is_library = false;
    explicit operator bool() const { return declaration != nullptr; }
    text::Place place() const { return {scan->source, declaration->span}; }
  };
  FoundDeclaration find(NameKind kind, std::string_view name) const;
  /// A robot or society, as a society names it.
  FoundDeclaration find_member(std::string_view name) const;
  /// All declarations of a kind, own ones first; hidden ones left out.
  std::vector<FoundDeclaration> all(NameKind kind) const;

  /// Null where nothing of that name can be called.
  const Component* component(std::string_view name) const;
  std::vector<const Component*> components() const;

  /// The let or parameter that a name means inside of a declaration.
  struct Variable {
    const CdlLet* let = nullptr;
    const CdlParameter* parameter = nullptr;
    explicit operator bool() const { return let != nullptr || parameter != nullptr; }
    text::Span span() const { return let != nullptr ? let->span : parameter->span; }
  };
  static Variable variable(const CdlDeclaration& in, std::string_view name);

  /// What an expression gives that stands in a declaration; null: nothing that could be told stands there.
  ValueType type_of(const cdl::Expression* expression, const CdlDeclaration* in) const;
  ValueType type_of(const Variable& variable, const CdlDeclaration& in) const;
  /// The input that a value goes to; null where it is no argument of a known call.
  const ComponentInput* input_of(const CdlWanted& wanted, const CdlScan& scan) const;
  ValueType wanted_type(const CdlWanted& wanted, const CdlScan& scan) const;

  /// All names of the text, with where they are declared.
  std::vector<Name> names() const;
  Name resolve(const CdlName& name) const;

 private:
  CdlWorld();  // of the library
  static const CdlWorld& library();

  void add_procedures(const cnl::Tree& file);
  void declare();
  Component component_of(const CdlDeclaration& declaration, const CdlScan& scan) const;
  void resolve_argument(const CdlName& name, Name& out) const;
  void resolve_tested_state(const CdlName& name, Name& out) const;
  void resolve_value(const CdlName& name, Name& out) const;
  void resolve_binding(const CdlName& name, Name& out) const;
  void resolve_node(const CdlName& name, Name& out) const;
  const CdlDeclaration* around(const CdlName& name) const;
  cdl::Types::Names names_in(const CdlDeclaration* declaration) const;

  const CdlWorld* library_ = nullptr;  // null: this is the library
  std::deque<CdlScan> scans_;          // the text itself, then those that it uses
  cdl::Configuration configuration_;   // of them, holes and all; of the library none
  std::unique_ptr<robot::DescribedLibrary> described_;
  std::optional<cdl::Types> types_;
  std::map<std::pair<NameKind, std::string>, FoundDeclaration, std::less<>> declared_;
  std::deque<Component> procedures_;
  std::map<std::string_view, const Component*> procedure_by_name_;
  mutable std::map<std::string, std::unique_ptr<Component>, std::less<>> components_;
};

}  // namespace mlab::assist
