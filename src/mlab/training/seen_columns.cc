#include "mlab/training/seen_columns.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/flow/type_words.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/shown.h"
#include "mlab/text/wildcard.h"

namespace mlab::training {
namespace {

using flow::TypeKind;

static_assert(sizeof(geom::Vector) == 3 * sizeof(double) && sizeof(geom::Point) == 2 * sizeof(double) &&
              sizeof(geom::Pose) == 3 * sizeof(double));

// The numbers that a value consists of, in the order in which they lie in a frame.
std::span<const std::string_view> parts_of(TypeKind kind) {
  static constexpr std::array<std::string_view, 3> kVector = {".x", ".y", ".z"};
  static constexpr std::array<std::string_view, 3> kPose = {".x", ".y", ".heading"};
  static constexpr std::array<std::string_view, 1> kWhole = {""};
  if (kind == TypeKind::kVector) return kVector;
  if (kind == TypeKind::kPoint) return std::span(kVector).first(2);
  if (kind == TypeKind::kPose) return kPose;
  return kWhole;
}

bool is_number(TypeKind kind) {
  return kind != TypeKind::kText && kind != TypeKind::kList && kind != TypeKind::kOther;
}

// Beams stand evenly all round, or from one end of an arc to the other.
double angle_of(const binding::RangeRing& ring, std::size_t beam) {
  const double between =
      ring.arc > 0.0 ? ring.arc / std::max(1, ring.count - 1) : 2.0 * std::numbers::pi / ring.count;
  return base::wrap_angle(ring.first_angle + static_cast<double>(beam) * between);
}

std::string unit_of(const flow::Port& port, std::string_view part) {
  if (part == ".heading") return "rad";
  return port.type->kind == TypeKind::kPose ? "m" : port.unit;
}

}  // namespace

std::string no_such_port(const flow::Program& program, const std::string& name) {
  std::vector<std::string> names;
  for (const flow::Port& port : program.ports()) names.push_back(port.path);
  const std::string near = text::nearest_name(name, names);
  return fmt::format("the program `{}` has no port `{}`{}", text::shown(program.name()), text::shown(name),
                     near.empty() ? "" : fmt::format("; did you mean `{}`?", near));
}

void SeenColumns::add(std::string name, const std::string& unit, std::string help, const Source& source) {
  columns_.push_back({std::move(name), unit, std::move(help)});
  sources_.push_back(source);
}

bool SeenColumns::add_body(const std::string& name, const binding::RangeRing& ring) {
  const bool is_pose = name == "body.pose";
  const std::size_t before = columns_.size();
  if (is_pose || name == "body.x") add("body.x", "m", "east of the world's origin", {Kind::kX});
  if (is_pose || name == "body.y") add("body.y", "m", "north of it", {Kind::kY});
  if (is_pose || name == "body.heading")
    add("body.heading", "rad", "counter-clockwise from east", {Kind::kHeading});
  if (name == "body.contacts") add("body.contacts", "", "how often it met something", {Kind::kContacts});
  if (name == "body.driven") add("body.driven", "m", "since it was there", {Kind::kDriven});
  if (name == "body.ranges" && ring.count > 0) {
    for (std::size_t i = 0; i < ring.count; ++i)
      columns_.push_back({fmt::format("body.ranges.{}", i), "m",
                          fmt::format("from the body's surface to what is met at {:.6g} rad from ahead, "
                                      "counter-clockwise",
                                      angle_of(ring, i)),
                          0.0, ring.range});
    sources_.push_back({Kind::kRanges});
    beams_ = ring.count;
    wants_ranges_ = true;
  }
  if (columns_.size() == before) return false;
  wants_body_ |= name != "body.ranges";
  return true;
}

std::size_t SeenColumns::add_ports(const flow::Program& program, const std::string& pattern) {
  const std::size_t before = columns_.size();
  for (const flow::Port& port : program.ports()) {
    if (!is_number(port.type->kind)) continue;
    const auto parts = parts_of(port.type->kind);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      std::string name = port.path + std::string(parts[i]);
      if (!text::matches(port.path, pattern) && !text::matches(name, pattern)) continue;
      const bool is_real = port.type->kind == TypeKind::kReal || parts.size() > 1;
      const auto offset = static_cast<std::uint32_t>(port.offset + i * sizeof(double));
      add(std::move(name), unit_of(port, parts[i]), port.help,
          {is_real ? Kind::kReal : Kind::kNumber, offset, &port});
    }
  }
  return columns_.size() - before;
}

std::expected<SeenColumns, std::string> SeenColumns::of(const flow::Program& program,
                                                        std::span<const std::string> wanted,
                                                        const binding::RangeRing& ring) {
  SeenColumns out;
  for (const std::string& name : wanted) {
    if (out.add_ports(program, name) > 0 || out.add_body(name, ring)) continue;
    if (name == "body.ranges")
      return std::unexpected("`body.ranges`: the robot has no ring of range sensors");
    const flow::Port* const port = program.find(name);
    if (port == nullptr && name.starts_with("body."))
      return std::unexpected(
          fmt::format("`{}`: of a body there are body.pose, body.x, body.y, body.heading, body.contacts, "
                      "body.driven and body.ranges",
                      text::shown(name)));
    if (port == nullptr) return std::unexpected(no_such_port(program, name));
    if (is_number(port->type->kind)) {  // found by another one of its names
      out.add_ports(program, port->path);
      continue;
    }
    return std::unexpected(
        fmt::format("`{}` is {}, and no number", text::shown(name), flow::value_of(*port->type)));
  }
  return out;
}

double* SeenColumns::read_beams(std::span<const percept::RangeReading> beams, double* row) const {
  const std::size_t count = std::min(beams_, beams.size());
  for (std::size_t i = 0; i < count; ++i) row[i] = beams[i].distance;
  std::fill(row + count, row + beams_, std::numeric_limits<double>::quiet_NaN());
  return row + beams_;
}

void SeenColumns::read(const std::byte* frame, const SeenBody& body, double* row) const {
  for (const Source& source : sources_) {
    switch (source.kind) {
      case Kind::kReal:
        std::memcpy(row++, frame + source.offset, sizeof(double));
        break;
      case Kind::kNumber:
        *row++ = flow::Program::number(frame, *source.port).value_or(0.0);
        break;
      case Kind::kX:
        *row++ = body.pose.position.x;
        break;
      case Kind::kY:
        *row++ = body.pose.position.y;
        break;
      case Kind::kHeading:
        *row++ = body.pose.heading;
        break;
      case Kind::kContacts:
        *row++ = body.contacts;
        break;
      case Kind::kDriven:
        *row++ = body.driven;
        break;
      case Kind::kRanges:
        row = read_beams(body.ranges, row);
        break;
    }
  }
}

}  // namespace mlab::training
