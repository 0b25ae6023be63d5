#include <array>

#include "mlab/tables/channel_tables.h"
#include "mlab/tables/class_tables.h"
#include "mlab/tables/failsafe_tables.h"
#include "mlab/tables/measure_tables.h"
#include "mlab/tables/regions.h"
#include "mlab/tables/sensor_tables.h"
#include "mlab/tables/task_tables.h"
#include "mlab/tables/test_tables.h"
#include "mlab/tables/type_tables.h"

namespace mlab::tables {

std::span<const Region> all_regions() {
  static constexpr std::array kAll = {
      Region{"measure_enum", measure_enum},
      Region{"measure_rows", measure_rows},
      Region{"measure_documentation", measure_documentation},
      Region{"measure_grammar", measure_grammar},
      Region{"odl_named_words", odl_named_words},
      Region{"odl_feature_words", odl_feature_words},
      Region{"odl_feature_string", odl_feature_string},
      Region{"odl_dictionary", odl_dictionary},
      Region{"task_rows", task_rows},
      Region{"formation_names", formation_names},
      Region{"task_documentation", task_documentation},
      Region{"task_ends", task_ends},
      Region{"task_grammar", task_grammar},
      Region{"formation_documentation", formation_documentation},
      Region{"failsafe_condition_documentation", failsafe_condition_documentation},
      Region{"failsafe_action_documentation", failsafe_action_documentation},
      Region{"mdl_placed_words", mdl_placed_words},
      Region{"mdl_task_words", mdl_task_words},
      Region{"mdl_task_string", mdl_task_string},
      Region{"mdl_statement_words", mdl_statement_words},
      Region{"mdl_clause_words", mdl_clause_words},
      Region{"mdl_option_words", mdl_option_words},
      Region{"mdl_word_string", mdl_word_string},
      Region{"formation_words", formation_words},
      Region{"formation_string", formation_string},
      Region{"mdl_dictionary", mdl_dictionary},
      Region{"object_class_enum", object_class_enum},
      Region{"object_class_documentation", object_class_documentation},
      Region{"world_kind_documentation", world_kind_documentation},
      Region{"channel_documentation", channel_documentation},
      Region{"sensor_documentation", sensor_documentation},
      Region{"sensor_words", sensor_words},
      Region{"sensor_dictionary", sensor_dictionary},
      Region{"test_percept_documentation", test_percept_documentation},
      Region{"value_type_rows", value_type_rows},
      Region{"value_type_documentation", value_type_documentation},
      Region{"value_type_words", value_type_words},
      Region{"historic_type_words", historic_type_words},
      Region{"value_type_dictionary", value_type_dictionary},
      Region{"quantity_documentation", quantity_documentation},
      Region{"quantity_words", quantity_words},
  };
  return kAll;
}

}  // namespace mlab::tables
