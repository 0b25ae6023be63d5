#include "mlab/robot/process/serve.h"

#include <unistd.h>

#include <cerrno>
#include <span>
#include <string>
#include <string_view>

#include "mlab/robot/wire/framing.h"

namespace mlab::robot_process {
namespace {

bool write_all(int out, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(out, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

int serve(Speaker& speaker, int in, int out) {
  robot_wire::FrameReader reader;
  std::string bytes;
  for (;;) {
    const std::span<char> room = reader.room();
    const ssize_t count = read(in, room.data(), room.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0 && reader.is_empty() ? 0 : 1;
    reader.advance(static_cast<std::size_t>(count));
    while (const auto message = reader.next()) {
      bytes.clear();
      robot_wire::append_framed(speaker.answer(*message), bytes);
      if (!write_all(out, bytes)) return 1;
      if (SharedFiles* files = speaker.shared()) return serve_shared(*files, *speaker.program(), in);
    }
    if (reader.is_nonsense()) return 1;
  }
}

}  // namespace mlab::robot_process
