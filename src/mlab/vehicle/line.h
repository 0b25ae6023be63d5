#pragma once

#include <optional>
#include <string>

#include "mlab/vehicle.pb.h"

namespace mlab::vehicle {

/// The way from a run to one vehicle and back. Used by one thread at a time.
class Line {
 public:
  Line() = default;
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  virtual ~Line() = default;

  /// The newest VehicleReport that has come since the last call, as bytes that anybody may have sent;
  /// nothing: none has.
  virtual std::optional<std::string> hear() = 0;
  /// Nothing happens where it does not arrive.
  virtual void tell(const wire::VehicleCommand& command) = 0;
};

}  // namespace mlab::vehicle
