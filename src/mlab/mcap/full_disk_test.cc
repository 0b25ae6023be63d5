// A disk that refuses: it is said at once, and what stands is readable.

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/mcap/reader.h"
#include "mlab/mcap/testing/sample.h"
#include "mlab/mcap/writer.h"

namespace mlab::mcap {
namespace {

using testing::all;
using testing::bytes_of;
using testing::in_order;
using testing::MemorySink;
using testing::reader_of;
using testing::Said;
using testing::ScratchFile;
using testing::Script;

// Until the disk refuses; what it said then.
WriteError fill(Writer& writer, std::uint64_t& taken) {
  const auto channel = writer.add_channel({{}, {}, "/t", "json", {}});
  if (!channel) return channel.error();
  std::uint32_t noise = 1;
  std::string data(1000, ' ');
  for (taken = 0; taken < 1'000'000; ++taken) {
    for (char& c : data) c = static_cast<char>((noise = noise * 1664525 + 1013904223) >> 24);
    const auto written = writer.write({*channel, 0, taken, taken, bytes_of(data)});
    if (!written) return written.error();
  }
  return {};
}

std::string problem_with_kept(const std::string& path, const WriteError& error, std::uint64_t taken) {
  const auto reader = Reader::open(path);
  if (!reader) return reader.error().message;
  const std::size_t read = all(*reader).size();
  if (read != error.kept_messages) return fmt::format("{} read, {} kept", read, error.kept_messages);
  if (read == 0 || error.kept_messages + error.lost_messages != taken + 1)
    return fmt::format("{} of {} read, {} lost", read, taken + 1, error.lost_messages);
  if (reader->ending().file_bytes != error.kept_bytes) return "something stands behind what is kept";
  return "";
}

TEST(FullDisk, WhereverItRefusesWhatStandsIsRead) {
  const Script script = testing::script_of(10);
  const std::size_t whole = testing::file_of(script).size();
  for (const int code : {ENOSPC, EIO}) {
    for (std::size_t room = 0; room < whole; ++room) {
      const auto bytes = std::make_shared<Buffer>();
      auto writer = Writer::onto(std::make_unique<MemorySink>(bytes, room, code), script.options);
      if (!writer) {
        EXPECT_EQ(writer.error().code, code);
        continue;
      }
      Written written = testing::play(*writer, script);
      if (written) written = writer->close();
      ASSERT_FALSE(written);
      const WriteError error = written.error();
      EXPECT_EQ(error.code, code);
      EXPECT_EQ(error.kept_bytes, bytes->size());
      std::vector<Said> kept = script.messages;
      kept.resize(error.kept_messages);
      ASSERT_EQ(all(reader_of(*bytes)), in_order(kept)) << room;
    }
  }
}

TEST(FullDisk, IsSaidOnceForAll) {
  const auto bytes = std::make_shared<Buffer>();
  auto writer = Writer::onto(std::make_unique<MemorySink>(bytes, 200, ENOSPC), {});
  const ChannelId channel = *writer->add_channel({{}, {}, "/t", "json", {}});
  ASSERT_TRUE(writer->write({channel, 0, 1, 1, bytes_of("one")}) && writer->flush());
  const std::string noise = "a long message that does not get shorter: 8f14e45fceea167a5a36dedd4bea2543";
  ASSERT_TRUE(writer->write({channel, 0, 2, 2, bytes_of(noise)}));
  ASSERT_TRUE(writer->write({channel, 0, 3, 3, bytes_of("three")}));
  const std::string said =
      "`recording` can't be written any further: No space left on device; 1 message kept, 2 lost";
  for (int again = 0; again < 2; ++again) {
    EXPECT_EQ(writer->flush().error().message, said);
    EXPECT_EQ(writer->write({channel, 0, 4, 4, {}}).error().message, said);
    EXPECT_EQ(writer->attach({}).error().message, said);
    EXPECT_EQ(writer->add(Metadata{}).error().message, said);
    EXPECT_EQ(writer->add_schema({}).error().message, said);
    EXPECT_EQ(writer->sync().error().message, said);
    EXPECT_EQ(writer->close().error().message, said);
  }
  ASSERT_NE(writer->failure(), nullptr);
  EXPECT_EQ(writer->failure()->lost_messages, 2U);
  EXPECT_EQ(all(reader_of(*bytes)).size(), 1U);
}

// A child of its own, so that neither its limits nor what it mounts is left to anybody.
template <class Do>
int in_child(Do&& action) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(action());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

constexpr int kNotHere = 97;

int fill_and_look(const std::string& path, int code) {
  auto writer = Writer::create(path, {.chunk_bytes = 10'000});
  if (!writer) return 1;
  std::uint64_t taken = 0;
  const WriteError error = fill(*writer, taken);
  const std::string problem = problem_with_kept(path, error, taken);
  if (!problem.empty()) fmt::print("{}\n", problem);
  std::fflush(stdout);
  return error.code == code && problem.empty() ? 0 : 2;
}

TEST(FullDisk, IsToldByAFileSystemThatIsFull) {
  const ScratchFile file;
  const int status = in_child([&] {
    if (::unshare(CLONE_NEWNS) != 0 && ::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return kNotHere;
    if (::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        ::mount("none", file.folder().c_str(), "tmpfs", 0, "size=128k") != 0)
      return kNotHere;
    return fill_and_look(file.path(), ENOSPC);
  });
  if (status == kNotHere) GTEST_SKIP() << "no file system can be mounted here";
  EXPECT_EQ(status, 0);
}

TEST(FullDisk, ALimitOfFilesIsAnErrorAndNoSignal) {
  const ScratchFile file;
  EXPECT_EQ(in_child([&] {
              const rlimit limit{100'000, 100'000};
              if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 3;
              return fill_and_look(file.path(), EFBIG);
            }),
            0);
}

}  // namespace
}  // namespace mlab::mcap
