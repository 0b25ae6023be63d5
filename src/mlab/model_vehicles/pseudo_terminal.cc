#include "mlab/model_vehicles/pseudo_terminal.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

namespace mlab::model_vehicles {
namespace {

/// More than this that nobody has read is thrown away [bytes].
constexpr int kMostUnread = 2048;

std::string because(std::string_view what) {
  return fmt::format("{}: {}", what, std::generic_category().message(errno));
}

/// Whether `link` is a symbolic link to a pseudo-terminal: somebody's before, who was killed. The number that
/// it names may be another one's by now.
bool is_left_over(const std::filesystem::path& link) {
  std::error_code error;
  return std::filesystem::read_symlink(link, error).native().starts_with("/dev/pts/");
}

}  // namespace

std::expected<std::unique_ptr<PseudoTerminal>, std::string> PseudoTerminal::open(const std::string& link) {
  std::unique_ptr<PseudoTerminal> line(new PseudoTerminal);
  line->own_end_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  std::array<char, 64> name{};
  if (line->own_end_ < 0 || ::grantpt(line->own_end_) != 0 || ::unlockpt(line->own_end_) != 0 ||
      ::ptsname_r(line->own_end_, name.data(), name.size()) != 0)
    return std::unexpected(because("there is no pseudo-terminal"));
  line->path_ = name.data();
  line->other_end_ = ::open(name.data(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  termios how{};
  if (line->other_end_ < 0 || ::tcgetattr(line->other_end_, &how) != 0)
    return std::unexpected(because(line->path_ + " can't be opened"));
  ::cfmakeraw(&how);
  if (::tcsetattr(line->other_end_, TCSANOW, &how) != 0)
    return std::unexpected(because(line->path_ + " can't be set up"));
  if (link.empty()) return line;
  if (is_left_over(link)) ::unlink(link.c_str());
  if (::symlink(line->path_.c_str(), link.c_str()) != 0)
    return std::unexpected(because(fmt::format("there can't be a link `{}`", link)));
  line->link_ = link;
  return line;
}

PseudoTerminal::~PseudoTerminal() {
  std::error_code error;
  if (!link_.empty() && std::filesystem::read_symlink(link_, error) == path_) ::unlink(link_.c_str());
  if (other_end_ >= 0) ::close(other_end_);
  if (own_end_ >= 0) ::close(own_end_);
}

std::string PseudoTerminal::read() const {
  std::string all;
  std::array<char, 4096> piece{};
  ssize_t got = 0;
  while (all.size() < 16 * piece.size() && (got = ::read(own_end_, piece.data(), piece.size())) > 0)
    all.append(piece.data(), static_cast<std::size_t>(got));
  return all;
}

void PseudoTerminal::write(std::string_view bytes) const {
  int unread = 0;
  if (::ioctl(other_end_, FIONREAD, &unread) == 0 && unread > kMostUnread) ::tcflush(other_end_, TCIFLUSH);
  while (!bytes.empty()) {
    const ssize_t written = ::write(own_end_, bytes.data(), bytes.size());
    if (written <= 0) return;  // nobody reads: it is lost
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace mlab::model_vehicles
