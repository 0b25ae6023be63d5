#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mlab/text/source.h"

namespace mlab::assist {

enum class Language { kMission, kOverlay, kNetwork, kConfiguration, kEnvironment };
std::string_view name(Language language);

/// The language of a file: by its name where that says it (.mdl, .odl, .ovl, .cnl, .cdl, .env), else by what
/// stands in it. Nothing where neither tells.
std::optional<Language> language_of(const text::Source& source);

}  // namespace mlab::assist
