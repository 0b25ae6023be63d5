#include "keeper/veth.h"

#include <fcntl.h>
#include <linux/if_link.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <linux/veth.h>
#include <sys/socket.h>

#include <array>
#include <cstring>

#include "keeper/failure.h"

namespace mlab::network {
namespace {

/// A question to the kernel: bytes, in which attributes hold attributes.
class Request {
 public:
  Request(std::uint16_t type, int flags) {
    nlmsghdr header{};
    header.nlmsg_type = type;
    header.nlmsg_flags = static_cast<std::uint16_t>(NLM_F_REQUEST | NLM_F_ACK | flags);
    add(&header, sizeof header);
    add_interface();
  }

  void add_interface() {
    const ifinfomsg any{};
    add(&any, sizeof any);
  }
  void add_text(std::uint16_t type, const std::string& text) {
    within(type, [&] { add(text.c_str(), text.size() + 1); });
  }
  void add_number(std::uint16_t type, std::uint32_t number) {
    within(type, [&] { add(&number, sizeof number); });
  }
  // An attribute that holds what `content` adds.
  template <class Content>
  void within(std::uint16_t type, Content content) {
    const std::size_t begin = bytes_.size();
    rtattr header{0, type};
    add(&header, sizeof header);
    content();
    header.rta_len = static_cast<std::uint16_t>(bytes_.size() - begin);
    std::memcpy(bytes_.data() + begin, &header, sizeof header);
    bytes_.resize(RTA_ALIGN(bytes_.size()), '\0');
  }

  // @errors  Failure: the kernel's reason
  void ask(const Descriptor& netlink, const std::string& what) {
    const auto size = static_cast<std::uint32_t>(bytes_.size());
    std::memcpy(bytes_.data(), &size, sizeof size);  // nlmsg_len is the first
    check(::send(netlink.number(), bytes_.data(), bytes_.size(), 0) >= 0, what);
    alignas(nlmsghdr) std::array<char, 4096> answer{};
    check(::recv(netlink.number(), answer.data(), answer.size(), 0) >=
              static_cast<ssize_t>(NLMSG_LENGTH(sizeof(nlmsgerr))),
          what);
    nlmsgerr end{};
    std::memcpy(&end, answer.data() + NLMSG_HDRLEN, sizeof end);
    errno = -end.error;
    check(end.error == 0, what);
  }

 private:
  void add(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }

  std::string bytes_;
};

}  // namespace

Descriptor open_netlink() {
  Descriptor out(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE));
  check(out.is_open(), "making a netlink socket");
  return out;
}

void make_veth_pair(const Descriptor& netlink, const std::string& name, const std::string& other) {
  Request request(RTM_NEWLINK, NLM_F_CREATE | NLM_F_EXCL);
  request.add_text(IFLA_IFNAME, name);
  request.within(IFLA_LINKINFO, [&] {
    request.add_text(IFLA_INFO_KIND, "veth");
    request.within(IFLA_INFO_DATA, [&] {
      request.within(VETH_INFO_PEER, [&] {
        request.add_interface();
        request.add_text(IFLA_IFNAME, other);
      });
    });
  });
  request.ask(netlink, "making a veth");
}

void set_queue(const Descriptor& netlink, const std::string& name, std::uint32_t frames) {
  Request request(RTM_NEWLINK, 0);
  request.add_text(IFLA_IFNAME, name);
  request.add_number(IFLA_TXQLEN, frames);
  request.ask(netlink, "setting the queue of " + name);
}

void move_here(const Descriptor& netlink, const std::string& name) {
  const Descriptor here(::open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC));
  check(here.is_open(), "opening /proc/self/ns/net");
  Request request(RTM_NEWLINK, 0);
  request.add_text(IFLA_IFNAME, name);
  request.add_number(IFLA_NET_NS_FD, static_cast<std::uint32_t>(here.number()));
  request.ask(netlink, "moving a veth");
}

}  // namespace mlab::network
