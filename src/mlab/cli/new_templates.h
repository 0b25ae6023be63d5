#pragma once

namespace mlab::cli {

/// The texts of `templates/`, with @NAME@ and the like still in them.
extern const char* const kMapTemplate;
extern const char* const kMissionTemplate;
extern const char* const kTrialTemplate;
extern const char* const kBehaviorTemplate;
extern const char* const kConfigurationTemplate;

}  // namespace mlab::cli
