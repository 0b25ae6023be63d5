#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mlab/flow/network.h"
#include "mlab/lang/cnl/tree.h"

namespace mlab::robot_build {

/// What a robot executable is made from: a network that has been checked.
struct RobotSource {
  std::string name;    ///< of the program
  std::string origin;  ///< the file it was written in, without its folder
  flow::Network network;
  std::map<std::string, double> body;                        ///< as robot::RobotProgram has it
  std::vector<std::shared_ptr<const cnl::Tree>> procedures;  ///< files that bring procedures, in their order
  std::string version;                                       ///< of this missionlab
  bool is_closed = false;                                    ///< who runs it does not see its nodes
  std::string agent =
      {};  ///< path of `mlab-agent` here, for who starts it as a member of a fleet; empty: elsewhere
};

/// One file of generated C++, compiled by itself.
struct CppFile {
  std::string name;  ///< without folder and ending; unique
  std::string text;
  std::shared_ptr<const cnl::Tree> procedures;  ///< whose code it is; null: it only wires nodes
};

/// C++ for a robot executable: `main`, one file for each file of procedures, and one for the nodes of each
/// part of the network. A part is what a node name says before its last dot, so an assemblage's nodes stand
/// together, and a change of one assemblage changes no text of another. The same source gives the same files,
/// byte for byte.
std::vector<CppFile> emit_cpp(const RobotSource& robot);

/// All of them one after another, for a person to read.
std::string joined(const std::vector<CppFile>& files);

}  // namespace mlab::robot_build
