#include "mlab/flow/conversions.h"

#include "mlab/base/angle.h"
#include "mlab/flow/port_types.h"

namespace mlab::flow {
namespace {

template <class From, double (*kConvert)(From)>
void fire_conversion(Call& call) {
  call.at<double>(call.output) = kConvert(call.at<From>(call.inputs[0]));
}

template <class From, double (*kConvert)(From)>
Behavior conversion(std::string_view name, std::string_view help) {
  static const Input kInput{"value", &type_info<From>(), "", "", false, "", -kNoLimit, kNoLimit};
  Behavior out;
  out.name = name;
  out.help = help;
  out.output = &type_info<double>();
  out.inputs = {&kInput, 1};
  out.is_pure = true;
  out.fire = fire_conversion<From, kConvert>;
  return out;
}

double widened(int value) {
  return value;
}
double in_degrees(double angle) {
  return base::degrees(angle);
}
double in_radians(double angle_deg) {
  return base::radians(angle_deg);
}

}  // namespace

const Behavior& integer_to_real() {
  static const Behavior kBehavior =
      conversion<int, widened>("integer_to_real", "The same number as a double.");
  return kBehavior;
}

const Behavior& radians_to_degrees() {
  static const Behavior kBehavior =
      conversion<double, in_degrees>("radians_to_degrees", "The same angle in degrees.");
  return kBehavior;
}

const Behavior& degrees_to_radians() {
  static const Behavior kBehavior =
      conversion<double, in_radians>("degrees_to_radians", "The same angle in radians.");
  return kBehavior;
}

}  // namespace mlab::flow
