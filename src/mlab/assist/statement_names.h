#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mlab/assist/cdl_scan.h"
#include "mlab/assist/name.h"
#include "mlab/assist/service.h"
#include "mlab/overlay/overlay.h"

namespace mlab::assist {

/// A name as written, less its quotes and the `*` at its end.
text::Span bare_name(const text::SourcePtr& source, text::Span span);

/// The part of a reference that is the measure's own name: `Red` of `PL-Red`.
text::Span own_part(const text::SourcePtr& source, text::Span span, const overlay::ControlMeasure& measure);

/// The robot, or society, of a configuration that a mission's robot type means.
struct MeantRobot {
  CdlScan scan;                           ///< of the configuration
  std::string file;                       ///< as written
  const CdlDeclaration* robot = nullptr;  ///< null: there is none of that name
  const CdlDeclaration* robot_class = nullptr;
  const CdlDeclaration* society = nullptr;  ///< that the name means instead

  /// Of what the name means; the beginning of the file where it has none of that name.
  text::Span declaration_span() const { return robot ? robot->span : society ? society->span : text::Span{}; }
};
/// @param program  as the mission writes it: `forager.cdl#Forager`
/// @return  nothing where it is no configuration that can be read
std::optional<MeantRobot> robot_meant(const std::string& program, const std::string& type_name,
                                      const std::string& folder, const Surroundings& around);

/// The parameter that a mission sets by this name: the robot's own comes before its class's. Null: none.
const CdlParameter* find_parameter(const MeantRobot& in, const std::string& name);

std::string folder_of(const Text& text);

}  // namespace mlab::assist
