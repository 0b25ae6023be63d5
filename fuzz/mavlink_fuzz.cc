// Whatever a vehicle sends, in pieces, each preceded by its length and by how many hundredths of a second
// pass before it. With the first bit of the input what is missing for a checksum is mended, so that messages
// get through; with the second a key is set. Frames are whole, the device reports numbers only, nothing of
// the future, and its vehicle never hears that it is to be faster than its limits.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mlab/mavlink/ardupilot.h"
#include "mlab/mavlink/frame.h"
#include "mlab/mavlink/rover_device.h"

namespace {

using namespace mlab;
using Time = vehicle::Clock::time_point;

void fail(const char* why) {
  std::fprintf(stderr, "%s\n", why);
  std::abort();
}

// What it is fed with, and who looks at what it sends.
class Script final : public vehicle::Stream {
 public:
  const std::string& name() const override { return name_; }
  bool is_open() const override { return true; }
  const std::string& why() const override { return why_; }
  std::uint64_t openings() const override { return openings_; }
  std::span<const std::byte> read(Time /*now*/) override {
    last_ = std::move(next);
    next.clear();
    return last_;
  }
  bool write(std::span<const std::byte> bytes, Time /*now*/) override {
    reader_.feed(bytes);
    const auto frame = reader_.next();
    if (!frame) fail("what it sends is no frame");
    if (!frame->is<mavlink::SetPositionTargetLocalNed>()) return true;
    const auto message = frame->as<mavlink::SetPositionTargetLocalNed>();
    if (!(std::abs(message.vx) <= 1.0F) || !(std::abs(message.yaw_rate) <= 0.5F))
      fail("it is told to be too fast");
    return true;
  }
  void begin_anew(Time /*now*/) override { ++openings_; }

  std::vector<std::byte> next;

 private:
  std::string name_ = "fuzz";
  std::string why_;
  std::uint64_t openings_ = 1;
  std::vector<std::byte> last_;
  mavlink::FrameReader reader_;
};

// Gives what looks like the begin of a frame of ours the checksum that it needs.
void mend(std::vector<std::byte>& bytes) {
  if (bytes.size() < 12 || bytes[0] != std::byte{0xfd}) return;
  bytes[2] = std::byte{0};
  bytes[6] = std::byte{1};
  const auto id = static_cast<std::uint32_t>(bytes[7]) | static_cast<std::uint32_t>(bytes[8]) << 8U |
                  static_cast<std::uint32_t>(bytes[9]) << 16U;
  const auto extra = mavlink::extra_of(id);
  const std::size_t length = std::min<std::size_t>(bytes.size() - 12, 255);
  if (!extra) return;
  bytes.resize(10 + length);
  bytes[1] = static_cast<std::byte>(length);
  mavlink::wire::put(bytes, mavlink::checksum(std::span(bytes).subspan(1), *extra));
}

void look_at(const vehicle::Report& report, Time now) {
  if (report.readiness != vehicle::Readiness::kReady && report.why.empty()) fail("nobody knows why");
  if (report.motion) {
    const vehicle::Motion& is = *report.motion;
    if (!std::isfinite(is.pose.position.x + is.pose.position.y + is.pose.heading + is.speed + is.turn_rate))
      fail("it moves by no number");
    if (is.at > now) fail("it knows the future");
  }
  if (report.fix) {
    const vehicle::Fix& is = *report.fix;
    if (!(std::abs(is.place.latitude_deg) <= 90.0 && std::abs(is.place.longitude_deg) <= 180.0) ||
        !std::isfinite(is.point.x + is.point.y) || is.at > now)
      fail("it is nowhere on the Earth");
  }
  if (report.battery && !(report.battery->share >= 0.0 && report.battery->share <= 1.0))
    fail("more than all");
  if (report.scans.size() > 9) fail("too many scans");
  for (const vehicle::Scan& one : report.scans) {
    if (one.distances.empty() || one.distances.size() > 72 || one.at > now) fail("it is no scan");
    if (!std::isfinite(one.first_angle + one.step + one.beam_width + one.mount.heading))
      fail("a scan of nowhere");
    for (const float distance : one.distances) {
      if (distance < 0.0F || (std::isfinite(distance) && distance > 656.0F)) fail("a distance that can't be");
    }
  }
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  if (size == 0) return 0;
  const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
  mavlink::RoverSettings settings;
  settings.limits.kinematics.max_speed = 1.0;
  settings.limits.kinematics.max_turn_rate = 0.5;
  settings.limits.min_speed = -1.0;
  settings.writes_parameters = true;
  settings.signing_clock = [] { return mavlink::SigningTime{1}; };
  if ((data[0] & 2U) != 0) settings.key = mavlink::Key{};
  auto stream = std::make_unique<Script>();
  Script& script = *stream;
  mavlink::RoverDevice device(std::move(stream), settings);
  Time now{std::chrono::hours(1)};
  for (std::size_t at = 1; at + 2 <= bytes.size();) {
    const std::size_t length = std::min<std::size_t>(data[at], bytes.size() - at - 2);
    now += std::chrono::milliseconds(10 * data[at + 1]);
    const auto piece = bytes.subspan(at + 2, length);
    script.next.assign(piece.begin(), piece.end());
    if ((data[0] & 1U) != 0) mend(script.next);
    at += 2 + length;
    device.work(now);
    look_at(device.report(now), now);
    if (data[at - 1] % 7 == 0)
      device.stop(now);
    else if (data[at - 1] % 11 == 0)
      device.stop_in_emergency(now);
    else if (data[at - 1] % 13 == 0)
      device.engage(now);
    else
      device.drive({static_cast<double>(length), -3.0}, now);
    if (device.take_notes().size() > 32 || device.parameters().size() > 16) fail("it keeps too much");
  }
  return 0;
}
