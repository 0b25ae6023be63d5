#include "mlab/cell/policy.h"

#include <elf.h>
#include <link.h>
#include <sys/auxv.h>

namespace mlab::cell {
namespace {

int add_library(dl_phdr_info* info, std::size_t, void* into) {
  const std::string name = info->dlpi_name;
  // Without a path: the program itself, and what the kernel maps into every process.
  if (name.starts_with('/')) static_cast<std::vector<std::string>*>(into)->push_back(name);
  return 0;
}

int find_loader(dl_phdr_info* info, std::size_t, void* into) {
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    if (info->dlpi_phdr[i].p_type != PT_INTERP) continue;
    // The system tells it as a number.
    *static_cast<std::string*>(into) = reinterpret_cast<const char*>(  // NOLINT(performance-no-int-to-ptr)
        info->dlpi_addr + info->dlpi_phdr[i].p_vaddr);
    return 1;
  }
  return 0;
}

}  // namespace

std::vector<std::string> own_libraries() {
  std::vector<std::string> out;
  dl_iterate_phdr(add_library, &out);
  if (const std::string loader = own_loader(); !loader.empty()) out.push_back(loader);
  out.emplace_back("/etc/ld.so.cache");
  return out;
}

std::string own_loader() {
  std::string out;
  dl_iterate_phdr(find_loader, &out);
  return out;
}

Policy policy_for(const std::string& executable) {
  Policy out;
  out.readable = own_libraries();
  out.executable = {executable};
  if (const std::string loader = own_loader(); !loader.empty()) out.executable.push_back(loader);
  return out;
}

}  // namespace mlab::cell
