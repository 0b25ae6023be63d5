#include "mlab/cli/kept_address.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <utility>
#include <vector>

#include <fmt/core.h>

namespace mlab::cli {
namespace {

constexpr std::string_view kFirstLine = "mlab address 1";
constexpr std::size_t kTokenLength = 40;

bool is_token(std::string_view text) {
  return text.size() == kTokenLength &&
         std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

}  // namespace

KeptAddress::KeptAddress(const std::string& folder, const std::string& project, std::string kind)
    : folder_(folder, project), project_(project), name_(std::move(kind) + ".address") {
  if (folder_.path().empty()) return;
  if (!lock()) {
    found_ = Lookup::kTaken;
    return;
  }
  read();
}

KeptAddress::~KeptAddress() {
  if (lock_ >= 0) ::close(lock_);
}

bool KeptAddress::lock() {
  const std::string path = folder_.path() + '/' + name_ + ".lock";
  lock_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600);
  return lock_ < 0 || ::flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

void KeptAddress::read() {
  const std::string path = folder_.path() + '/' + name_;
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (file < 0) {
    if (errno == ENOENT) return;
    found_ = Lookup::kUnsafe;
    problem_ = "it can't be opened, or is a link";
    return;
  }
  struct stat status{};
  char text[8192];
  const bool is_known = ::fstat(file, &status) == 0;
  const ssize_t size = is_known && S_ISREG(status.st_mode) ? ::read(file, text, sizeof text) : -1;
  ::close(file);
  found_ = Lookup::kUnsafe;
  if (size < 0)
    problem_ = "it is no file that can be read";
  else if (status.st_uid != ::geteuid())
    problem_ = "it belongs to somebody else";
  else if ((status.st_mode & 077U) != 0 || status.st_nlink != 1)
    problem_ = "others could have read it";
  else
    found_ = parse({text, static_cast<std::size_t>(size)}) ? Lookup::kAddress : Lookup::kNone;
}

bool KeptAddress::parse(std::string_view text) {
  const std::vector<std::string_view> lines = lines_of(text);
  if (lines.size() != 5 || lines[0] != kFirstLine || lines[1] != project_ || !is_token(lines[4]))
    return false;
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(lines[3].data(), lines[3].data() + lines[3].size(), port);
  if (error != std::errc{} || end != lines[3].data() + lines[3].size() || port == 0) return false;
  address_ = {std::string(lines[2]), port, std::string(lines[4])};
  return true;
}

std::string KeptAddress::keep(const Address& address) const {
  if (found_ == Lookup::kTaken) return "";
  if (project_.find('\n') != std::string::npos) return "the project's name has more than one line";
  return folder_.write(name_, fmt::format("{}\n{}\n{}\n{}\n{}\n", kFirstLine, project_, address.host,
                                          address.port, address.token));
}

}  // namespace mlab::cli
