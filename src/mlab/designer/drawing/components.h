#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/elaboration.h"
#include "mlab/lang/cdl/types/port_type.h"
#include "mlab/lang/cdl/types/types.h"

namespace mlab::designer {

/// One input of a component, as its author declared it.
struct Socket {
  std::string name;
  cdl::PortType type;
  std::string help;
  std::string initial;  ///< default as a person writes it; empty: none
  std::optional<double> min;
  std::optional<double> max;
  bool is_list = false;
  bool is_required = false;
};

/// What can be called: an assemblage, a binding point, a procedure, or a function of numbers.
struct Callable {
  enum class Kind { kProcedure, kAssemblage, kBinding, kFunction };
  Kind kind = Kind::kProcedure;
  std::string name;
  std::string help;
  std::string historic_names;  ///< for searching
  cdl::PortType output;        ///< no type: a sink
  bool gives_nothing = false;  ///< it is a sink
  std::vector<Socket> inputs;
  const cdl::Assemblage* assemblage = nullptr;
  const cdl::Binding* binding = nullptr;
  const flow::Behavior* behavior = nullptr;
};

/// Types and signatures of everything that one configuration may name. Answers from descriptors and
/// declarations; nothing is lowered. Both must outlive it. For one thread.
class Components {
 public:
  Components(const cdl::Configuration& configuration, const flow::Library& library)
      : configuration_(configuration), library_(library), elaboration_(configuration, library) {}

  const cdl::Configuration& configuration() const { return configuration_; }
  const flow::Library& library() const { return library_; }

  /// Nothing where nobody answers to the name.
  const std::optional<Callable>& find(std::string_view name) const;
  Callable of(const cdl::Assemblage& assemblage) const;
  Callable of(const cdl::Binding& binding) const;
  Callable of(const flow::Library::Entry& entry) const;
  Callable of(const cdl::Function& function) const;

  const cdl::Elaboration& elaboration() const { return elaboration_; }
  const cdl::Types& types() const { return elaboration_.types(); }
  Socket socket(const cdl::Parameter& parameter) const;

 private:
  std::optional<Callable> made(std::string_view name) const;

  const cdl::Configuration& configuration_;
  const flow::Library& library_;
  cdl::Elaboration elaboration_;
  mutable std::map<std::string, std::optional<Callable>, std::less<>> found_;  // asked for already
};

/// Why a value of the one type can't be given to an input of the other (cdl::misfit), as a sentence; empty:
/// it can.
std::string why_not(const cdl::PortType& have, const cdl::PortType& want);

/// The words that a type's constants are chosen from; empty where there are too many.
std::vector<std::string> choices_of(const cdl::PortType& type);

}  // namespace mlab::designer
