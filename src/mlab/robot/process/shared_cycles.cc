#include "mlab/robot/process/shared_cycles.h"

#include <poll.h>
#include <sys/stat.h>

#include <cstring>
#include <ctime>

namespace mlab::robot_process {
namespace {

using robot_wire::Control;
using robot_wire::Mapping;
using robot_wire::PlaceHeader;

bool has_ended(int in) {
  pollfd input{in, POLLIN, 0};
  return poll(&input, 1, 0) > 0 && (input.revents & (POLLHUP | POLLERR | POLLNVAL | POLLIN)) != 0;
}

// False: nobody will ask any more.
bool wait_for_places(Control& control, std::uint32_t done, robot_wire::Looks& looks, int in) {
  const auto is_next = [done](std::uint32_t asked) { return asked != done; };
  if (control.asked.is_soon(is_next, looks)) return true;
  constexpr timespec kPatience{1, 0};
  while (!control.asked.is_after_sleep(is_next, kPatience)) {
    if (has_ended(in)) return false;
  }
  return true;
}

}  // namespace

std::expected<SharedFiles, std::string> SharedFiles::open(int frames, int percepts) {
  struct stat about_frames{};
  struct stat about_percepts{};
  SharedFiles out;
  if (fstat(frames, &about_frames) != 0 || fstat(percepts, &about_percepts) != 0 ||
      static_cast<std::size_t>(about_frames.st_size) < robot_wire::kFirstPlace || about_percepts.st_size <= 0)
    return std::unexpected("nothing is shared with this program");
  const auto size_of = [](const struct stat& about) { return static_cast<std::size_t>(about.st_size); };
  out.control_ = Mapping(frames, robot_wire::kFirstPlace, Mapping::May::kWrite);
  out.frames_ = Mapping(frames, size_of(about_frames), Mapping::May::kWrite);
  out.percepts_ = Mapping(percepts, size_of(about_percepts), Mapping::May::kRead);
  if (out.control_.is_empty() || out.frames_.is_empty() || out.percepts_.is_empty())
    return std::unexpected("what is shared with this program can't be mapped");
  return out;
}

bool SharedFiles::grow() {
  const std::size_t frames = control().frames_size;
  const std::size_t percepts = control().percepts_size;
  return frames_.grow(frames) && percepts_.grow(percepts);
}

int serve_shared(SharedFiles& files, const flow::Program& program, int in) {
  robot_wire::ReadPercepts read;
  const std::size_t size = robot_wire::place_size(program.frame_size());
  robot_wire::Looks looks;
  std::uint32_t done = files.control().answered.get();
  while (wait_for_places(files.control(), done, looks, in)) {
    const std::uint32_t asked = files.control().asked.get();
    if (!files.grow()) return 1;
    for (; done != asked; ++done) {
      const std::uint32_t i = done - files.control().before;
      std::byte* const place = files.place(i, size);
      auto& header = *reinterpret_cast<PlaceHeader*>(place);
      files.control().place.store(i, std::memory_order_relaxed);
      percept::Action action;
      std::byte* const frame = place + sizeof(PlaceHeader);
      program.step(frame, read.read(files.percepts(header.percepts)), action, header.seed, header.robot,
                   nullptr,
                   header.has_interventions != 0 ? robot_wire::interventions_of(frame, program.frame_size())
                                                 : nullptr);
      robot_wire::write_action(action, header.action);
    }
    files.control().place.store(Control::kNobody, std::memory_order_relaxed);
    files.control().answered.set(done);
  }
  return 0;
}

}  // namespace mlab::robot_process
