#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mlab/percept/needs.h"
#include "mlab/percept/percepts.h"
#include "mlab/robot.pb.h"

namespace mlab::robot_wire {

void encode(const percept::Needs& needs, wire::Needs& out);
/// As it stands there: a reach may be infinite.
percept::Needs needs_of(const wire::Needs& message);

/// Writes everything that a robot perceives; `out` loses what it held, and keeps its memory.
void encode(const percept::Percepts& percepts, wire::Percepts& out);

/// Percepts out of a message, with the lists that they are views of. Used again and again, it needs no new
/// memory.
class DecodedPercepts {
 public:
  DecodedPercepts() = default;
  DecodedPercepts(const DecodedPercepts&) = delete;  // the views would stay behind
  DecodedPercepts& operator=(const DecodedPercepts&) = delete;
  DecodedPercepts(DecodedPercepts&&) = delete;
  DecodedPercepts& operator=(DecodedPercepts&&) = delete;
  ~DecodedPercepts() = default;

  /// @errors  a sentence that names what does not fit: columns of different lengths, a number that stands for
  ///          nothing; the percepts are then not to be used
  std::optional<std::string> decode(const wire::Percepts& message);
  /// Valid until the next `decode`.
  const percept::Percepts& percepts() const { return percepts_; }

 private:
  std::optional<std::string> decode_readings(const wire::Percepts& message);
  std::optional<std::string> decode_radio(const wire::Radio& radio);
  std::optional<std::string> decode_order(const wire::Order& message);
  std::optional<std::string> decode_messages(const wire::Percepts& message);
  std::optional<std::string> decode_ground(const wire::Ground& message);
  std::optional<std::string> decode_map(const wire::SiteMap& message);

  percept::Percepts percepts_;
  std::vector<percept::Obstacle> obstacles_;
  std::vector<percept::RobotReading> robots_;
  std::vector<percept::ObjectReading> objects_;
  std::vector<percept::RangeReading> ranges_;
  std::vector<percept::RadioContact> radio_;
  std::vector<geom::Point> route_;
  std::vector<std::uint64_t> notifications_;
  std::vector<percept::SharedPlace> shared_places_;
  std::vector<percept::AskedPassage> asked_passages_;
  std::vector<percept::Claim> claims_;
  std::vector<percept::Contract> contracts_;
  std::vector<percept::Door> doors_;
  std::vector<std::vector<geom::Point>> outlines_;
  std::vector<percept::Room> rooms_;
  std::vector<percept::Hallway> hallways_;
  std::vector<ways::Round> discs_;
  std::vector<geom::Segment> walls_;
};

}  // namespace mlab::robot_wire
