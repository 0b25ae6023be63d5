#include "mlab/cli/permission.h"

#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "mlab/text/diagnostic.h"

namespace mlab::cli {
namespace {

namespace fs = std::filesystem;
using cell::Grounds;

constexpr std::size_t kMostCodeFiles = 10'000;

// What lies there now; folders whose name begins with a dot, and links, are no part of a project.
std::shared_ptr<const cell::Texts> code_in(const std::string& folder) {
  auto out = std::make_shared<cell::Texts>();
  std::error_code failure;
  fs::recursive_directory_iterator each(folder, fs::directory_options::skip_permission_denied, failure);
  for (; !failure && each != fs::recursive_directory_iterator() && out->size() < kMostCodeFiles;
       each.increment(failure)) {
    const fs::path& path = each->path();
    if (each->is_directory(failure) && path.filename().string().starts_with('.'))
      each.disable_recursion_pending();
    if (path.extension() != ".cnl" || !each->is_regular_file(failure)) continue;
    if (const auto source = text::read_source(path.string())) out->emplace((*source)->text());
  }
  return out;
}

}  // namespace

cell::Permission permission_to_check(bool is_trusted, bool without_cell) {
  return cell::Permission::decide({.purpose = Grounds::Purpose::kCheck,
                                   .people = Grounds::People::kHere,
                                   .allows_native = false,
                                   .without_cell = without_cell,
                                   .is_trusted = is_trusted,
                                   .known = nullptr},
                                  cell::means());
}

cell::Permission permission_to_build(const BuildOptions& options) {
  return permission_to_check(true, options.no_cell);
}

cell::Permission permission_to_carry(const AgentOptions& options) {
  const bool is_local = options.network.interface_name.empty();
  return cell::Permission::decide({.purpose = Grounds::Purpose::kRun,
                                   .people = is_local ? Grounds::People::kHere : Grounds::People::kElsewhere,
                                   .allows_native = options.allow_native || !options.offer.empty(),
                                   .without_cell = options.no_cell,
                                   .is_trusted = true,
                                   .known = nullptr},
                                  cell::means());
}

cell::Permission permission_to_replay() {
  return cell::Permission::decide({.purpose = Grounds::Purpose::kRun,
                                   .people = Grounds::People::kHere,
                                   .allows_native = false,
                                   .without_cell = false,
                                   .is_trusted = true,
                                   .known = nullptr},
                                  cell::means());
}

cell::Permission permission_to_run(const RunOptions& options, Grounds::People people,
                                   const std::string& folder) {
  const bool is_open = people == Grounds::People::kElsewhere && !options.allow_native;
  return cell::Permission::decide({.purpose = Grounds::Purpose::kRun,
                                   .people = people,
                                   .allows_native = options.allow_native,
                                   .without_cell = options.no_cell,
                                   .is_trusted = true,
                                   .known = is_open ? code_in(folder) : nullptr},
                                  cell::means());
}

}  // namespace mlab::cli
