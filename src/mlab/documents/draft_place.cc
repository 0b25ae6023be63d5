#include "mlab/documents/draft_place.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <tuple>

#include <fmt/core.h>

#include "mlab/documents/drafts.h"
#include "mlab/documents/state_folder.h"
#include "mlab/text/private_folder.h"

namespace mlab::documents {

namespace fs = std::filesystem;

namespace {

constexpr int kHeldByAnother = -2;

// Below a state folder.
std::string with_kind(const std::string& folder, const std::string& kind) {
  return kind.empty() ? folder : folder + '/' + kind;
}

}  // namespace

DraftPlace::DraftPlace(const std::string& state_folder, std::string_view project,
                       const std::vector<std::string>& kinds)
    : own_(state_folder), folder_(state_folder) {
  if (state_folder.empty()) return;
  project_ = fs::path(StateFolder(state_folder, project).path()).filename().string();
  while ((lock_ = lock(number_)) == kHeldByAnother && number_ <= kMost) ++number_;
  folder_ = number_ <= kMost ? place(number_) : "";
  if (number_ == 1 && lock_ >= 0) gather(project, kinds);
}

DraftPlace::~DraftPlace() {
  if (lock_ >= 0) ::close(lock_);
}

std::string DraftPlace::place(int number) const {
  return number == 1 ? own_ : fmt::format("{}/beside/{}", own_, number);
}

// kHeldByAnother, or -1 where nothing can be locked: then nothing can be kept either, which others say. One
// that can be locked but not kept from others is locked, lest two servers write there.
int DraftPlace::lock(int number) const {
  const std::string folder = place(number) + '/' + project_;
  std::ignore = text::make_private_folder(folder);
  const int out = ::open((folder + "/drafts.lock").c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (out < 0 || ::flock(out, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return out;
  ::close(out);
  return kHeldByAnother;
}

void DraftPlace::gather(std::string_view project, const std::vector<std::string>& kinds) {
  for (int number = 2; number <= kMost; ++number) {
    std::error_code none;
    if (!fs::is_directory(place(number) + '/' + project_, none)) continue;
    const int held = lock(number);
    if (held < 0) continue;  // whoever has it works with what is there
    for (const std::string& kind : kinds) gather_from(number, project, kind);
    ::close(held);
  }
  std::ranges::sort(left_beside_);
  const auto [first, last] = std::ranges::unique(left_beside_);
  left_beside_.erase(first, last);
}

void DraftPlace::gather_from(int number, std::string_view project, const std::string& kind) {
  const std::string from = with_kind(place(number), kind);
  std::error_code none;
  if (!fs::is_directory(from + '/' + project_, none)) return;
  const StateFolder there(from, project);
  const StateFolder here(with_kind(own_, kind), project);
  for (const char* const extension : {".draft", ".marks"}) {
    for (const std::string& name : there.names(extension)) {
      const fs::path to = fs::path(here.path()) / name;
      std::error_code cannot;
      if (!fs::exists(to, cannot)) fs::rename(fs::path(there.path()) / name, to, cannot);
    }
  }
  std::ranges::move(Drafts(from, project).paths(), std::back_inserter(left_beside_));
}

}  // namespace mlab::documents
