#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mlab/flow/library.h"
#include "mlab/flow/network.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/text/diagnostic.h"

namespace mlab::exports {

/// One robot of a configuration, as written and flattened.
struct Subject {
  const cdl::Configuration& configuration;
  const cdl::Robot& robot;
  const flow::Network& network;
  const flow::Library& library;
};

/// A form in which other tools take configurations.
struct Format {
  std::string_view name;  ///< of `mlab build --emit`
  std::string_view help;
  /// Nothing where the robot can't be said in it, which is then in the sink.
  std::optional<std::string> (*write)(const Subject& subject, text::Diagnostics& sink);
};

/// All formats, in alphabetical order.
std::span<const Format> formats();
/// Null where there is none of that name.
const Format* find_format(std::string_view name);

}  // namespace mlab::exports
