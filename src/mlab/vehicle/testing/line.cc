#include "mlab/vehicle/testing/line.h"

#include <algorithm>

namespace mlab::vehicle {
namespace {

constexpr std::size_t kLongestPiece = 64;
constexpr std::size_t kLongestRead = 4096;
/// What a byte takes at 57,600 bit/s.
constexpr auto kByte = std::chrono::microseconds(174);
constexpr auto kOpensAfter = std::chrono::milliseconds(500);

}  // namespace

/// As a stream over a real line: it notices by itself that the line is gone or back.
class TestLine::DeviceEnd final : public Stream {
 public:
  explicit DeviceEnd(TestLine& line) : line_(line) {}

  const std::string& name() const override { return name_; }
  bool is_open() const override { return is_open_; }
  const std::string& why() const override { return is_open_ ? nothing_ : why_; }
  std::uint64_t openings() const override { return openings_; }
  std::span<const std::byte> read(Clock::time_point now) override {
    look(now);
    got_ = is_open_ ? line_.take(line_.to_device_, now) : std::string{};
    return std::as_bytes(std::span(got_));
  }
  bool write(std::span<const std::byte> bytes, Clock::time_point now) override {
    if (!is_open_) return false;
    line_.put(line_.to_vehicle_, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, now);
    return true;
  }
  void begin_anew(Clock::time_point) override { is_open_ = false; }

 private:
  void look(Clock::time_point now) {
    const bool is_there = line_.state_ != State::kGone && now - line_.mended_at_ >= kOpensAfter;
    if (is_there && !is_open_) ++openings_;
    is_open_ = is_there;
  }

  TestLine& line_;
  bool is_open_ = false;
  std::uint64_t openings_ = 0;
  std::string got_;
  const std::string name_ = "serial:test:115200";
  const std::string why_ = "can't be opened: No such file or directory";
  const std::string nothing_;
};

std::unique_ptr<Stream> TestLine::device_end() {
  return std::make_unique<DeviceEnd>(*this);
}

Clock::duration TestLine::time_of(std::size_t bytes) const {
  return kind_ == Kind::kSerial ? kByte * bytes : Clock::duration{0};
}

void TestLine::put(Way& way, std::string_view bytes, Clock::time_point now) {
  if (is_cut()) return;
  while (!bytes.empty()) {
    const std::size_t piece = 1 + random_.below(kLongestPiece);
    const std::size_t length =
        kind_ == Kind::kSerial ? std::min<std::size_t>(bytes.size(), piece) : bytes.size();
    const Clock::time_point behind = way.empty() ? now : way.back().arrives;
    if (random_.uniform() >= impairment_.loss)
      way.push_back({std::max(now + impairment_.delay, behind) + time_of(length),
                     std::string(bytes.substr(0, length))});
    bytes.remove_prefix(length);
  }
}

void TestLine::release(Clock::time_point now) {
  is_held_back_ = false;
  for (Way* const way : {&to_vehicle_, &to_device_}) {
    Clock::time_point free = now;
    for (Piece& piece : *way) {
      free += time_of(piece.bytes.size());
      piece.arrives = std::max(piece.arrives, free);
    }
  }
}

std::string TestLine::take(Way& way, Clock::time_point now) const {
  std::string taken;
  while (!is_held_back_ && !way.empty() && way.front().arrives <= now && taken.size() < kLongestRead) {
    taken += way.front().bytes;
    way.pop_front();
  }
  return taken;
}

void TestLine::cut(Cut how) {
  state_ = how == Cut::kSilence || how == Cut::kRestart ? State::kSilent : State::kGone;
  to_vehicle_.clear();
  to_device_.clear();
}

void TestLine::mend(Clock::time_point now) {
  if (state_ == State::kGone) mended_at_ = now;
  state_ = State::kWhole;
}

}  // namespace mlab::vehicle
