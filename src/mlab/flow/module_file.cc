#include "mlab/flow/module_file.h"

#include <dlfcn.h>

#include <fmt/core.h>

namespace mlab::flow {

std::expected<std::span<const Behavior* const>, std::string> open_module(const std::string& file) {
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr)
    return std::unexpected(std::string(dlerror()));  // NOLINT(concurrency-mt-unsafe): it is, in glibc
  const auto entry = reinterpret_cast<ModuleEntry>(dlsym(library, kModuleEntry));
  if (entry == nullptr) return std::unexpected(fmt::format("`{}` has no `{}`", file, kModuleEntry));
  const Module& content = *entry();
  if (content.abi != kModuleAbi || content.layout != module_layout())
    return std::unexpected("they were made with headers of another version");
  return std::span(content.behaviors, content.behavior_count);
}

}  // namespace mlab::flow
