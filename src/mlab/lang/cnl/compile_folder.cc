#include "mlab/lang/cnl/compile_folder.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fmt/core.h>

namespace mlab::cnl {
namespace {

namespace fs = std::filesystem;

// Longer than any compilation takes: whoever made the folder may be a process of another machine.
constexpr std::chrono::hours kAbandoned(1);

// Whose folder it is, by its name: `KEY.PROCESS.NUMBER`; 0: nobody's.
pid_t maker_of(std::string_view name) {
  const std::size_t number = name.rfind('.');
  if (number == std::string_view::npos || number + 1 == name.size()) return 0;
  const std::size_t process = name.rfind('.', number - 1);
  if (number == 0 || process == std::string_view::npos) return 0;
  pid_t out = 0;
  const char* const end = name.data() + number;
  const auto read = std::from_chars(name.data() + process + 1, end, out);
  const bool has_number = name.find_first_not_of("0123456789", number + 1) == std::string_view::npos;
  return read.ec == std::errc() && read.ptr == end && has_number && out > 0 ? out : 0;
}

void remove_abandoned(const std::string& folder) {
  std::error_code failure;
  for (fs::directory_iterator it(folder, failure); !failure && it != fs::directory_iterator();
       it.increment(failure)) {
    std::error_code ignored;
    const pid_t maker = it->is_directory(ignored) ? maker_of(it->path().filename().string()) : 0;
    if (maker == 0 || kill(maker, 0) == 0 || errno != ESRCH) continue;
    const auto changed = fs::last_write_time(it->path(), ignored);
    if (!ignored && fs::file_time_type::clock::now() - changed > kAbandoned)
      fs::remove_all(it->path(), ignored);
  }
}

}  // namespace

std::string make_compile_folder(const std::string& folder, const std::string& key) {
  static std::atomic<unsigned> count{0};
  std::error_code failure;
  fs::create_directories(folder, failure);
  remove_abandoned(folder);
  const std::string out = fmt::format("{}/{}.{}.{}", folder, key, getpid(), count++);
  fs::create_directory(out, failure);
  return out;
}

}  // namespace mlab::cnl
