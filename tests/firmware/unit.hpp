// Unit tests without a library: registers cases, prints one line a case in Unity's form
// (file:line:name:PASS or FAIL: why) and the summary, so that any reader of Unity's output works.
// No heap, no exceptions: the same tests run on a PC and on the target.
#pragma once

#include <cstdio>
#include <cstring>

namespace unit {

struct Case {
  Case(const char* case_name, const char* case_file, int case_line, void (*case_body)())
      : name(case_name), file(case_file), line(case_line), body(case_body), next(first) {
    first = this;
  }
  const char* name;
  const char* file;
  int line;
  void (*body)();
  Case* next;
  static inline Case* first = nullptr;
  static inline const char* why = nullptr;  // first failed check of the running case
  static inline int why_line = 0;
};

// Runs the cases whose name begins with prefix; returns how many failed.
inline int run(const char* prefix) {
  int tests = 0;
  int failures = 0;
  for (Case* c = Case::first; c != nullptr; c = c->next) {
    if (std::strncmp(c->name, prefix, std::strlen(prefix)) != 0) {
      continue;
    }
    Case::why = nullptr;
    c->body();
    ++tests;
    if (Case::why == nullptr) {
      std::printf("%s:%d:%s:PASS\n", c->file, c->line, c->name);
    } else {
      ++failures;
      std::printf("%s:%d:%s:FAIL: %s\n", c->file, Case::why_line, c->name, Case::why);
    }
  }
  std::printf("-----------------------\n%d Tests %d Failures 0 Ignored\n%s\n", tests, failures,
              failures == 0 ? "OK" : "FAIL");
  return failures;
}

inline bool check(bool passed, const char* what, int line) {
  if (!passed && Case::why == nullptr) {
    Case::why = what;
    Case::why_line = line;
  }
  return passed;
}

}  // namespace unit

#define TEST(name)                                                      \
  static void name();                                                   \
  static const unit::Case case_##name(#name, __FILE__, __LINE__, name); \
  static void name()

// Ends the case at the first failure, in its body and in functions that return void.
#define CHECK(condition)                                   \
  do {                                                     \
    if (!unit::check((condition), #condition, __LINE__)) { \
      return;                                              \
    }                                                      \
  } while (false)
