#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/flow/limit.h"
#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::cdl_historic {

/// One input of something that can be called.
struct Port {
  std::string name;
  std::string type;  ///< of flow's types
  std::string unit;  ///< empty: none
  bool is_list = false;
  bool needs_value = false;      ///< has no default
  cdl::ExpressionPtr initial;    ///< of assemblages; null: none, or a procedure's
  double min = -flow::kNoLimit;  ///< of the values it takes, in `unit`
  double max = flow::kNoLimit;
};

/// What of ours can be called, and what comes out.
struct Signature {
  std::string name;
  std::vector<Port> ports;
  std::string result;  ///< of flow's types; empty: a sink
  const Port* find(std::string_view port) const;
};

/// One of ours under a historic name: which of its ports each historic parameter means.
struct HistoricSignature {
  const Signature* signature = nullptr;
  struct PortMapping {
    const Port* port = nullptr;  ///< null: means nothing here
    std::string unit;            ///< of historic constants; empty: the port's own
  };
  std::map<std::string, PortMapping, std::less<>> ports;
};

/// What imported configurations can be made of: the procedures and the component library.
class Vocabulary {
 public:
  /// @param library  files of the component library; they and `procedures` have to outlive this
  Vocabulary(const flow::Library& procedures, std::span<const std::shared_ptr<const cdl::Tree>> library);

  /// By our name. Null where there is none.
  const Signature* find(std::string_view name) const;
  /// By a historic name of a procedure or an assemblage (`MOVE_TO`).
  const HistoricSignature* find_historic(std::string_view name) const;
  /// The assemblage that says it stands for a historic name (`alias "GoTo";`).
  const Signature* find_assemblage(std::string_view historic) const;
  const cdl::RobotClass* robot_class(std::string_view name) const;
  const cdl::Binding* binding(std::string_view name) const;
  /// Every name that a configuration must not declare again.
  bool is_taken(std::string_view name) const;
  /// The flow type that a type's name means in our language or in the historic one; empty: unknown.
  std::string type(std::string_view name) const;

 private:
  void add_procedures();
  void add(const cdl::Assemblage& assemblage);
  bool narrow_all();
  bool narrowed(Signature& outer, const cdl::Call& call) const;
  std::string result_of(const cdl::Expression& body, int depth) const;

  const flow::Library& procedures_;
  std::map<std::string, Signature, std::less<>> signatures_;
  std::map<std::string, HistoricSignature, std::less<>> historic_;
  std::map<std::string, const Signature*, std::less<>> aliased_;
  std::map<std::string, const cdl::RobotClass*, std::less<>> classes_;
  std::map<std::string, const cdl::Binding*, std::less<>> bindings_;
  std::map<std::string, const cdl::Assemblage*, std::less<>> assemblages_;
};

}  // namespace mlab::cdl_historic
