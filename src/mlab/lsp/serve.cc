// The loop over standard input and output.

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>
#include <cerrno>

#include <array>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "mlab/lsp/framing.h"
#include "mlab/lsp/server.h"

namespace mlab::lsp {
namespace {

/// How long nothing has to come before what takes long is begun [ms].
constexpr int kQuiet = 25;

/// Finds the faults of one text at a time, so that questions are answered meanwhile.
class Checker {
 public:
  Checker()
      : done_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
        thread_([this](const std::stop_token& end) { work(end); }) {}
  ~Checker() {
    thread_.request_stop();
    thread_.join();
    ::close(done_);
  }
  Checker(const Checker&) = delete;
  Checker& operator=(const Checker&) = delete;

  /// Can be read from when a check is done.
  int descriptor() const { return done_; }
  bool is_busy() const { return is_busy_; }
  void start(Server::Check check) {
    is_busy_ = true;
    check.around.programs.ends = thread_.get_stop_token();  // nobody waits for a compiler at the end
    {
      const std::scoped_lock lock(mutex_);
      wanted_ = std::move(check);
    }
    wakes_.notify_one();
  }
  void tell(Server& server) {
    std::uint64_t count = 0;
    if (::read(done_, &count, sizeof count) != sizeof count) return;
    is_busy_ = false;
    const std::scoped_lock lock(mutex_);
    server.tell(found_->check, std::move(found_->problems));
    found_.reset();
  }

 private:
  struct Found {
    Server::Check check;
    text::Diagnostics problems;
  };

  void work(const std::stop_token& end) {
    std::unique_lock lock(mutex_);
    while (wakes_.wait(lock, end, [this] { return wanted_.has_value(); })) {
      Server::Check check = *std::exchange(wanted_, std::nullopt);
      lock.unlock();
      text::Diagnostics problems = language::problems(check.text, check.around);
      lock.lock();
      found_ = Found{std::move(check), std::move(problems)};
      const std::uint64_t one = 1;
      [[maybe_unused]] const ssize_t wakes_reader = ::write(done_, &one, sizeof one);
    }
  }

  const int done_;
  bool is_busy_ = false;
  std::mutex mutex_;
  std::condition_variable_any wakes_;
  std::optional<Server::Check> wanted_;
  std::optional<Found> found_;
  std::jthread thread_;
};

}  // namespace

int serve(Options options, int input, const std::function<bool(std::string_view)>& write) {
  bool can_write = true;
  Server server(std::move(options),
                [&](const std::string& message) { can_write = can_write && write(framed(message)); });
  Checker checker;
  MessageReader reader;
  std::array<char, 1 << 16> bytes{};
  while (!server.is_over() && can_write) {
    while (const auto message = reader.next()) {
      message->error.empty() ? server.receive(message->body) : server.refuse(message->error);
      if (server.is_over()) return server.exit_status();
    }
    std::array<pollfd, 2> wait = {{{input, POLLIN, 0}, {checker.descriptor(), POLLIN, 0}}};
    const bool may_check = server.has_work() && !checker.is_busy();
    const int ready = ::poll(wait.data(), wait.size(), may_check ? kQuiet : -1);
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) {
      if (auto check = server.next_check()) checker.start(std::move(*check));
      continue;
    }
    if (wait[1].revents != 0) checker.tell(server);
    if (wait[0].revents == 0) continue;
    const ssize_t got = ::read(input, bytes.data(), bytes.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return 1;  // who asked is gone without `exit`
    reader.add({bytes.data(), static_cast<std::size_t>(got)});
  }
  return server.exit_status();
}

}  // namespace mlab::lsp
