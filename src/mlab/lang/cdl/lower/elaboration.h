#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/node_names.h"
#include "mlab/lang/cdl/types/types.h"

namespace mlab::cdl {

/// A device that a robot has, with what decides whether it is the one that is meant.
struct DeviceUse {
  const Device* device = nullptr;
  bool is_chosen = false;  ///< the robot says so
  bool overrides = false;  ///< an operator of its society brings it
};

/// Which device is meant by a name.
struct FoundDevice {
  const DeviceUse* use = nullptr;    ///< null: there is none
  std::vector<std::string> fitting;  ///< more than one: it can't be told, and `use` is the first
};

/// What is known of the owners of one configuration without lowering them: devices of robots, types, and what
/// nodes are called. Reports nothing, and keeps what it made. Both must outlive it. For one thread.
class Elaboration {
 public:
  Elaboration(const Configuration& configuration, const flow::Library& library)
      : configuration_(configuration), library_(library), types_(configuration, library) {}

  const Configuration& configuration() const { return configuration_; }
  const flow::Library& library() const { return library_; }
  const Types& types() const { return types_; }

  /// Those of the robot's society first, from the inside out, then those of its class.
  const std::vector<DeviceUse>& devices(const Robot& robot) const;

  const NodeNames& names(const Robot& robot) const;
  /// By itself: all its parameters are given, and nothing else stands below the place where it runs.
  const NodeNames& names(const Assemblage& assemblage) const { return names(assemblage, {}, {}); }
  /// Where it runs.
  /// @param given  for each parameter whether the caller gives it; empty: all are
  /// @param taken  NodeNames::below of the call, or NodeNames::top of the device
  const NodeNames& names(const Assemblage& assemblage, const std::vector<bool>& given,
                         const NamesBelow& taken) const;
  /// Of what a device gives to the procedure or assemblage that serves it.
  /// @param taken  NodeNames::below of the call that asks for what it serves
  const NodeNames& names(const Device& device, const NamesBelow& taken) const;

 private:
  // Whose names, which parameters' defaults, what was taken.
  using Key = std::tuple<const void*, std::vector<const Parameter*>, NamesBelow>;
  template <class Make>
  const NodeNames& kept(Key key, const Make& make) const;

  const Configuration& configuration_;
  const flow::Library& library_;
  const Types types_;
  mutable std::map<Key, std::unique_ptr<const NodeNames>> names_;
  mutable std::map<const Robot*, std::vector<DeviceUse>> devices_;
};

/// The actuator that a drive speaks of, by the device's name or by the binding point.
FoundDevice actuator_for(const std::vector<DeviceUse>& devices, std::string_view name);
/// The device that serves a binding point.
FoundDevice device_for(const std::vector<DeviceUse>& devices, std::string_view binding);

}  // namespace mlab::cdl
