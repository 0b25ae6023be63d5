#include "mlab/recording/percepts_file.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/percept/action.h"
#include "mlab/robot_wire/action_wire.h"
#include "mlab/robot_wire/percepts_wire.h"
#include "mlab/text/shown.h"

namespace mlab::recording {
namespace {

constexpr std::uint32_t kFormat = 1;
constexpr const char* kMagic = "missionlab percepts";

text::Diagnostic problem_with(const char* kind, std::string message) {
  return {text::Severity::kError, kind, std::move(message), {}, {}, {}, {}};
}

bool is_as_long(const wire::Points& points, int length) {
  return points.x_size() == length && points.y_size() == length;
}

constexpr double kFarthest = 1e9;                  // of anything from the origin [m]
constexpr std::uint32_t kMostObjects = 1U << 20U;  // ids count from 1

bool is_place(double x, double y) {
  return std::abs(x) <= kFarthest && std::abs(y) <= kFarthest;
}

std::optional<std::string> problem_of(const wire::RecordedObject& object) {
  if (object.id() == 0 || object.id() > kMostObjects)
    return fmt::format("an object with the id {}, where 1 to {} can be", object.id(), kMostObjects);
  if (!is_place(object.x(), object.y()))
    return fmt::format("object {} at ({}, {})", object.id(), object.x(), object.y());
  return std::nullopt;
}

std::optional<std::string> problem_of(std::uint32_t robot, const wire::Pose& pose) {
  if (is_place(pose.x(), pose.y()) && std::isfinite(pose.heading())) return std::nullopt;
  return fmt::format("robot {} at ({}, {}), heading {}", robot, pose.x(), pose.y(), pose.heading());
}

std::optional<std::string> problem_of(const wire::RecordedWorld& world) {
  const int discs = world.disc_x_size();
  if (world.disc_y_size() != discs || world.disc_radius_size() != discs)
    return fmt::format("{} discs have {} y and {} radii", discs, world.disc_y_size(),
                       world.disc_radius_size());
  const int walls = world.wall_group_size();
  if (!is_as_long(world.wall_a(), walls) || !is_as_long(world.wall_b(), walls))
    return fmt::format("{} walls have {} and {} ends", walls, world.wall_a().x_size(),
                       world.wall_b().x_size());
  for (const wire::RecordedObject& object : world.objects()) {
    if (auto problem = problem_of(object)) return problem;
  }
  return std::nullopt;
}

std::optional<std::string> problem_of(const wire::RecordedCycle& cycle) {
  if (!(cycle.duration() > 0.0) || !std::isfinite(cycle.duration()))
    return fmt::format("a cycle lasts {} s", cycle.duration());
  robot_wire::DecodedPercepts percepts;
  percept::Action action;
  for (const wire::RecordedRobot& robot : cycle.robots()) {
    auto problem = percepts.decode(robot.percepts());
    if (!problem) problem = robot_wire::decode(robot.action(), action);
    if (problem) return fmt::format("of robot {}: {}", robot.robot(), *problem);
  }
  for (const wire::RecordedState& state : cycle.states()) {
    if (auto problem = problem_of(state.robot(), state.pose())) return problem;
  }
  for (const wire::RecordedObject& object : cycle.objects()) {
    if (auto problem = problem_of(object)) return problem;
  }
  return std::nullopt;
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
  out_.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
}

std::optional<text::Diagnostic> PerceptsWriter::finish() {
  wire::RecordedEntry entry;
  entry.mutable_end()->set_cycles(cycles_);
  write(entry);
  out_.close();
  if (out_) return std::nullopt;
  return problem_with("can-not-write",
                      fmt::format("`{}` was not written to its end: is the disk full?", text::shown(path_)));
}

text::Result<std::unique_ptr<PerceptsReader>> PerceptsReader::open(const std::string& path) {
  std::unique_ptr<PerceptsReader> out(new PerceptsReader(path));
  const auto failed = [&](const std::string& what) {
    return std::unexpected(problem_with("no-percepts", fmt::format("`{}`: {}", text::shown(path), what)));
  };
  out->in_.open(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = out->in_ ? static_cast<std::streamoff>(out->in_.tellg()) : -1;
  if (size < 0 || !out->in_) return failed("there is no such file, or it can't be read");
  out->end_ = static_cast<std::uint64_t>(size);
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
  if (size > robot_wire::kMaxMessage)
    return fmt::format("an entry of {} bytes, where {} are the most: this is no file of percepts, or broken",
                       size, robot_wire::kMaxMessage);
  if (left - head.size() < size)
    return fmt::format("the file ends with {} of the {} bytes of an entry: it was cut off",
                       left - head.size(), size);
  bytes_.resize(size);
  in_.read(bytes_.data(), static_cast<std::streamsize>(size));
  if (!in_) return "it can't be read any further";
  if (!entry_.ParseFromString(bytes_))
    return fmt::format("{} bytes that are no entry: this is no file of percepts, or broken", size);
  return std::nullopt;
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
  switch (entry_.body_case()) {
    case wire::RecordedEntry::kHead:
      return "a second head";
    case wire::RecordedEntry::kWorld:
      return problem_of(entry_.world());
    case wire::RecordedEntry::kEmbodied:
      bodies_.push_back(entry_.embodied());
      return problem_of(entry_.embodied().robot(), entry_.embodied().pose());
    case wire::RecordedEntry::kCycle:
      ++cycles_;
      return problem_of(entry_.cycle());
    case wire::RecordedEntry::kEnd:
      has_ended = true;
      if (entry_.end().cycles() == cycles_) return std::nullopt;
      return fmt::format("the end speaks of {} cycles, and {} stand before it", entry_.end().cycles(),
                         cycles_);
    case wire::RecordedEntry::BODY_NOT_SET:
      break;
  }
  return "an entry of a kind that is not known";
}

const wire::RecordedEntry* PerceptsReader::peek() {
  if (!has_next_) {
    // All has been looked through; a file that was changed since ends here.
    if (static_cast<std::uint64_t>(in_.tellg()) >= end_ || read_entry()) return nullptr;
    has_next_ = true;
  }
  return &entry_;
}

}  // namespace mlab::recording
