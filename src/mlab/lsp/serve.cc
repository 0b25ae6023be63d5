// The loop over standard input and output.

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>
#include <cerrno>

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

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
  struct CheckResult {
    Server::Check check;
    text::Diagnostics problems;
  };

  void work(const std::stop_token& end) {
    std::unique_lock lock(mutex_);
    while (wakes_.wait(lock, end, [this] { return wanted_.has_value(); })) {
      Server::Check check = *std::exchange(wanted_, std::nullopt);
      lock.unlock();
      text::Diagnostics problems = assist::problems(check.text, check.around);
      lock.lock();
      found_ = CheckResult{std::move(check), std::move(problems)};
      const std::uint64_t one = 1;
      [[maybe_unused]] const ssize_t wakes_reader = ::write(done_, &one, sizeof one);
    }
  }

  const int done_;
  bool is_busy_ = false;
  std::mutex mutex_;
  std::condition_variable_any wakes_;
  std::optional<Server::Check> wanted_;
  std::optional<CheckResult> found_;
  std::jthread thread_;
};

/// What has come and was not handled yet. Looks ahead for what is cancelled before it is answered, or while.
class Inbox {
 public:
  explicit Inbox(int input) : input_(input) {}

  /// Takes what is there to be read. False: nothing comes any more.
  bool read() {
    const ssize_t got = ::read(input_, bytes_.data(), bytes_.size());
    if (got < 0 && errno == EINTR) return true;
    if (got <= 0) return false;
    reader_.add({bytes_.data(), static_cast<std::size_t>(got)});
    while (auto message = reader_.next()) {
      if (message->error.empty()) note_cancelled(message->body);
      waiting_.push_back(std::move(*message));
    }
    return true;
  }
  std::optional<MessageReader::Message> next() {
    if (waiting_.empty()) {
      cancelled_.clear();  // what they were about has been answered
      return std::nullopt;
    }
    MessageReader::Message out = std::move(waiting_.front());
    waiting_.pop_front();
    return out;
  }
  /// Asked often while something is answered: reads only every few milliseconds.
  bool is_cancelled(const std::string& id) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_look_ > std::chrono::milliseconds(5)) {
      pollfd there{input_, POLLIN, 0};
      while (::poll(&there, 1, 0) > 0 && there.revents == POLLIN && read()) {
      }
      last_look_ = now;
    }
    return cancelled_.contains(id);
  }

 private:
  void note_cancelled(const std::string& body) {
    if (!body.contains("$/cancelRequest")) return;
    const nlohmann::json message = nlohmann::json::parse(body, nullptr, false);
    if (!message.is_object() || message.value("method", nlohmann::json()) != "$/cancelRequest") return;
    const nlohmann::json params = message.value("params", nlohmann::json());
    if (params.is_object() && params.contains("id")) cancelled_.insert(params["id"].dump());
  }

  const int input_;
  MessageReader reader_;
  std::array<char, 1 << 16> bytes_{};
  std::deque<MessageReader::Message> waiting_;
  std::set<std::string> cancelled_;
  std::chrono::steady_clock::time_point last_look_;
};

}  // namespace

int serve(Options options, int input, const std::function<bool(std::string_view)>& write) {
  bool can_write = true;
  Inbox inbox(input);
  options.is_cancelled = [&](const std::string& id) { return inbox.is_cancelled(id); };
  Server server(std::move(options),
                [&](const std::string& message) { can_write = can_write && write(framed(message)); });
  Checker checker;
  while (!server.is_over() && can_write) {
    while (const auto message = inbox.next()) {
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
    if (wait[0].revents != 0 && !inbox.read()) return 1;  // who asked is gone without `exit`
  }
  return server.exit_status();
}

}  // namespace mlab::lsp
