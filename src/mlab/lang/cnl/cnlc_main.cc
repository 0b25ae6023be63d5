// The compiler that builds the component library: CNL files in, C++ out.
//
//   cnlc FILE.cnl... -o OUT.cc [--module] [--depfile FILE]    the procedures of the files
//   cnlc --table FILE.cnl... [--name FUNCTION] -o OUT.cc      a function that gives the procedures of all the
//   files
//
// Exit status 0, or 2 with diagnostics on standard error; then nothing is written.

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/generate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/text/diagnostic.h"

namespace {

struct Options {
  std::vector<std::string> files;
  std::string output;
  std::string depfile;
  std::string function = "mlab_library_behaviors";
  bool is_table = false;
  bool is_module = false;
};

bool read_options(int count, char** words, Options& options) {
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    std::string* value = word == "-o"          ? &options.output
                         : word == "--depfile" ? &options.depfile
                         : word == "--name"    ? &options.function
                                               : nullptr;
    if (value) {
      if (++i == count) return false;
      *value = words[i];
    } else if (word == "--table") {
      options.is_table = true;
    } else if (word == "--module") {
      options.is_module = true;
    } else if (word.starts_with("-")) {
      return false;
    } else {
      options.files.emplace_back(word);
    }
  }
  return !options.output.empty() && (options.is_table || options.files.size() == 1);
}

bool holds(const std::string& path, const std::string& text) {
  std::ifstream file(path, std::ios::binary);
  std::string is;
  if (file) is.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  return file && is == text;
}

// A file that is so already is left alone: what is made of it need not be made anew.
bool write_file(const std::string& path, const std::string& text) {
  if (holds(path, text)) return true;
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) fmt::print(stderr, "cnlc: cannot write `{}`\n", path);
  return static_cast<bool>(file);
}

bool compile(const Options& options) {
  mlab::text::Diagnostics diagnostics;
  std::vector<std::string> included;
  std::string text;
  if (const auto source = mlab::text::read_source(options.files[0])) {
    const mlab::cnl::Tree tree = mlab::cnl::load(*source, diagnostics, &included);
    mlab::cnl::check_declarations(tree, diagnostics);
    if (!diagnostics.has_errors()) text = mlab::cnl::generate(tree, {options.output, options.is_module});
  } else {
    diagnostics.report(source.error());
  }
  fmt::print(stderr, "{}", mlab::text::render(diagnostics));
  if (diagnostics.has_errors() || !write_file(options.output, text)) return false;
  if (options.depfile.empty()) return true;
  std::string dependencies = options.output + ":";
  for (const std::string& file : included) dependencies += " \\\n  " + file;
  return write_file(options.depfile, dependencies + "\n");
}

}  // namespace

int main(int count, char** words) {
  Options options;
  if (!read_options(count, words, options)) {
    fmt::print(stderr,
               "usage: cnlc FILE.cnl -o OUT.cc [--module] [--depfile FILE]\n       cnlc --table FILE.cnl... "
               "[--name FUNCTION] -o OUT.cc\n");
    return 2;
  }
  const bool done = options.is_table ? write_file(options.output,
                                                  mlab::cnl::generate_table(options.files, options.function))
                                     : compile(options);
  return done ? 0 : 2;
}
