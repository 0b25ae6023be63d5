#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <vector>

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastdds/dds/topic/TopicDataType.hpp>

namespace mlab::ros2_robot {

template <class T>
inline constexpr bool kIsList = false;
template <class T>
inline constexpr bool kIsList<std::vector<T>> = true;
/// What fastcdr knows by itself.
template <class T>
inline constexpr bool kIsPlain = std::is_arithmetic_v<T> || std::is_same_v<T, std::string>;
template <class T, std::size_t kCount>
inline constexpr bool kIsPlain<std::array<T, kCount>> = std::is_arithmetic_v<T>;

class CdrWriter {
 public:
  explicit CdrWriter(eprosima::fastcdr::Cdr& cdr) : cdr_(cdr) {}
  template <class... Members>
  void operator()(Members&... members) {
    (put(members), ...);
  }

 private:
  template <class Member>
  void put(Member& member) {
    if constexpr (kIsPlain<Member>) {
      cdr_ << member;
    } else if constexpr (kIsList<Member>) {
      cdr_ << static_cast<std::uint32_t>(member.size());
      for (auto& one : member) put(one);
    } else {
      pass(*this, member);
    }
  }
  eprosima::fastcdr::Cdr& cdr_;
};

class CdrReader {
 public:
  explicit CdrReader(eprosima::fastcdr::Cdr& cdr) : cdr_(cdr) {}
  template <class... Members>
  void operator()(Members&... members) {
    (get(members), ...);
  }

 private:
  template <class Member>
  void get(Member& member) {
    if constexpr (kIsPlain<Member>) {
      cdr_ >> member;
    } else if constexpr (kIsList<Member>) {
      std::uint32_t count = 0;
      cdr_ >> count;
      member.clear();
      // One by one: a count that is a lie ends where the bytes do.
      for (std::uint32_t i = 0; i < count; ++i) get(member.emplace_back());
    } else {
      pass(*this, member);
    }
  }
  eprosima::fastcdr::Cdr& cdr_;
};

/// How Fast DDS reads and writes a message: as plain CDR (XCDR1), little endian, without keys, and without
/// the descriptions of types that other vendors would compare.
template <class Message>
class MessageType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  MessageType() {
    setName(Message::kType);
    m_typeSize = kFirstSize;
    m_isGetKeyDefined = false;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }

  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->max_size);
    try {
      payload->length = write(buffer, data);
    } catch (const eprosima::fastcdr::exception::Exception&) {
      return false;
    }
    payload->encapsulation = CDR_LE;
    return true;
  }
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->length);
    eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                               eprosima::fastcdr::Cdr::DDS_CDR);
    try {
      cdr.read_encapsulation();
      CdrReader reader(cdr);
      pass(reader, *static_cast<Message*>(data));
    } catch (const eprosima::fastcdr::exception::Exception&) {
      return false;
    }
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] {
      eprosima::fastcdr::FastBuffer buffer;
      return write(buffer, data);
    };
  }
  void* createData() override { return new Message; }
  void deleteData(void* data) override { delete static_cast<Message*>(data); }
  bool getKey(void* /*data*/, eprosima::fastrtps::rtps::InstanceHandle_t* /*key*/, bool /*hash*/) override {
    return false;
  }

 private:
  static constexpr std::uint32_t kFirstSize = 2048;  // grows where a message is larger

  static std::uint32_t write(eprosima::fastcdr::FastBuffer& buffer, void* data) {
    eprosima::fastcdr::Cdr cdr(buffer, eprosima::fastcdr::Cdr::LITTLE_ENDIANNESS,
                               eprosima::fastcdr::Cdr::DDS_CDR);
    cdr.serialize_encapsulation();
    CdrWriter writer(cdr);
    pass(writer, *static_cast<Message*>(data));
    return static_cast<std::uint32_t>(cdr.getSerializedDataLength());
  }
};

}  // namespace mlab::ros2_robot
