#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/designer/drawing/components.h"
#include "mlab/designer/drawing/model.h"

// Who serves binding points: devices of classes of robots, operators of societies in their place.

namespace mlab::designer {

/// What has devices: a class of robots or an operator of societies, declared by the text itself. Points into
/// the model.
struct Equipped {
  const cdl::RobotClass* robot_class = nullptr;
  const cdl::SocietyOperator* society_operator = nullptr;

  explicit operator bool() const { return robot_class != nullptr || society_operator != nullptr; }
  const std::vector<cdl::Device>& devices() const {
    return robot_class != nullptr ? robot_class->devices : society_operator->devices;
  }
  /// Null: the text has no device of that name.
  const cdl::Device* device(std::string_view name) const;
};
/// Of that name, but no robot that is called the same. Neither: nothing of the text has devices and is called
/// so.
Equipped equipped(const Model& model, std::string_view name);

/// The nodes of a class's page that are no devices: `$body.drive` for what the `drive` of its body says.
inline constexpr std::string_view kBodyNode = "$body.";

/// Why a component can't serve a binding point, as a sentence; empty: it can.
std::string why_not_serving(const Callable& component, const cdl::Binding& binding,
                            const Components& components);
/// The same of a device as it stands, with what it still needs.
std::string device_verdict(const cdl::Device& device, const Components& components);

/// The binding points that a robot asks for, through all assemblages that it is made of.
std::set<std::string> requested_bindings(const cdl::Configuration& configuration, const cdl::Robot& robot);
/// Those of them that operators of its societies serve.
std::set<std::string> overridden_bindings(const cdl::Configuration& configuration, const cdl::Robot& robot);

/// Whether the body or a device of a class reads a parameter of the class.
bool reads_parameter(const cdl::RobotClass& robot_class, std::string_view parameter);

/// Why no components can be placed, copied or connected on a page that has no dataflow.
std::string why_no_components(const Model& model, const std::string& page);

/// The name of every component that an expression calls.
void add_calls(const cdl::ExpressionPtr& expression, std::set<std::string>& out);

/// The library's component that most robots have for a binding point; empty: it has none that fits.
std::string usual_component(const Model& model, const std::string& binding);

}  // namespace mlab::designer
