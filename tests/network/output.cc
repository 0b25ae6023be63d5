#include "output.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>

namespace mlab::network {
namespace {

constexpr std::size_t kKept = std::size_t{512} * 1024;  // bytes of the first, and of the last

}  // namespace

Output::Output(EventLoop& loop, Descriptor output, Descriptor errors) : loop_(loop) {
  parts_[kOutput].pipe = std::move(output);
  parts_[kErrors].pipe = std::move(errors);
  for (Part& part : parts_) {
    ::fcntl(part.pipe.number(), F_SETFL, O_NONBLOCK);
    loop_.add(part.pipe.number(), [this, &part] {
      const std::scoped_lock lock(mutex_);
      read_from(part);
      if (!part.is_open) loop_.remove(part.pipe.number());
    });
  }
}

Output::~Output() {
  for (const Part& part : parts_) loop_.remove(part.pipe.number());
}

void Output::read_from(Part& part) {
  std::array<char, 16'384> block{};
  for (;;) {
    const ssize_t size = ::read(part.pipe.number(), block.data(), block.size());
    if (size < 0 && errno == EINTR) continue;
    if (size == 0) part.is_open = false;
    if (size <= 0) break;
    keep(part, std::string_view(block.data(), static_cast<std::size_t>(size)));
  }
  changed_.notify_all();
}

void Output::keep(Part& part, std::string_view text) {
  const std::size_t more = std::min(text.size(), kKept - part.first.size());
  part.first += text.substr(0, more);
  part.last += text.substr(more);
  if (part.last.size() <= 2 * kKept) return;
  const std::size_t gone = part.last.size() - kKept;
  part.left_out += gone;
  part.last.erase(0, gone);
}

std::string Output::text_of(const Part& part) const {
  if (part.left_out == 0) return part.first + part.last;
  return fmt::format("{}\n[{} bytes are left out here]\n{}", part.first, part.left_out, part.last);
}

std::string Output::text(Stream stream) const {
  const std::scoped_lock lock(mutex_);
  return text_of(parts_.at(stream));
}

bool Output::has(std::string_view text, Duration limit) const {
  const Time deadline = Clock::now() + limit;
  const auto is_there = [&](const Part& part) { return text_of(part).find(text) != std::string::npos; };
  std::unique_lock lock(mutex_);
  for (;;) {
    if (std::ranges::any_of(parts_, is_there)) return true;
    if (std::ranges::none_of(parts_, &Part::is_open)) return false;
    if (changed_.wait_until(lock, deadline) == std::cv_status::timeout)
      return std::ranges::any_of(parts_, is_there);
  }
}

void Output::drain() {
  const std::scoped_lock lock(mutex_);
  for (Part& part : parts_) {
    if (part.is_open) read_from(part);
  }
}

}  // namespace mlab::network
