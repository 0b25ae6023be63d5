#pragma once

#include <optional>
#include <string>

#include "mlab/flow/library.h"
#include "mlab/flow/network.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/findings.h"
#include "mlab/lang/cdl/lower/value.h"
#include "mlab/lang/cdl/types/types.h"

namespace mlab::cdl {

/// From values to what is linked to an input: types, units, ranges.
class Binder {
 public:
  Binder(const Configuration& configuration, const flow::Library& library, const Types& types,
         Findings& findings)
      : configuration_(configuration), library_(library), types_(types), findings_(findings) {}

  /// What is linked to an input of the type; nothing where the value is none of it, which is said at `place`.
  /// @param input  whose range the value has to be in; null: none
  /// @param name   of what takes it, for messages
  std::optional<flow::Source> bind(const Value& value, const PortType& type, const flow::Input* input,
                                   const std::string& name, const text::Place& place);
  /// A value for a parameter: checked against the declaration, and with its type.
  Value pass(const Value& value, const Parameter& parameter, const PortType& type, const text::Place& place);
  bool check_range(const Value& value, const Parameter& parameter, const PortType& type);
  /// @param about  what has the type `have`; null: it has no name that could be told
  bool fits(const PortType& have, const PortType& want, const std::string& name, const text::Place& place,
            const Value* about = nullptr);
  /// False where the unit that is declared for a wire is an angle's, which its number would have to be
  /// converted from, and nobody can: the network knows no unit of it.
  bool is_convertible(const Value& value, const PortType& want, const std::string& name,
                      const text::Place& place);
  /// A wire that its declaration gives a unit is a value in it from there on.
  static void declare_unit(Value& value, const PortType& declared);

  /// No type where it is unknown, which is said.
  PortType type_of(const Parameter& parameter);
  PortType type_named(const Word& name);

 private:
  std::optional<flow::Source> bind_number(const Value& value, const PortType& type, const flow::Input* input,
                                          const std::string& name, const text::Place& place);
  std::optional<flow::Source> bind_word(const Value& value, const PortType& type, const std::string& name,
                                        const text::Place& place);
  std::optional<flow::Source> bind_coordinates(const Value& value, const PortType& type,
                                               const std::string& name, const text::Place& place);

  const Configuration& configuration_;
  const flow::Library& library_;
  const Types& types_;
  Findings& findings_;
};

}  // namespace mlab::cdl
