#include "app/switches.hpp"

#include <poll.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace cleave::app {
namespace {

std::atomic<solver::Wishes*> listening{nullptr};
std::atomic<int> received{0};

void on_signal(int number) {
  if (received.exchange(number) != 0) {  // the second one: the user means it
    std::signal(number, SIG_DFL);
    std::raise(number);
  }
  if (solver::Wishes* wishes = listening.load()) {
    wishes->signal = true;
    wishes->stop = true;
  }
}

constexpr int poll_interval = 200;  // [ms]: soon enough for a person, nothing for the machine

}  // namespace

Switches::Switches(solver::Wishes& wishes, std::filesystem::path run_directory)
    : wishes_(wishes), run_directory_(std::move(run_directory)) {
  received = 0;
  listening = &wishes_;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  watcher_ = std::thread([this] { watch(); });
}

Switches::~Switches() {
  done_ = true;
  watcher_.join();
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  listening = nullptr;
}

int Switches::signal_received() {
  return received;
}

void Switches::obey(std::string_view text) {
  const auto asked = [&](std::string_view name) { return text.find(name) != std::string_view::npos; };
  if (asked("sw1")) wishes_.stop = true;
  if (asked("sw2")) wishes_.report = true;
  if (asked("sw3")) wishes_.restart = true;
  if (asked("sw4")) wishes_.field = true;
}

void Switches::watch() {
  const bool terminal = isatty(STDIN_FILENO);
  bool open = terminal;
  while (!done_) {
    // A background job must not read the terminal: it would be stopped.
    const bool ours = open && tcgetpgrp(STDIN_FILENO) == getpgrp();
    pollfd input{ours ? STDIN_FILENO : -1, POLLIN, 0};
    if (poll(&input, 1, poll_interval) > 0 && (input.revents & (POLLIN | POLLHUP))) {
      char line[256];
      const ssize_t count = read(STDIN_FILENO, line, sizeof line);
      if (count > 0)
        obey({line, static_cast<std::size_t>(count)});
      else
        open = false;
    }
    for (const auto& folder : {run_directory_, std::filesystem::path(".")}) {
      const auto path = folder / "d3kil";
      std::ifstream file(path, std::ios::binary);
      if (!file) continue;
      std::string text(256, '\0');
      file.read(text.data(), static_cast<std::streamsize>(text.size()));
      obey({text.data(), static_cast<std::size_t>(file.gcount())});
      std::error_code ignored;
      std::filesystem::remove(path, ignored);
    }
  }
}

}  // namespace cleave::app
