#include "testbench/sweep/workers.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>
#include <vector>

namespace steplock {
namespace {

// What parent and workers share in memory.
struct Shared {
  std::atomic<std::uint64_t> next = 0;
  std::atomic<bool> stop = false;
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

class SharedMemory {
 public:
  SharedMemory() {
    void* const page =
        mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) throw std::runtime_error("no memory to share with workers");
    shared_ = new (page) Shared;
  }
  ~SharedMemory() { munmap(shared_, sizeof(Shared)); }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  Shared* operator->() const { return shared_; }

 private:
  Shared* shared_;
};

constexpr char kErrorMark = '!';

// One write() of up to PIPE_BUF bytes is never mixed with another worker's.
bool send(int pipe, std::string line) {
  if (line.size() >= PIPE_BUF) line.resize(PIPE_BUF - 1);
  line += '\n';
  return write(pipe, line.data(), line.size()) == static_cast<ssize_t>(line.size());
}

[[noreturn]] void be_worker(const Tasks& tasks, Shared& shared, int pipe) {
  std::signal(SIGINT, SIG_IGN);  // Ctrl-C reaches the whole group; the parent decides
  const auto go_on = [&] { return !shared.stop; };
  try {
    while (go_on()) {
      const std::uint64_t task = shared.next++;
      if (task >= tasks.count) break;
      const auto line = tasks.work(task, go_on);
      if (!line) break;
      if (!send(pipe, *line)) _exit(1);
    }
  } catch (const std::exception& e) {
    send(pipe, kErrorMark + std::string(e.what()));
    _exit(1);
  }
  _exit(0);
}

// Takes whole lines out of what has come so far.
void take_lines(std::string& text, const Tasks& tasks, std::string& error) {
  std::size_t from = 0;
  for (std::size_t end; (end = text.find('\n', from)) != text.npos; from = end + 1) {
    const std::string line = text.substr(from, end - from);
    if (line.starts_with(kErrorMark)) {
      error = line.substr(1);
    } else {
      tasks.take(line);
    }
  }
  text.erase(0, from);
}

}  // namespace

void do_in_processes(const Tasks& tasks) {
  const SharedMemory shared;
  std::array<int, 2> pipe_ends;
  if (pipe(pipe_ends.data()) != 0) throw std::runtime_error("no pipe to workers");
  std::fflush(nullptr);
  std::vector<pid_t> workers;
  for (int k = 0; k < tasks.jobs && static_cast<std::uint64_t>(k) < tasks.count; ++k) {
    const pid_t pid = fork();
    if (pid == 0) {
      close(pipe_ends[0]);
      be_worker(tasks, *shared.operator->(), pipe_ends[1]);
    }
    if (pid > 0) workers.push_back(pid);
  }
  close(pipe_ends[1]);

  std::string text, error;
  std::array<char, 1 << 16> buffer;
  const auto give_up = [&] { shared->stop = true; };
  if (workers.empty() && tasks.count > 0) error = "no worker could be started";
  try {
    for (;;) {
      pollfd ready{.fd = pipe_ends[0], .events = POLLIN, .revents = 0};
      const int found = poll(&ready, 1, 200);
      if (!tasks.go_on() || !error.empty()) give_up();
      if (found <= 0) continue;  // nothing yet, or a signal
      const ssize_t n = read(pipe_ends[0], buffer.data(), buffer.size());
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) break;  // the last worker closed its end
      text.append(buffer.data(), static_cast<std::size_t>(n));
      take_lines(text, tasks, error);
    }
  } catch (const std::exception& e) {
    give_up();
    error = e.what();
  }
  close(pipe_ends[0]);
  for (const pid_t pid : workers) {
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(status) && error.empty()) {
      error = fmt::format("a worker died: {}", strsignal(WTERMSIG(status)));
    }
  }
  if (!error.empty()) throw std::runtime_error(error);
}

}  // namespace steplock
