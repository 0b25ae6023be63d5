#include "participant.h"

#include <stdexcept>

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

namespace mlab::ros2_robot {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

constexpr const char* kLoopback = "127.0.0.1";
constexpr const char* kGroup = "239.255.0.1";  // where participants are looked for
constexpr std::uint32_t kMostParticipants = 32;

template <class Pointer>
Pointer made(Pointer what, const std::string& name) {
  if (what == nullptr) throw std::runtime_error("Fast DDS makes no " + name);
  return what;
}

rtps::Locator_t at(const char* address) {
  rtps::Locator_t out;
  rtps::IPLocator::setIPv4(out, address);
  return out;
}

std::vector<rtps::octet> bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

dds::DomainParticipantQos loopback_only(const std::string& name) {
  dds::DomainParticipantQos qos;
  qos.name(name);
  // With the 0 at its end, as rmw_fastrtps_cpp has it.
  qos.user_data().setValue(bytes_of(std::string("enclave=/;") + '\0'));
  const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {kLoopback};
  udp->maxInitialPeersRange = kMostParticipants;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports = {udp};
  rtps::BuiltinAttributes& builtin = qos.wire_protocol().builtin;
  builtin.initialPeersList.push_back(at(kLoopback));
  builtin.initialPeersList.push_back(at(kGroup));
  builtin.discovery_config.leaseDuration_announcementperiod = {1, 0};
  return qos;
}

template <class Qos>
void set(Qos& qos, const Quality& quality, const std::string& told) {
  qos.reliability().kind =
      quality.is_reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind =
      quality.is_kept ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = quality.depth;
  qos.data_sharing().off();
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.user_data().setValue(bytes_of(told));
}

GidMessage gid_of(const rtps::GUID_t& guid) {
  GidMessage out;
  std::copy(guid.guidPrefix.value, guid.guidPrefix.value + 12, out.data.begin());
  std::copy(guid.entityId.value, guid.entityId.value + 4, out.data.begin() + 12);
  return out;
}

}  // namespace

Participant::Participant(int domain, const std::string& node_namespace, const std::string& name)
    : namespace_(node_namespace.empty() ? "/" : node_namespace), name_(name) {
  dds::DomainParticipantFactory* factory = dds::DomainParticipantFactory::get_instance();
  participant_ = made(factory->create_participant(static_cast<dds::DomainId_t>(domain), loopback_only(name)),
                      "participant");
  publisher_ = made(participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT), "publisher");
  subscriber_ = made(participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT), "subscriber");
}

Participant::~Participant() {
  if (participant_ == nullptr) return;
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

std::string Participant::user_data(std::string_view hash, std::string_view more) {
  const std::string out = hash.empty() ? "" : "typehash=RIHS01_" + std::string(hash) + ";";
  return out + std::string(more);
}

dds::Topic* Participant::add_topic(const std::string& topic, dds::TopicDataType* type) {
  const dds::TypeSupport support(type);
  support.register_type(participant_);
  return made(participant_->create_topic(topic, type->getName(), dds::TOPIC_QOS_DEFAULT), "topic " + topic);
}

dds::DataWriter* Participant::make_writer(dds::Topic* topic, const Quality& quality,
                                          const std::string& told) {
  dds::DataWriterQos qos;
  set(qos, quality, told);
  qos.publish_mode().kind = dds::ASYNCHRONOUS_PUBLISH_MODE;
  qos.writer_data_lifecycle().autodispose_unregistered_instances = false;
  dds::DataWriter* out = made(publisher_->create_datawriter(topic, qos), "writer of " + topic->get_name());
  writers_.push_back(gid_of(out->guid()));
  return out;
}

dds::DataReader* Participant::make_reader(dds::Topic* topic, const Quality& quality,
                                          const std::string& told) {
  dds::DataReaderQos qos;
  set(qos, quality, told);
  dds::DataReader* out = made(subscriber_->create_datareader(topic, qos), "reader of " + topic->get_name());
  readers_.push_back(gid_of(out->guid()));
  return out;
}

Gid Participant::gid() const {
  return gid_of(participant_->guid()).data;
}

void Participant::introduce() {
  ParticipantEntities told;
  told.gid.data = gid();
  told.nodes.push_back({namespace_, name_, readers_, writers_});
  // That which tells it is not of the node.
  publish<ParticipantEntities>("ros_discovery_info", kLatched).write(told);
}

}  // namespace mlab::ros2_robot
