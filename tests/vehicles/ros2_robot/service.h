#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "action_messages.h"
#include "participant.h"

namespace mlab::ros2_robot {

/// How requests and replies find each other.
enum class Services : std::uint8_t {
  kPlain,   ///< as rmw_fastrtps has it: by what stands beside a message, its inline QoS
  kHeaded,  ///< as rmw_cyclonedds has it: by what stands before its struct
};

/// A request, and by what its client knows the reply.
template <class Request>
struct Asked {
  Request body;
  Identity identity = {};  // kPlain
  std::uint64_t guid = 0;  // kHeaded
  std::int64_t sequence = 0;
};

/// A service of ROS 2, its server.
template <class Request, class Response>
class Service {
 public:
  /// @param name  with its namespace: `/veh1/navigate_to_pose/_action/send_goal`
  /// @param id    tells services of a participant apart
  Service(Participant& participant, const std::string& name, Services services, std::uint8_t id) {
    const std::string asked = "rq" + name + "Request";
    const std::string told = "rr" + name + "Reply";
    if (services == Services::kPlain) {
      requests_.emplace(participant.subscribe<Request>(asked, {}));
      replies_.emplace(participant.publish<Response>(told, {}));
      return;
    }
    const std::string words = service_id(participant.gid(), id);
    headed_requests_.emplace(participant.subscribe<Call<Request>>(asked, {}, words));
    headed_replies_.emplace(participant.publish<Call<Response>>(told, {}, words));
  }

  /// @return  false: there is none left
  bool take(Asked<Request>& asked) { return requests_ ? take_plain(asked) : take_headed(asked); }
  void reply(const Asked<Request>& to, const Response& body) {
    if (replies_) {
      Response out = body;
      replies_->write(out, to.identity);
      return;
    }
    Call<Response> out{to.guid, to.sequence, body};
    headed_replies_->write(out);
  }

 private:
  /// Who says beside his request which reader the reply is for is called by that, as rmw_fastrtps's clients
  /// are; others by who wrote it.
  bool take_plain(Asked<Request>& asked) {
    eprosima::fastdds::dds::SampleInfo info;
    if (!requests_->take(asked.body, info)) return false;
    asked.identity = info.sample_identity;
    const auto& reader = info.related_sample_identity.writer_guid();
    if (reader != eprosima::fastrtps::rtps::GUID_t::unknown()) asked.identity.writer_guid(reader);
    return true;
  }
  bool take_headed(Asked<Request>& asked) {
    Call<Request> call;
    if (!headed_requests_->take(call)) return false;
    asked = {call.body, {}, call.guid, call.sequence};
    return true;
  }
  /// What rmw_cyclonedds tells of a service's endpoints, by which it knows that both of them are there.
  static std::string service_id(const Gid& gid, std::uint8_t id) {
    std::string out = "serviceid=";
    for (std::size_t i = 0; i < gid.size(); ++i)
      out += fmt::format("{}{:x}", i > 0 ? "." : "", i + 1 < gid.size() ? gid[i] : id);
    return out + ";";
  }

  std::optional<Subscription<Request>> requests_;
  std::optional<Publication<Response>> replies_;
  std::optional<Subscription<Call<Request>>> headed_requests_;
  std::optional<Publication<Call<Response>>> headed_replies_;
};

}  // namespace mlab::ros2_robot
