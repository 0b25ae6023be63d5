#include "event_loop.h"

#include <sys/epoll.h>
#include <sys/eventfd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <system_error>

namespace mlab::network {

EventLoop::EventLoop()
    : poll_(::epoll_create1(EPOLL_CLOEXEC)), end_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (!poll_.is_open() || !end_.is_open()) throw std::system_error(errno, std::generic_category(), "epoll");
  epoll_event wanted{};
  wanted.events = EPOLLIN;
  wanted.data.fd = end_.number();
  ::epoll_ctl(poll_.number(), EPOLL_CTL_ADD, end_.number(), &wanted);
  thread_ = std::thread([this] { work(); });
}

EventLoop::~EventLoop() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(end_.number(), &one, sizeof one);
  thread_.join();
}

void EventLoop::add(int descriptor, std::function<void()> on_readable) {
  const std::scoped_lock lock(mutex_);
  callbacks_[descriptor] = std::make_shared<const std::function<void()>>(std::move(on_readable));
  epoll_event wanted{};
  wanted.events = EPOLLIN;
  wanted.data.fd = descriptor;
  ::epoll_ctl(poll_.number(), EPOLL_CTL_ADD, descriptor, &wanted);
}

void EventLoop::remove(int descriptor) {
  const std::scoped_lock lock(mutex_);
  if (callbacks_.erase(descriptor) > 0) ::epoll_ctl(poll_.number(), EPOLL_CTL_DEL, descriptor, nullptr);
}

void EventLoop::work() {
  // Signals are for the threads that know what to do with them.
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, nullptr);
  std::array<epoll_event, 32> events{};
  for (;;) {
    const int count = ::epoll_wait(poll_.number(), events.data(), static_cast<int>(events.size()), -1);
    for (int i = 0; i < count; ++i) {
      const int descriptor = events.at(static_cast<std::size_t>(i)).data.fd;
      if (descriptor == end_.number()) return;
      const std::scoped_lock lock(mutex_);
      const auto found = callbacks_.find(descriptor);
      if (found == callbacks_.end()) continue;
      const Callback callback = found->second;  // it may remove itself
      (*callback)();
    }
  }
}

}  // namespace mlab::network
