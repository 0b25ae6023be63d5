#include "process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "seen.h"

namespace mlab::network {
namespace {

/// What is written into `in` comes out of `out`.
struct Pipe {
  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe for a process");
    out = Descriptor(ends[0]);
    in = Descriptor(ends[1]);
  }
  Descriptor in;
  Descriptor out;
};

std::vector<std::string> environment_with(const ProcessSetup& setup) {
  std::map<std::string, std::string> all;
  for (char** each = environ; *each != nullptr; ++each) {
    const std::string_view text = *each;
    const std::size_t sign = text.find('=');
    if (sign != std::string_view::npos) all[std::string(text.substr(0, sign))] = text.substr(sign + 1);
  }
  if (setup.follows_clock) {
    all["LD_PRELOAD"] = MLAB_SHIFTED_CLOCK;
    all["MLAB_CLOCK_FILE"] = kClockFile;
  }
  for (const auto& [name, value] : setup.environment) all[name] = value;
  std::vector<std::string> out;
  for (const auto& [name, value] : all) {
    if (!value.empty()) out.push_back(name + "=" + value);
  }
  return out;
}

}  // namespace

std::string Ending::words() const {
  if (went_with_host) return "went with its host";
  if (status) return fmt::format("exit status {}", *status);
  const char* const name = ::sigabbrev_np(signal);
  return name != nullptr ? fmt::format("killed by SIG{}", name) : fmt::format("killed by signal {}", signal);
}

Process::Process(std::shared_ptr<Connection> host, std::shared_ptr<EventLoop> loop,
                 const std::vector<std::string>& command, const ProcessSetup& setup)
    : host_(std::move(host)), loop_(std::move(loop)) {
  if (command.empty()) throw std::runtime_error("a process without a command line");
  name_ = std::filesystem::path(command[0]).filename().string();
  Pipe input;
  Pipe output;
  Pipe errors;
  Pipe status;
  std::vector<std::string> words = {"start", setup.folder, std::to_string(command.size())};
  words.insert(words.end(), command.begin(), command.end());
  const std::vector<std::string> environment = environment_with(setup);
  words.insert(words.end(), environment.begin(), environment.end());
  Message answer =
      host_->ask(words, {input.out.number(), output.in.number(), errors.in.number(), status.in.number()});
  if (answer.words[0] == "started" && answer.files.size() == 1) {
    id_on_host_ = answer.words[1];
    victim_ = Victim(name_, std::move(answer.files[0]));
  } else {
    ending_ = Ending{.status = 127};
    failure_ = answer.words.back() + "\n";
  }
  input_ = std::move(input.in);
  status_ = std::move(status.out);
  output_ = std::make_unique<Output>(*loop_, std::move(output.out), std::move(errors.out));
}

Process::~Process() {
  if (output_) end();  // not moved from
}

std::string Process::output() const {
  return output_->text(Output::kOutput);
}

std::string Process::errors() const {
  return failure_ + output_->text(Output::kErrors);
}

bool Process::write(std::string_view text) {
  // One that has ended shall not end the test.
  sigset_t pipe;
  sigset_t before;
  sigemptyset(&pipe);
  sigaddset(&pipe, SIGPIPE);
  ::pthread_sigmask(SIG_BLOCK, &pipe, &before);
  while (!text.empty()) {
    const ssize_t written = ::write(input_.number(), text.data(), text.size());
    if (written <= 0) break;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  const timespec now{};
  if (!text.empty()) ::sigtimedwait(&pipe, nullptr, &now);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return text.empty();
}

std::optional<Ending> Process::wait(Duration limit) {
  if (ending_) return ending_;
  const Time deadline = Clock::now() + limit;
  pollfd wanted{status_.number(), POLLIN, 0};
  for (;;) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(std::max(deadline - Clock::now(), Clock::duration(0)));
    const int count = ::poll(&wanted, 1, static_cast<int>(left.count()));
    if (count > 0) break;
    if (count == 0 && Clock::now() >= deadline) return std::nullopt;
  }
  int status = 0;
  Ending ending;
  if (::read(status_.number(), &status, sizeof status) != sizeof status)
    ending.went_with_host = true;
  else if (WIFEXITED(status))
    ending.status = WEXITSTATUS(status);
  else
    ending.signal = WTERMSIG(status);
  output_->drain();
  ending_ = ending;
  return ending_;
}

void Process::end() {
  if (id_on_host_.empty()) return;
  // Sessions of their own are found as long as it is there to lead to them.
  if (victim_.is_alive()) {
    for (const Seen& one : descendants_of(victim_.id())) Victim(one).signal(SIGKILL);
  }
  victim_.signal(SIGKILL);
  host_->ask({"end", id_on_host_});
  id_on_host_.clear();
  wait(std::chrono::seconds(10));
}

}  // namespace mlab::network
