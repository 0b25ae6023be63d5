#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "mlab/text/diagnostic.h"
#include "mlab/vehicle/device.h"

namespace mlab::vehicle {

/// Where a vehicle is to be reached.
///
///     serial:/dev/ttyUSB0:57600     a serial line, 8 bits, no parity, 1 stop bit, no flow control
///     tcp:192.168.1.7:5760          it listens there
///     udp:192.168.1.7:14555         it listens there
///     udp:14550                     it sends there: we listen, on this machine only
///     udp:0.0.0.0:14550             the same, on all of this machine's addresses
///     udp-listen:192.168.1.2:14550  the same, on one of them
///
/// Hosts are numbers (`192.168.1.7`, `[fd00::7]`) or `localhost`: to look a name up can take seconds.
struct Address {
  enum class Kind : std::uint8_t { kSerial, kTcp, kUdp, kUdpListening };
  Kind kind = Kind::kSerial;
  std::string place;         ///< the line's file, or a host in numbers
  std::uint32_t number = 0;  ///< the line's speed [bit/s], or a port

  friend bool operator==(const Address&, const Address&) = default;
};

/// Speeds of serial lines that an address may name [bit/s].
inline constexpr std::uint32_t kLineSpeeds[] = {1200,  2400,   4800,   9600,   19200,  38400,
                                                57600, 115200, 230400, 460800, 921600, 1500000};

/// @errors `vehicle-address`: says what was seen and what is expected
[[nodiscard]] text::Result<Address> parse_address(std::string_view text);
/// As it is written.
std::string print(const Address& address);

/// Bytes to and from one vehicle. Never blocks; opens by itself, and again whenever it was lost, twice a
/// second at most. All is called by one thread.
class Stream {
 public:
  Stream() = default;
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  virtual ~Stream() = default;

  /// Its address.
  virtual const std::string& name() const = 0;
  /// Whether bytes can come and go. A UDP port is open as soon as it is ours, whether or not anybody is
  /// there.
  virtual bool is_open() const = 0;
  /// Why it is not open, as a sentence without its subject: `can't be opened: No such file or directory`.
  virtual const std::string& why() const = 0;
  /// How often it has been opened, or begun to answer somebody else: when this changes, what was read so far
  /// is no begin of what comes.
  virtual std::uint64_t openings() const = 0;
  /// What has come next, at most 4096 bytes; of UDP one datagram. Empty: nothing, for now. Valid until the
  /// next call. Opens, where it is not open. A reader bounds how often it calls, for a sender may never
  /// pause.
  virtual std::span<const std::byte> read(Clock::time_point now) = 0;
  /// Sends all of it, as one datagram where there are datagrams. What a line can't take at once waits (at
  /// most 16384 bytes).
  /// @return  false: nothing of it was, or will be sent; it is not open, nobody is known yet, too much waits
  virtual bool write(std::span<const std::byte> bytes, Clock::time_point now) = 0;
  /// Gives up who is at the other end, who has been silent or makes no sense: a line or a
  /// connection is opened anew; where it listens on UDP, whoever speaks next is answered, and nobody else
  /// until this is called again.
  virtual void begin_anew(Clock::time_point now) = 0;
};

/// Opens nothing yet.
std::unique_ptr<Stream> make_stream(const Address& address);

}  // namespace mlab::vehicle
