#include "mlab/cli/describe_historic.h"

#include <algorithm>
#include <utility>

#include "mlab/lang/cdl_historic/library_names.h"

namespace mlab::cli {
namespace {

using cdl_historic::LibraryName;

bool same_ignoring_case(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, small, small);
}

std::string architectures_of(unsigned bits) {
  if (bits == cdl_historic::kAnyArchitecture) return "all";
  constexpr std::pair<unsigned, const char*> kNames[] = {{cdl_historic::kAura, "AuRA"},
                                                         {cdl_historic::kUrban, "AuRA.urban"},
                                                         {cdl_historic::kNaval, "AuRA.naval"},
                                                         {cdl_historic::kUgv, "UGV"}};
  std::string out;
  for (const auto& [bit, name] : kNames) {
    if ((bits & bit) != 0) out += (out.empty() ? "" : ", ") + std::string(name);
  }
  return out;
}

// `Standby*`: the star said that it is made of several files.
std::string_view plain(std::string_view historic) {
  return historic.ends_with('*') ? historic.substr(0, historic.size() - 1) : historic;
}

// One entry for the same name with the same meaning in several architectures.
void add(std::vector<HistoricMeaning>& out, const LibraryName& row) {
  std::string_view rest = row.ours;
  const std::string ours(cdl_historic::next_name(rest));
  const auto same = std::ranges::find_if(
      out, [&](const HistoricMeaning& one) { return one.name == plain(row.historic) && one.ours == ours; });
  if (same != out.end()) {
    same->architectures += ", " + architectures_of(row.architectures);
    return;
  }
  out.push_back({std::string(plain(row.historic)), architectures_of(row.architectures), ours});
}

}  // namespace

std::vector<HistoricMeaning> historic_meanings(std::string_view historic) {
  std::vector<HistoricMeaning> out;
  for (const LibraryName& row : cdl_historic::library_names()) {
    if (same_ignoring_case(plain(row.historic), historic)) add(out, row);
  }
  return out;
}

std::vector<HistoricMeaning> historic_names_of(std::string_view ours) {
  std::vector<HistoricMeaning> out;
  for (const LibraryName& row : cdl_historic::library_names()) {
    std::string_view rest = row.ours;
    if (cdl_historic::next_name(rest) == ours && plain(row.historic) != ours) add(out, row);
  }
  return out;
}

}  // namespace mlab::cli
