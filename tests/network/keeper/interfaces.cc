#include "keeper/interfaces.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/ethtool.h>
#include <linux/if_packet.h>
#include <linux/if_tun.h>
#include <linux/sockios.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <net/route.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <utility>

#include "address.h"
#include "keeper/failure.h"
#include "keeper/veth.h"

namespace mlab::network {
namespace {

constexpr std::uint32_t kQueue = 10'000;  // frames that wait for the relay before the kernel drops some
constexpr int kReceiveBuffer = 16 * 1024 * 1024;  // the same for the socket of a veth, in bytes

/// An interface of this process's network namespace, as ioctl(2) asks for one.
class Interface {
 public:
  explicit Interface(std::string name)
      : name_(std::move(name)), socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    check(socket_.is_open(), "making a socket");
  }

  ifreq request() const {
    ifreq out{};
    std::copy_n(name_.c_str(), std::min<std::size_t>(name_.size(), IFNAMSIZ - 1), out.ifr_name);
    return out;
  }
  void ask(unsigned long what, void* request, const char* words) const {
    check(::ioctl(socket_.number(), what, request) == 0, words + (" of " + name_));
  }
  void set_flags(int flags) const {
    ifreq wanted = request();
    ask(SIOCGIFFLAGS, &wanted, "reading the flags");
    wanted.ifr_flags = static_cast<short>(wanted.ifr_flags | flags);
    ask(SIOCSIFFLAGS, &wanted, "setting the flags");
  }
  void set_address(unsigned long what, std::uint32_t address) const {
    ifreq wanted = request();
    sockaddr_in inet{};
    inet.sin_family = AF_INET;
    inet.sin_addr.s_addr = htonl(address);
    std::memcpy(&wanted.ifr_addr, &inet, sizeof inet);
    ask(what, &wanted, "setting the address");
  }
  void set_hardware_address(int host) const {
    ifreq wanted = request();
    wanted.ifr_hwaddr.sa_family = ARPHRD_ETHER;
    std::ranges::copy(hardware_address(host), reinterpret_cast<std::uint8_t*>(wanted.ifr_hwaddr.sa_data));
    ask(SIOCSIFHWADDR, &wanted, "setting the hardware address");
  }
  // Frames of a veth have neither checksums nor a size that fits, as long as its driver says that it sees to
  // it.
  void fill_in_checksums() const {
    ethtool_value value{ETHTOOL_STXCSUM, 0};
    ifreq wanted = request();
    wanted.ifr_data = reinterpret_cast<char*>(&value);
    ask(SIOCETHTOOL, &wanted, "setting the checksums");
  }
  void add_route_to_everywhere() {
    rtentry route{};
    for (sockaddr* address : {&route.rt_dst, &route.rt_gateway, &route.rt_genmask})
      address->sa_family = AF_INET;
    route.rt_flags = RTF_UP;
    route.rt_dev = name_.data();
    ask(SIOCADDRT, &route, "setting the route");
  }

 private:
  std::string name_;
  Descriptor socket_;
};

// What the relay does not know nobody shall send. Not there at all where the kernel has no IPv6.
void have_no_ipv6(const std::string& interface) {
  std::ofstream("/proc/sys/net/ipv6/conf/" + interface + "/disable_ipv6") << 1;
}

Descriptor make_tap() {
  Descriptor wire(::open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC));
  if (!wire.is_open()) return wire;
  ifreq wanted = Interface(kInterface).request();
  wanted.ifr_flags = IFF_TAP | IFF_NO_PI;
  if (::ioctl(wire.number(), TUNSETIFF, &wanted) != 0) return {};
  set_queue(open_netlink(), kInterface, kQueue);
  return wire;
}

Descriptor make_veth() {
  constexpr const char* kOtherEnd = "wire0";
  const Descriptor netlink = open_netlink();
  make_veth_pair(netlink, kInterface, kOtherEnd);
  have_no_ipv6(kOtherEnd);
  Interface(kInterface).fill_in_checksums();
  Interface(kOtherEnd).set_flags(IFF_UP | IFF_NOARP | IFF_PROMISC);
  Descriptor wire(::socket(AF_PACKET, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  check(wire.is_open(), "making a packet socket");
  const int yes = 1;
  check(::setsockopt(wire.number(), SOL_PACKET, PACKET_IGNORE_OUTGOING, &yes, sizeof yes) == 0,
        "ignoring what the relay itself sends");
  if (::setsockopt(wire.number(), SOL_SOCKET, SO_RCVBUFFORCE, &kReceiveBuffer, sizeof kReceiveBuffer) != 0)
    ::setsockopt(wire.number(), SOL_SOCKET, SO_RCVBUF, &kReceiveBuffer, sizeof kReceiveBuffer);
  sockaddr_ll place{};
  place.sll_family = AF_PACKET;
  place.sll_protocol = htons(ETH_P_IP);
  place.sll_ifindex = static_cast<int>(::if_nametoindex(kOtherEnd));
  check(::bind(wire.number(), reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0,
        "binding a packet socket");
  // The host's own namespace; the one of the other end lives as long as the socket.
  check(::unshare(CLONE_NEWNET) == 0, "making a network namespace");
  move_here(netlink, kInterface);
  return wire;
}

}  // namespace

Descriptor make_interfaces(const KeeperSetup& setup) {
  Descriptor wire = setup.means.needs_veth ? Descriptor{} : make_tap();
  if (!wire.is_open()) {
    const std::string why =
        setup.means.needs_veth ? "" : "opening /dev/net/tun: " + std::generic_category().message(errno);
    try {
      wire = make_veth();
    } catch (const Failure& failure) {
      throw Failure(why.empty() ? failure.what() : why + "; instead of it " + failure.what());
    }
  }
  Interface("lo").set_flags(IFF_UP);
  have_no_ipv6(kInterface);
  Interface net(kInterface);
  net.set_hardware_address(setup.number);
  net.set_address(SIOCSIFADDR, kNetwork | static_cast<std::uint32_t>(setup.number));
  net.set_address(SIOCSIFNETMASK, 0xffffff00U);
  net.set_flags(IFF_UP | IFF_NOARP | IFF_MULTICAST);
  net.add_route_to_everywhere();
  return wire;
}

}  // namespace mlab::network
