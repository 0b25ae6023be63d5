#include "mlab/keys/documents.h"

#include <chrono>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "mlab/dds/network.h"

namespace mlab::keys {
namespace {

/// All that Cyclone can name: a participant is a domain of its own in its process, whose number means nothing
/// outside. What keeps fleets apart is their authority, and the partition.
constexpr const char* kAllDomains = "<domains><id_range><min>0</min><max>230</max></id_range></domains>";

/// UTC, as XML has it.
std::string time_of(std::int64_t seconds) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}Z", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

std::string topics_in(const std::string& fleet) {
  return fmt::format(
      "<topics><topic>mlab/*</topic></topics><partitions><partition>{}</partition></partitions>",
      dds::partition_of(fleet));
}

}  // namespace

/// Whole packets are encrypted, with one key for each participant, and nothing in them a second time. With
/// keys for each topic, and others for what is in its messages, some ten of them pass between any two
/// participants before they can talk, and fifty that join at once do little else; and all members may say and
/// hear everything, so such keys would keep nothing from anybody. Topics still say that their discovery and
/// liveliness are protected: what is not goes by endpoints of Cyclone's whose packets are never encrypted.
std::string governance() {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
      "<dds><domain_access_rules><domain_rule>{}\n"
      "<allow_unauthenticated_participants>false</allow_unauthenticated_participants>\n"
      "<enable_join_access_control>true</enable_join_access_control>\n"
      "<discovery_protection_kind>NONE</discovery_protection_kind>\n"
      "<liveliness_protection_kind>NONE</liveliness_protection_kind>\n"
      "<rtps_protection_kind>ENCRYPT</rtps_protection_kind>\n"
      "<topic_access_rules><topic_rule><topic_expression>*</topic_expression>\n"
      "<enable_discovery_protection>true</enable_discovery_protection>\n"
      "<enable_liveliness_protection>true</enable_liveliness_protection>\n"
      "<enable_read_access_control>true</enable_read_access_control>\n"
      "<enable_write_access_control>true</enable_write_access_control>\n"
      "<metadata_protection_kind>NONE</metadata_protection_kind>\n"
      "<data_protection_kind>NONE</data_protection_kind>\n"
      "</topic_rule></topic_access_rules></domain_rule></domain_access_rules></dds>\n",
      kAllDomains);
}

std::string permissions(const std::string& subject, const std::string& fleet, const Validity& validity) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
      "<dds><permissions><grant name=\"member\"><subject_name>{}</subject_name>\n"
      "<validity><not_before>{}</not_before><not_after>{}</not_after></validity>\n"
      "<allow_rule>{}<publish>{}</publish>\n<subscribe>{}</subscribe></allow_rule>\n"
      "<default>DENY</default></grant></permissions></dds>\n",
      subject, time_of(validity.begin), time_of(validity.end), kAllDomains, topics_in(fleet),
      topics_in(fleet));
}

}  // namespace mlab::keys
