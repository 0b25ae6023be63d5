#include "mlab/assist/language.h"

#include <filesystem>

#include "mlab/lang/cdl/formula/formula.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/lang/envchange/envchange.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/odl/odl.h"

namespace mlab::assist {

std::string_view name(Language language) {
  switch (language) {
    case Language::kMission:
      return "mission";
    case Language::kOverlay:
      return "overlay";
    case Language::kNetwork:
      return "network";
    case Language::kConfiguration:
      return "configuration";
    case Language::kEnvironment:
      return "environment changes";
  }
  return "";
}

std::optional<Language> language_of(const text::Source& source) {
  const std::string extension = std::filesystem::path(source.name()).extension().string();
  if (extension == ".mdl") return Language::kMission;
  if (extension == ".odl" || extension == ".ovl") return Language::kOverlay;
  if (extension == ".cnl") return Language::kNetwork;
  if (extension == ".cdl" || extension == ".formula") return Language::kConfiguration;
  if (extension == ".env") return Language::kEnvironment;
  if (odl::looks_like_odl(source.text())) return Language::kOverlay;
  if (mdl::looks_like_mdl(source.text())) return Language::kMission;
  if (cnl::looks_like_cnl(source.text())) return Language::kNetwork;
  if (cdl::looks_like_cdl(source.text()) || cdl::looks_like_formula(source.text()))
    return Language::kConfiguration;
  if (envchange::looks_like_envchange(source.text())) return Language::kEnvironment;
  return std::nullopt;
}

}  // namespace mlab::assist
