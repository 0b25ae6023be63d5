// What the thread sanitizer is told of Cyclone, whose library it does not see into.
//
// Cyclone synchronises by atomic operations of its own, which are not instrumented; so what its threads hand
// to each other looks like races. `called_from_lib` takes what the library itself does (its locks, its
// memory, its sockets) out of the picture, and leaves in all that our code does, also where the library calls
// it. handed_over.h tells what the library's locks see to for our code. Its security plugins, which are
// loaded and unloaded with each participant, and the libcrypto that they call can't be named so: what is said
// of their own frames is left out.

#ifdef MLAB_SANITIZE_THREAD
extern "C" const char* __tsan_default_suppressions() {
  return "called_from_lib:libddsc.so\nrace:libdds_security_\nrace:libcrypto.so\n";
}
#endif
