#include "mlab/schema/requests.h"

#include <array>

namespace mlab::schema {

void alert(percept::Action& action, std::string_view subject, std::string_view message) {
  action.alert = {};
  std::size_t used = 0;
  const auto put = [&](std::string_view part) {
    used += part.copy(action.alert.data() + used, action.alert.size() - 1 - used);
  };
  put(subject);
  if (!subject.empty() && !message.empty()) put(": ");
  put(message);
}

std::uint64_t key_notification(char key) {
  const std::array<char, 5> name = {'K', 'E', 'Y', ' ', key};
  return base::hash_text({name.data(), name.size()});
}

}  // namespace mlab::schema
