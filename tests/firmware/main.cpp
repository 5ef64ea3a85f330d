#include <cstdio>
#include <cstring>

#include "unit.hpp"

// Runs the cases whose names begin with the argument; "--list" prints all names instead.
int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--list") == 0) {
    for (const unit::Case* c = unit::Case::first; c != nullptr; c = c->next) {
      std::printf("%s\n", c->name);
    }
    return 0;
  }
  // Small numbers are taken for signals by some runners; the lines above say what failed.
  return unit::run(argc > 1 ? argv[1] : "") == 0 ? 0 : 100;
}
