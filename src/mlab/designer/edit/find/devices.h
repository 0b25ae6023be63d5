#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mlab/designer/drawing/components.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/designer/drawing/serving.h"
#include "mlab/text/diagnostic.h"

// Classes of robots and operators of societies, and what stands on their pages. All of it only reads; what is
// found points into the model, and is gone with the next commit.

namespace mlab::designer {

/// Binding points on the page of a class or an operator: `$point.sense_obstacles`.
inline constexpr std::string_view kPointNode = "$point.";

struct DeviceSpot {
  Equipped owner;
  const cdl::Device* device = nullptr;
  const Callable* by = nullptr;  ///< null: nothing answers to its name
};

/// Whether a page is that of a class or an operator.
bool is_equipment(const Model& model, const std::string& page);
/// @param owner  a class or an operator
/// @errors       `cannot-edit`: there is no such owner, or it has no such device
text::Result<DeviceSpot> find_device(const Model& model, const std::string& owner, const std::string& name);
/// What a call gives an input, by name or by position; null: nothing.
const cdl::Argument* argument_of(const cdl::Call& call, const Callable& component, std::string_view name);

}  // namespace mlab::designer
