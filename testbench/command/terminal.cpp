#include "testbench/command/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

namespace steplock {
namespace {

// A signal handler can reach nothing but a global of this type.
volatile std::sig_atomic_t interrupted = 0;

void on_interrupt(int) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

ProgressBar::ProgressBar(std::string what)
    : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::show(double done, const std::string& what) {
  if (!terminal_) return;
  constexpr int kWidth = 40;
  const int full = static_cast<int>(kWidth * std::clamp(done, 0.0, 1.0));
  fmt::print(stderr, "\r{}{} [{:=<{}}{: <{}}] {:3.0f} %\033[K", what_, what, "", full, "", kWidth - full,
             100 * done);
  std::fflush(stderr);
}

void Redrawn::draw(const std::string& text) {
  if (lines_ > 0) fmt::print(stderr, "\033[{}A", lines_);
  for (const char c : text) {
    if (c == '\n') fmt::print(stderr, "\033[K");
    std::fputc(c, stderr);
  }
  std::fflush(stderr);
  lines_ = std::ranges::count(text, '\n');
}

Interrupt::Interrupt() {
  interrupted = 0;
  std::signal(SIGINT, on_interrupt);
}
Interrupt::~Interrupt() { std::signal(SIGINT, SIG_DFL); }
bool Interrupt::asked() const { return interrupted != 0; }

}  // namespace steplock
