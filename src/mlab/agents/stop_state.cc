#include "mlab/agents/stop_state.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::agents {
namespace {

namespace fs = std::filesystem;

// No higher number is believed, so that there is always a next one.
constexpr std::uint64_t kMostNumber = std::uint64_t{1} << 62;

std::string reason(int error) {
  return std::generic_category().message(error);
}

// 0, or the error.
int write_whole(const std::string& path, const std::string& bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (file < 0) return errno;
  int error = 0;
  for (std::size_t at = 0; error == 0 && at < bytes.size();) {
    const ssize_t count = ::write(file, bytes.data() + at, bytes.size() - at);
    if (count >= 0)
      at += static_cast<std::size_t>(count);
    else if (errno != EINTR)
      error = errno;
  }
  if (error == 0 && ::fsync(file) != 0) error = errno;
  if (::close(file) != 0 && error == 0) error = errno;
  return error;
}

void sync_folder(const fs::path& folder) {
  const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0) return;
  ::fsync(handle);
  ::close(handle);
}

}  // namespace

StopState pulled(const StopState& before, std::string by) {
  // Pulls are told apart by it, nothing else depends on it.
  std::random_device random;
  return {before.number + 1, true, std::move(by), std::uint64_t{random()} << 32 | random()};
}

StopState released(const StopState& before, std::string by) {
  return {before.number + 1, false, std::move(by), before.pull};
}

void encode(const StopState& state, wire::EmergencyStop& out) {
  out.set_number(state.number);
  out.set_is_engaged(state.is_engaged);
  out.set_by(state.by);
  out.set_pull(state.pull);
}

std::optional<StopState> decode(const wire::EmergencyStop& message) {
  if (message.number() > kMostNumber || (message.number() == 0 && message.is_engaged())) return std::nullopt;
  return StopState{message.number(), message.is_engaged(), text::shown(message.by(), 64), message.pull()};
}

std::optional<StopState> decode(std::string_view message) {
  wire::EmergencyStop out;
  if (!out.ParseFromArray(message.data(), static_cast<int>(message.size()))) return std::nullopt;
  return decode(out);
}

StopState StopFile::read() const {
  std::error_code unreadable;
  if (path_.empty()) return {};
  // A folder that can't be looked into may hold one.
  const bool is_none = fs::symlink_status(path_, unreadable).type() == fs::file_type::not_found;
  if (is_none) return {};
  std::ifstream stream(path_, std::ios::binary);
  std::ostringstream read;
  read << stream.rdbuf();
  auto state = stream.is_open() ? decode(std::move(read).str()) : std::nullopt;
  if (state && state->number > 0) return std::move(*state);
  // Somebody may have stopped this machine; better it stands for nothing.
  return {1, true, fmt::format("nobody that is known: {} can't be read", path_), 0};
}

std::optional<std::string> StopFile::write(const StopState& state) const {
  if (path_.empty()) return std::nullopt;
  wire::EmergencyStop message;
  encode(state, message);
  const fs::path folder = fs::path(path_).parent_path();
  std::error_code error;
  fs::create_directories(folder, error);
  const std::string fresh = path_ + ".new";
  if (const int problem = write_whole(fresh, message.SerializeAsString()); problem != 0)
    return fmt::format("{} can't be written: {}", fresh, reason(problem));
  fs::rename(fresh, path_, error);
  if (error) return fmt::format("{} can't be written: {}", path_, error.message());
  sync_folder(folder);
  return std::nullopt;
}

std::optional<std::string> StopFile::why_not_kept() const {
  if (path_.empty()) return "there is no folder to keep it in: neither XDG_STATE_HOME nor HOME names one";
  const fs::path folder = fs::path(path_).parent_path();
  std::error_code error;
  fs::create_directories(folder, error);
  if (::access(folder.c_str(), W_OK | X_OK) == 0) return std::nullopt;
  return fmt::format("{} can't be written: {}", folder.string(), reason(errno));
}

void StopFile::remove() const {
  std::error_code failure;
  if (!path_.empty() && fs::remove(path_, failure)) sync_folder(fs::path(path_).parent_path());
}

}  // namespace mlab::agents
