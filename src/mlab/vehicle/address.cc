#include <arpa/inet.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "mlab/text/shown.h"
#include "mlab/vehicle/stream.h"

namespace mlab::vehicle {
namespace {

constexpr std::string_view kExpected =
    "expected `serial:FILE:SPEED`, `tcp:HOST:PORT`, `udp:HOST:PORT`, `udp:PORT` or `udp-listen:HOST:PORT`";

std::unexpected<text::Diagnostic> refuse(std::string message) {
  text::Diagnostic out;
  out.kind = "vehicle-address";
  out.message = std::move(message);
  return std::unexpected(std::move(out));
}

std::optional<std::uint32_t> number_of(std::string_view text) {
  std::uint32_t out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return out;
}

bool is_host(const std::string& text) {
  in_addr four{};
  in6_addr six{};
  return ::inet_pton(AF_INET, text.c_str(), &four) == 1 || ::inet_pton(AF_INET6, text.c_str(), &six) == 1;
}

text::Result<Address> parse_serial(std::string_view rest) {
  const std::size_t colon = rest.rfind(':');
  if (colon == std::string_view::npos || colon == 0)
    return refuse(fmt::format("`serial:{}`: expected a file and a speed: `serial:/dev/ttyUSB0:57600`",
                              text::shown(rest)));
  const auto speed = number_of(rest.substr(colon + 1));
  if (!speed || std::ranges::find(kLineSpeeds, *speed) == std::end(kLineSpeeds))
    return refuse(fmt::format("`{}` as speed of a serial line; expected one of {}",
                              text::shown(rest.substr(colon + 1)), fmt::join(kLineSpeeds, ", ")));
  return Address{Address::Kind::kSerial, std::string(rest.substr(0, colon)), *speed};
}

text::Result<Address> parse_socket(Address::Kind kind, std::string_view rest) {
  const std::size_t colon = rest.rfind(':');
  const bool only_port = kind == Address::Kind::kUdp && colon == std::string_view::npos;
  if (colon == std::string_view::npos && !only_port)
    return refuse(
        fmt::format("`{}` without a port; expected HOST:PORT, as `192.168.1.7:5760`", text::shown(rest)));
  const std::string_view digits = only_port ? rest : rest.substr(colon + 1);
  const auto port = number_of(digits);
  if (!port || *port == 0 || *port > 65535)
    return refuse(fmt::format("`{}` as port; expected a number from 1 to 65535", text::shown(digits)));
  if (only_port) return Address{Address::Kind::kUdpListening, "127.0.0.1", *port};
  std::string host(rest.substr(0, colon));
  if (host.size() > 2 && host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  if (host == "localhost") host = "127.0.0.1";
  if (!is_host(host))
    return refuse(fmt::format(
        "`{}` as host; expected its address in numbers, as `192.168.1.7` or `[fd00::7]`, or `localhost`",
        text::shown(host)));
  const bool is_any = host == "0.0.0.0" || host == "::";
  if (is_any && kind == Address::Kind::kTcp)
    return refuse(fmt::format("`{}` as host of a vehicle; expected the vehicle's own address", host));
  return Address{is_any ? Address::Kind::kUdpListening : kind, std::move(host), *port};
}

}  // namespace

text::Result<Address> parse_address(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view word = text.substr(0, colon);
  const std::string_view rest = colon == std::string_view::npos ? "" : text.substr(colon + 1);
  if (text.size() > 300 || text.find('\0') != std::string_view::npos)
    return refuse(fmt::format("`{}` as address of a vehicle; {}", text::shown(text), kExpected));
  if (word == "serial") return parse_serial(rest);
  if (word == "tcp") return parse_socket(Address::Kind::kTcp, rest);
  if (word == "udp") return parse_socket(Address::Kind::kUdp, rest);
  if (word == "udp-listen") return parse_socket(Address::Kind::kUdpListening, rest);
  return refuse(fmt::format("`{}` as address of a vehicle; {}", text::shown(text), kExpected));
}

std::string print(const Address& address) {
  const bool is_six = address.place.find(':') != std::string::npos;
  const std::string host = is_six ? "[" + address.place + "]" : address.place;
  switch (address.kind) {
    case Address::Kind::kSerial:
      return fmt::format("serial:{}:{}", address.place, address.number);
    case Address::Kind::kTcp:
      return fmt::format("tcp:{}:{}", host, address.number);
    case Address::Kind::kUdp:
      return fmt::format("udp:{}:{}", host, address.number);
    case Address::Kind::kUdpListening:
      if (host == "127.0.0.1") return fmt::format("udp:{}", address.number);
      if (host == "0.0.0.0" || host == "[::]") return fmt::format("udp:{}:{}", host, address.number);
      return fmt::format("udp-listen:{}:{}", host, address.number);
  }
  return {};
}

}  // namespace mlab::vehicle
