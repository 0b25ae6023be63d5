#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// A configuration as G sees it: what perceives, what moves, and what coordinates them. Assemblages, names
/// and constants are gone; a node with several readers is one part.
struct Part {
  enum class Kind { kProcess, kCooperation, kCompetition, kSequencing, kCoordination, kFusion };
  Kind kind = Kind::kProcess;
  bool moves = false;  ///< gives a movement; else a percept
  std::string name;    ///< of the instance, where it has one
  std::string what;    ///< for the legend
  std::string owner;
  std::vector<const Part*> members;  ///< inputs of a process
  const Part* active = nullptr;      ///< what moves the sensor
  const Part* origin = nullptr;      ///< the same part without `active`; null: it is none
};

/// Makes the parts of a configuration's robots.
class Parts {
 public:
  Parts(const Configuration& configuration, const flow::Library& library, text::Diagnostics& sink)
      : configuration_(configuration), library_(library), sink_(sink) {}

  /// What drives the actuators of the robot, one part each; actuators without one are left out.
  std::vector<const Part*> robot(const Robot& robot);

 private:
  using Values = std::vector<const Part*>;  // a list has several, a constant none

  struct Scope {
    struct Entry {
      const Let* let = nullptr;
      Values values;
      bool is_ready = false;
    };
    std::map<std::string, Entry, std::less<>> names;
    std::string owner;
  };

  Values values(const Expression& expression, Scope& scope);
  Values values_of(const Expression& expression, Scope& scope);
  Values call(const Call& call, Scope& scope, const text::Place& place);
  Values assemblage(const Assemblage& assemblage, const Call& call, Scope& scope, const text::Place& place);
  Values process(std::string_view name, bool moves, const Call& call, Scope& scope);
  Values named(std::string_view name, Scope& scope);
  Values fused(std::string what, const std::vector<ExpressionPtr>& operands, Scope& scope);
  Values logic(const Logic& logic, Scope& scope);
  Values sequence(const Sequence& sequence, Scope& scope, const std::string& name);
  Values select(const Select& select, Scope& scope);
  Values group(Part::Kind kind, bool moves, std::string what, const std::vector<Member>& members,
               Scope& scope);
  Values given(const Call& call, Scope& scope);
  void add(const ExpressionPtr& expression, Scope& scope, Values& into);
  Part& make(Part::Kind kind, bool moves, std::string what, const Scope& scope);
  bool gives_movement(std::string_view callee) const;

  const Configuration& configuration_;
  const flow::Library& library_;
  text::Diagnostics& sink_;
  std::deque<Part> parts_;
  std::deque<Scope> scopes_;
  std::vector<const Assemblage*> open_;
  int depth_ = 0;
  bool failed_ = false;
};

}  // namespace mlab::cdl
