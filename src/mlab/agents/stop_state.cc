#include "mlab/agents/stop_state.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <system_error>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::agents {
namespace {

namespace fs = std::filesystem;

// No higher number is believed.
constexpr std::uint64_t kMostNumber = std::uint64_t{1} << 62;

std::uint64_t after(std::uint64_t number) {
  return std::min(number + 1, kMostNumber);
}

bool knows(const std::vector<Pull>& pulls, std::uint64_t id) {
  return std::ranges::find(pulls, id, &Pull::id) != pulls.end();
}

bool knows_all(const std::vector<Pull>& pulls, const std::vector<Pull>& of) {
  return std::ranges::all_of(of, [&](const Pull& one) { return knows(pulls, one.id); });
}

void add(std::vector<Pull>& pulls, const Pull& pull) {
  const auto at = std::ranges::find(pulls, pull.id, &Pull::id);
  if (at == pulls.end())
    pulls.push_back(pull);
  else if (std::tie(at->number, at->by) < std::tie(pull.number, pull.by))
    *at = pull;
}

void put_in_order(std::vector<Pull>& pulls) {
  std::ranges::sort(pulls, {}, [](const Pull& one) { return std::pair(one.number, one.id); });
  if (pulls.size() > kMostPulls) pulls.erase(pulls.begin(), pulls.end() - kMostPulls);
}

void put_in_order(StopState& state) {
  std::erase_if(state.standing, [&](const Pull& one) { return knows(state.released, one.id); });
  put_in_order(state.standing);
  put_in_order(state.released);
}

std::uint64_t new_id() {
  std::random_device random;
  const std::uint64_t id = std::uint64_t{random()} << 32 | random();
  return id == 0 ? 1 : id;
}

void encode_pulls(const std::vector<Pull>& pulls, google::protobuf::RepeatedPtrField<wire::StopPull>& out) {
  for (const Pull& one : pulls) {
    wire::StopPull& pull = *out.Add();
    pull.set_id(one.id);
    pull.set_number(one.number);
    pull.set_by(one.by);
  }
}

std::vector<Pull> pulls_in(const google::protobuf::RepeatedPtrField<wire::StopPull>& pulls) {
  std::vector<Pull> out;
  for (const wire::StopPull& one : pulls)
    out.push_back({one.id(), std::min(one.number(), kMostNumber), text::shown(one.by(), 64)});
  return out;
}

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

std::string StopState::by() const {
  const std::vector<Pull>& last = is_engaged() ? standing : released;
  return last.empty() ? "" : last.back().by;
}

Learnt StopState::learn(const StopState& heard) {
  StopState joined = *this;
  for (const Pull& one : heard.standing) add(joined.standing, one);
  for (const Pull& one : heard.released) add(joined.released, one);
  put_in_order(joined);
  joined.number = std::max(number, heard.number);
  // So that it overrides both for who goes by numbers.
  for (const StopState* one : {static_cast<const StopState*>(this), &heard}) {
    if (one->is_engaged() != joined.is_engaged() && one->number >= joined.number)
      joined.number = after(one->number);
  }
  const Learnt out = !knows_all(standing, joined.standing) ? Learnt::kStop
                     : joined.standing.size() != standing.size() || !knows_all(released, joined.released)
                         ? Learnt::kSomething
                         : Learnt::kNothing;
  *this = std::move(joined);
  return out;
}

StopState pulled(StopState before, std::string by) {
  before.number = after(before.number);
  before.standing.push_back({new_id(), before.number, std::move(by)});
  put_in_order(before);
  return before;
}

StopState released(StopState before, const std::string& by) {
  before.number = after(before.number);
  for (const Pull& one : before.standing) add(before.released, {one.id, before.number, by});
  put_in_order(before);
  return before;
}

void encode(const StopState& state, wire::EmergencyStop& out) {
  out.set_number(state.number);
  out.set_is_engaged(state.is_engaged());
  out.set_by(state.by());
  const std::vector<Pull>& last = state.is_engaged() ? state.standing : state.released;
  if (!last.empty()) out.set_pull(last.back().id);
  encode_pulls(state.standing, *out.mutable_standing());
  encode_pulls(state.released, *out.mutable_released());
}

std::optional<StopState> decode(const wire::EmergencyStop& message) {
  if (message.number() > kMostNumber || (message.number() == 0 && message.is_engaged())) return std::nullopt;
  StopState out{message.number(), pulls_in(message.standing()), pulls_in(message.released())};
  // Older agents know of but one.
  const Pull only{message.pull(), message.number(), text::shown(message.by(), 64)};
  if (message.is_engaged() && out.standing.empty()) out.standing.push_back(only);
  if (!message.is_engaged() && out.released.empty() && message.number() > 0) out.released.push_back(only);
  put_in_order(out);
  return out;
}

std::optional<StopState> decode(std::string_view message) {
  wire::EmergencyStop out;
  if (!out.ParseFromArray(message.data(), static_cast<int>(message.size()))) return std::nullopt;
  return decode(out);
}

bool has_confirmed(const wire::EmergencyStop& said, const StopState& wanted) {
  if (said.is_engaged() != wanted.is_engaged()) return false;
  if (said.standing().empty() && said.released().empty()) return said.number() == wanted.number;
  const auto there = decode(said);
  return there && (wanted.is_engaged() ? knows_all(there->standing, wanted.standing)
                                       : knows_all(there->released, wanted.released));
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
  // Somebody may have stopped this machine; better it stands for nothing. No release that there has been so
  // far was meant for that.
  if (!state || state->number == 0)
    return pulled({}, fmt::format("nobody that is known: {} can't be read", path_));
  for (Pull& one : state->standing) {
    if (one.id == 0) one.id = new_id();
  }
  return std::move(*state);
}

std::optional<std::string> StopFile::write_beside(const std::string& bytes) const {
  if (path_.empty()) return "there is no folder to keep it in: neither XDG_STATE_HOME nor HOME names one";
  std::error_code error;
  fs::create_directories(fs::path(path_).parent_path(), error);
  const int problem = write_whole(fresh(), bytes);
  if (problem == 0) return std::nullopt;
  fs::remove(fresh(), error);
  return fmt::format("{} can't be written: {}", path_, reason(problem));
}

std::optional<std::string> StopFile::write(const StopState& state) const {
  wire::EmergencyStop message;
  encode(state, message);
  if (auto problem = write_beside(message.SerializeAsString())) return problem;
  std::error_code error;
  std::error_code leftover;
  fs::rename(fresh(), path_, error);
  if (error) fs::remove(fresh(), leftover);
  if (error) return fmt::format("{} can't be written: {}", path_, error.message());
  sync_folder(fs::path(path_).parent_path());
  return std::nullopt;
}

std::optional<std::string> StopFile::why_not_kept() const {
  constexpr std::size_t kAmple = 4096;  // [bytes]; more than any state takes
  auto problem = write_beside(std::string(kAmple, '\0'));
  std::error_code failure;
  if (!path_.empty()) fs::remove(fresh(), failure);
  return problem;
}

bool StopFile::is_there() const {
  std::error_code failure;
  return !path_.empty() && fs::exists(path_, failure);
}

void StopFile::remove() const {
  std::error_code failure;
  if (!path_.empty() && fs::remove(path_, failure)) sync_folder(fs::path(path_).parent_path());
}

}  // namespace mlab::agents
