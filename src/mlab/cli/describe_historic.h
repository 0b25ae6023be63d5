#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mlab::cli {

/// What a state or trigger of the historic libraries is here, one for each of its meanings.
struct HistoricMeaning {
  std::string name;           ///< as it was written
  std::string architectures;  ///< `AuRA, AuRA.urban`
  std::string ours;           ///< the component
};

/// By the historic name, letter case aside. Empty where nobody knows the name.
std::vector<HistoricMeaning> historic_meanings(std::string_view historic);
/// The names under which a component of ours stood in the historic libraries, besides its own.
std::vector<HistoricMeaning> historic_names_of(std::string_view ours);

}  // namespace mlab::cli
