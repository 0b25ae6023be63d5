#include "host.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "address.h"

namespace mlab::network {
namespace {

namespace fs = std::filesystem;

// Column `column` (from 0) behind what a line of a file begins with, on the last such line; 0 where there is
// none.
std::uint64_t number_in(const std::string& file, const std::string& begin, int column) {
  std::ifstream stream(file);
  std::uint64_t out = 0;
  for (std::string line; std::getline(stream, line);) {
    const std::size_t at = line.find_first_not_of(' ');
    if (at == std::string::npos || !line.substr(at).starts_with(begin)) continue;
    std::istringstream words(line.substr(at + begin.size()));
    std::string word;
    for (int i = 0; i <= column; ++i) words >> word;
    out = std::strtoull(word.c_str(), nullptr, 10);
  }
  return out;
}

std::uint64_t dropped_by_kernel_of(pid_t process) {
  constexpr int kSentDropped =
      11;  // eight columns of what was received stand before, then bytes, packets, errors
  constexpr int kNoRoomToRead = 4;  // a line of names, then one of numbers: `RcvbufErrors`
  const std::string folder = "/proc/" + std::to_string(process) + "/net/";
  return number_in(folder + "dev", std::string(kInterface) + ":", kSentDropped) +
         number_in(folder + "snmp", "Udp:", kNoRoomToRead);
}

}  // namespace

Host::Host(KeeperSetup setup, Relay& relay, std::shared_ptr<EventLoop> loop)
    : setup_(std::move(setup)), relay_(relay), loop_(std::move(loop)) {
  power_on();
}

Host::~Host() {
  power_off();
}

const std::string& Host::name() const {
  return setup_.names.at(static_cast<std::size_t>(setup_.number) - 1);
}

std::string Host::address() const {
  return address_of(setup_.number);
}

Process Host::start(const std::vector<std::string>& command, const ProcessSetup& setup) {
  Process process(connection_, loop_, command, setup);
  std::erase_if(started_, [](const Victim& one) { return !one.is_alive(); });
  started_.push_back(process.victim());
  return process;
}

std::vector<Seen> Host::processes() const {
  return is_on() ? descendants_of(connection_->first().id()) : std::vector<Seen>{};
}

fs::path Host::path(const fs::path& on_host) const {
  return fmt::format("/proc/{}/root", connection_->first().id()) / on_host.relative_path();
}

std::string Host::mount_disk(const std::string& folder, std::size_t bytes) {
  const Message answer = connection_->ask({"disk", folder, std::to_string(bytes)});
  return answer.words[0] == "done" ? std::string{} : answer.words.back();
}

void Host::set_clock(Duration ahead) {
  const std::scoped_lock lock(clock_mutex_);
  if (clock_ != nullptr) std::atomic_ref(*clock_).store(ahead.count());
}

void Host::map_clock() {
  const Descriptor file(::open(path(kClockFile).c_str(), O_RDWR | O_CLOEXEC));
  const std::scoped_lock lock(clock_mutex_);
  void* const memory = ::mmap(nullptr, sizeof *clock_, PROT_READ | PROT_WRITE, MAP_SHARED, file.number(), 0);
  clock_ = memory == MAP_FAILED ? nullptr : static_cast<std::int64_t*>(memory);
}

void Host::unmap_clock() {
  const std::scoped_lock lock(clock_mutex_);
  if (clock_ != nullptr) ::munmap(clock_, sizeof *clock_);
  clock_ = nullptr;
}

void Host::power_off() {
  if (!is_on()) return;
  relay_.detach(setup_.number);
  connection_->end();
  unmap_clock();
  started_.clear();
}

void Host::power_on() {
  if (is_on()) return;
  connection_ = std::make_shared<Connection>(setup_);
  network_namespace_ = network_namespace_of(connection_->first().id());
  map_clock();
  if (clock_ == nullptr) throw std::runtime_error("no clock for host " + name());
  relay_.attach(setup_.number, connection_->take_wire());
}

std::vector<std::string> Host::leftovers() const {
  std::vector<std::string> out;
  if (!is_on()) return out;
  for (const Seen& one : processes()) {
    const bool is_started =
        std::ranges::any_of(started_, [&](const Victim& v) { return v.id() == one.id && v.is_alive(); });
    if (one.parent == connection_->first().id() && !is_started) out.push_back(name() + ": " + one.words());
  }
  for (const char* const folder : {"/tmp", "/dev/shm"}) {
    std::error_code failure;
    for (const fs::directory_entry& entry : fs::directory_iterator(path(folder), failure)) {
      const std::string found = fs::path(folder) / entry.path().filename();
      const bool is_ours =
          found == kHarnessFolder || std::ranges::any_of(setup_.shared, [&](const std::string& each) {
            return each == found || each.starts_with(found + "/");
          });
      if (!is_ours) out.push_back(name() + ": " + found);
    }
  }
  std::ranges::sort(out);
  return out;
}

std::uint64_t Host::overruns() const {
  return is_on() ? dropped_by_kernel_of(connection_->first().id()) + relay_.overruns(setup_.number) : 0;
}

}  // namespace mlab::network
