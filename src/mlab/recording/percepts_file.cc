#include "mlab/recording/percepts_file.h"

#include <array>
#include <filesystem>
#include <ios>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/recording/percepts_check.h"
#include "mlab/robot/wire/framing.h"
#include "mlab/text/shown.h"

namespace mlab::recording {
namespace {

constexpr std::uint32_t kFormat = 1;
constexpr const char* kMagic = "missionlab percepts";

text::Diagnostic problem_with(const char* kind, std::string message) {
  return {text::Severity::kError, kind, std::move(message), {}, {}, {}, {}};
}

}  // namespace

text::Result<std::unique_ptr<PerceptsWriter>> PerceptsWriter::create(const std::string& path,
                                                                     std::uint64_t seed,
                                                                     const std::string& mission) {
  std::unique_ptr<PerceptsWriter> out(new PerceptsWriter(path));
  if (!out->out_)
    return std::unexpected(
        problem_with("can-not-write", fmt::format("`{}` can't be written", text::shown(path))));
  wire::RecordedEntry entry;
  entry.mutable_head()->set_format(kFormat);
  entry.mutable_head()->set_magic(kMagic);
  entry.mutable_head()->set_seed(seed);
  entry.mutable_head()->set_mission(mission);
  out->write(entry);
  return out;
}

void PerceptsWriter::write(const wire::RecordedEntry& entry) {
  if (entry.has_cycle()) ++cycles_;
  bytes_.clear();
  robot_wire::append_framed(entry, bytes_);
  is_too_large_ = is_too_large_ || bytes_.size() > kMostBytes;
  out_.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
}

std::optional<text::Diagnostic> PerceptsWriter::finish() {
  wire::RecordedEntry entry;
  entry.mutable_end()->set_cycles(cycles_);
  write(entry);
  out_.close();
  if (is_too_large_)
    return problem_with("can-not-write",
                        fmt::format("`{}` can't be read back: a cycle or the map takes more than {} bytes",
                                    text::shown(path_), kMostBytes));
  if (out_) return std::nullopt;
  return problem_with("can-not-write",
                      fmt::format("`{}` was not written to its end: is the disk full?", text::shown(path_)));
}

text::Result<std::unique_ptr<PerceptsReader>> PerceptsReader::open(const std::string& path) {
  std::unique_ptr<PerceptsReader> out(new PerceptsReader(path));
  const auto failed = [&](const std::string& what) {
    return std::unexpected(problem_with("no-percepts", fmt::format("`{}`: {}", text::shown(path), what)));
  };
  std::error_code unreadable;
  if (!std::filesystem::exists(path, unreadable)) return failed("there is no such file");
  if (!std::filesystem::is_regular_file(path, unreadable)) return failed("it is no ordinary file");
  out->in_.open(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = out->in_ ? static_cast<std::streamoff>(out->in_.tellg()) : -1;
  if (size < 0 || !out->in_) return failed("it can't be read");
  out->end_ = static_cast<std::uint64_t>(size);
  if (size == 0) return failed("it is empty");
  out->in_.seekg(0);
  if (const auto problem = out->look_through())
    return failed(fmt::format("at byte {}: {}", out->at_, *problem));
  out->in_.clear();
  out->in_.seekg(0);
  out->at_ = 0;
  static_cast<void>(out->read_entry());  // the head
  return out;
}

std::optional<std::string> PerceptsReader::read_entry() {
  at_ = static_cast<std::uint64_t>(in_.tellg());
  const std::uint64_t left = end_ - at_;
  std::array<unsigned char, 4> head{};
  if (left < head.size())
    return fmt::format("the file ends with {} of the 4 bytes of a length: it was cut off", left);
  in_.read(reinterpret_cast<char*>(head.data()), head.size());
  std::size_t size = 0;
  for (std::size_t i = 0; i < head.size(); ++i) size |= std::size_t{head[i]} << (8 * i);
  if (size > kMostBytes)
    return fmt::format("an entry of {} bytes, where {} are the most: this is no file of percepts, or broken",
                       size, kMostBytes);
  if (left - head.size() < size)
    return fmt::format("the file ends with {} of the {} bytes of an entry: it was cut off",
                       left - head.size(), size);
  bytes_.resize(size);
  in_.read(bytes_.data(), static_cast<std::streamsize>(size));
  if (!in_) return "it can't be read any further";
  return parse_entry(bytes_, entry_);
}

std::optional<std::string> PerceptsReader::look_through() {
  if (auto problem = read_entry()) return problem;
  if (!entry_.has_head() || entry_.head().magic() != kMagic)
    return "no head of a file of percepts stands here: it is another kind of file";
  if (entry_.head().format() != kFormat)
    return fmt::format("format {}, and this program knows only format {}", entry_.head().format(), kFormat);
  head_ = entry_.head();
  bool has_ended = false;
  while (!has_ended) {
    if (at_ = static_cast<std::uint64_t>(in_.tellg()); at_ == end_)
      return fmt::format(
          "the file ends after {} cycles without an end: it was cut off, or its run was killed", cycles_);
    if (auto problem = read_entry()) return problem;
    if (auto problem = look_at_entry(has_ended)) return problem;
  }
  at_ = static_cast<std::uint64_t>(in_.tellg());
  if (at_ != end_) return fmt::format("{} bytes behind the end", end_ - at_);
  return std::nullopt;
}

std::optional<std::string> PerceptsReader::look_at_entry(bool& has_ended) {
  if (entry_.has_head()) return "a second head";
  if (entry_.has_cycle()) ++cycles_;
  if (entry_.has_embodied()) {
    bodies_.push_back(entry_.embodied());
    if (bodies_.size() > kMostBodies) return fmt::format("more than {} starts of robots", kMostBodies);
  }
  has_ended = entry_.has_end();
  if (!has_ended || entry_.end().cycles() == cycles_) return std::nullopt;
  return fmt::format("the end speaks of {} cycles, and {} stand before it", entry_.end().cycles(), cycles_);
}

const wire::RecordedEntry* PerceptsReader::peek() {
  if (!has_next_) {
    // All has been looked through; a file that was changed since then ends here.
    if (static_cast<std::uint64_t>(in_.tellg()) >= end_ || read_entry()) return nullptr;
    has_next_ = true;
  }
  return &entry_;
}

}  // namespace mlab::recording
