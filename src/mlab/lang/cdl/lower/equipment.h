#pragma once

#include <set>
#include <string>
#include <vector>

#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/elaboration.h"
#include "mlab/lang/cdl/lower/findings.h"
#include "mlab/lang/cdl/lower/value.h"

namespace mlab::cdl {

/// The devices that one robot has, of its class and of operators of its societies, and who of them serves
/// what.
class Equipment {
 public:
  Equipment(const Configuration& configuration, const Elaboration& elaboration, Findings& findings,
            Scopes& scopes)
      : configuration_(configuration), elaboration_(elaboration), findings_(findings), scopes_(scopes) {}

  /// From now on it is this robot's.
  /// @return  its class; null: it has none, or an unknown one, which is said
  const RobotClass* equip(const Robot& robot);
  /// From now on names of the class are these.
  void use_names(Scope& of_class) { class_scope_ = &of_class; }
  /// Says which of the robot's choices are wrong.
  void check_choices(const Robot& robot);

  /// Who serves a binding point; null: nobody, or several, which is said.
  const DeviceUse* serving(const Word& binding);
  /// The actuator that a drive speaks of, by the device's name or by the binding point; null: there is none,
  /// which is said.
  const DeviceUse* actuator_of(const Drive& drive);
  /// Says where a device is driven for the second time. @return  whether it was the first
  bool drive(const DeviceUse& use, const Drive& drive);
  /// What a device's arguments are read in: its class's names, where the device runs.
  Scope& scope_of(const DeviceUse& use, const Spot& spot);

 private:
  const Configuration& configuration_;
  const Elaboration& elaboration_;
  Findings& findings_;
  Scopes& scopes_;
  std::vector<DeviceUse> devices_;
  std::set<const Device*> driven_;
  Scope* class_scope_ = nullptr;  // null: there are no names
  Word robot_name_;
  std::string class_name_;
  text::Place class_place_;
  bool class_is_broken_ = false;  // it was said; what it would offer is unknown
};

}  // namespace mlab::cdl
