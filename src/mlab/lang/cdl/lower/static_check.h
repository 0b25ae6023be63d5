#pragma once

#include "mlab/flow/library.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/trigger_logic.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// What can be told without flattening: names declared twice or never used, states that can't be reached or
/// left, transitions that are never made. Warnings are kept back where the declaration has errors, since
/// those may be their cause.
class StaticCheck {
 public:
  StaticCheck(const Configuration& configuration, const flow::Library& library, text::Diagnostics& sink)
      : configuration_(configuration), logic_(configuration, library), sink_(sink) {}

  /// @errors  `duplicate-name`, `duplicate-state`, `two-start-states`, `no-start-state`, `unknown-state`
  void errors_of(const Assemblage& assemblage);
  void errors_of(const Robot& robot);
  void errors_of(const RobotClass& robot_class);
  /// @errors  also `recursive-society`, `nested-too-deep`
  void errors_of(const Society& society);
  /// Warnings: `unused-parameter`, `unused-let`, `unreachable-state`, `no-way-out`, `same-trigger`,
  /// `hidden-transition`, `constant-trigger`.
  void warnings_of(const Assemblage& assemblage);
  void warnings_of(const Robot& robot);

 private:
  void check_names(const std::vector<Parameter>& parameters, const std::vector<Let>& lets);
  void warn_unused(const std::vector<Parameter>& parameters, const std::vector<Let>& lets,
                   const std::set<std::string>& used);
  void sequence_errors(const Expression& expression);
  void sequence_errors(const Sequence& sequence, const text::Place& place);
  void sequence_warnings(const Expression& expression);
  void sequence_warnings(const Sequence& sequence);
  void transition_warnings(const State& state);
  void check_member(const SocietyMember& member);
  void check_circle(const Society& society);

  const Configuration& configuration_;
  TriggerLogic logic_;
  text::Diagnostics& sink_;
  const std::vector<Parameter>* parameters_ = nullptr;  // whose names may be meant
  const std::vector<Let>* lets_ = nullptr;
  std::set<const Society*> without_circle_;  // or told of
};

}  // namespace mlab::cdl
