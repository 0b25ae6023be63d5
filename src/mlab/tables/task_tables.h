#pragma once

#include <string>

namespace mlab::tables {

/// TypeScript: the commands of the console's menu; the formations.
std::string task_rows();
std::string formation_names();
/// Documentation: what each command does and takes; when it is done; how it is written; the formations.
std::string task_documentation();
std::string task_ends();
std::string task_grammar();
std::string formation_documentation();
/// Words of missions, for editors and fuzzers.
std::string mdl_placed_words();
std::string mdl_task_words();
std::string mdl_task_string();
std::string mdl_statement_words();
std::string mdl_clause_words();
std::string mdl_option_words();
std::string mdl_word_string();
std::string formation_words();
std::string formation_string();
std::string mdl_dictionary();

}  // namespace mlab::tables
