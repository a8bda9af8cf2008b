// What a person at the terminal sees and does: a progress bar on standard error, and Ctrl-C.
#pragma once

#include <string>

namespace steplock {

// Draws only if standard error is a terminal; erases itself at the end.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what);
  ~ProgressBar();
  void show(double done, const std::string& what = {});

 private:
  std::string what_;
  bool terminal_;
};

// Text of always as many lines on standard error, each time over the last.
class Redrawn {
 public:
  void draw(const std::string& text);

 private:
  long lines_ = 0;
};

// From construction on, the first Ctrl-C only sets a flag; the second one ends the program.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  bool asked() const;
};

}  // namespace steplock
