#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fastdds/rtps/common/WriteParams.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include "message_type.h"
#include "messages.h"

namespace mlab::ros2_robot {

/// How a topic is written or read, by the conventions of ROS 2.
struct Quality {
  bool is_reliable = true;
  bool is_kept = false;  ///< for who comes later (transient local)
  int depth = 10;
};
inline constexpr Quality kSensorData{.is_reliable = false, .depth = 5};
inline constexpr Quality kLatched{.is_kept = true, .depth = 1};

/// Of a message: who wrote it, and his number of it.
using Identity = eprosima::fastrtps::rtps::SampleIdentity;

template <class Message>
class Publication {
 public:
  explicit Publication(eprosima::fastdds::dds::DataWriter* writer) : writer_(writer) {}
  void write(Message& message) { writer_->write(&message); }
  /// @param related  goes beside the message: what it answers, or where an answer is to go
  /// @return  what it is called itself
  Identity write(Message& message, const Identity& related) {
    eprosima::fastrtps::rtps::WriteParams about;
    about.related_sample_identity(related);
    writer_->write(&message, about);
    return about.sample_identity();
  }
  bool has_readers() const {
    eprosima::fastdds::dds::PublicationMatchedStatus status;
    writer_->get_publication_matched_status(status);
    return status.current_count > 0;
  }

 private:
  eprosima::fastdds::dds::DataWriter* writer_;
};

template <class Message>
class Subscription {
 public:
  explicit Subscription(eprosima::fastdds::dds::DataReader* reader) : reader_(reader) {}
  /// @return  false: there is none left
  bool take(Message& message) {
    eprosima::fastdds::dds::SampleInfo info;
    return take(message, info);
  }
  bool take(Message& message, eprosima::fastdds::dds::SampleInfo& info) {
    while (reader_->take_next_sample(&message, &info) ==
           eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
      if (info.valid_data) return true;
    }
    return false;
  }
  bool has_writers() const {
    eprosima::fastdds::dds::SubscriptionMatchedStatus status;
    reader_->get_subscription_matched_status(status);
    return status.current_count > 0;
  }
  const eprosima::fastrtps::rtps::GUID_t& guid() const { return reader_->guid(); }

 private:
  eprosima::fastdds::dds::DataReader* reader_;
};

/// One node of ROS 2 in a domain, on the loopback alone: UDP, no shared memory. Endpoints live as long as it.
class Participant {
 public:
  /// @param node_namespace  such as `/veh1`; empty: none
  /// @errors  std::runtime_error: Fast DDS refuses
  Participant(int domain, const std::string& node_namespace, const std::string& name);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// @param topic  its name in DDS, such as `rt/veh1/odom`
  /// @param more   of USER_DATA, besides the type's hash
  template <class Message>
  Publication<Message> publish(const std::string& topic, const Quality& quality, std::string_view more = "") {
    return Publication<Message>(
        make_writer(add_topic(topic, new MessageType<Message>), quality, user_data(Message::kHash, more)));
  }
  template <class Message>
  Subscription<Message> subscribe(const std::string& topic, const Quality& quality,
                                  std::string_view more = "") {
    return Subscription<Message>(
        make_reader(add_topic(topic, new MessageType<Message>), quality, user_data(Message::kHash, more)));
  }
  /// Tells of all endpoints made so far, for `ros2 node list`. Once.
  void introduce();
  /// Unlike those of other participants.
  Gid gid() const;

 private:
  static std::string user_data(std::string_view hash, std::string_view more);
  /// @param type  is owned by the participant from here on
  eprosima::fastdds::dds::Topic* add_topic(const std::string& topic,
                                           eprosima::fastdds::dds::TopicDataType* type);
  eprosima::fastdds::dds::DataWriter* make_writer(eprosima::fastdds::dds::Topic* topic,
                                                  const Quality& quality, const std::string& told);
  eprosima::fastdds::dds::DataReader* make_reader(eprosima::fastdds::dds::Topic* topic,
                                                  const Quality& quality, const std::string& told);

  std::string namespace_;
  std::string name_;
  eprosima::fastdds::dds::DomainParticipant* participant_ = nullptr;
  eprosima::fastdds::dds::Publisher* publisher_ = nullptr;
  eprosima::fastdds::dds::Subscriber* subscriber_ = nullptr;
  std::vector<GidMessage> readers_;
  std::vector<GidMessage> writers_;
};

}  // namespace mlab::ros2_robot
