// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <thread>
#include <utility>

#include "apps/plots/picture.h"
#include "contact/clock.h"

namespace bracket::apps {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;  // without a name: it goes with its last descriptor

/// gnuplot at work, from file to file: with pipes it could wait for us while we wait for it.
struct Process {
  int error = 0;  // of starting it
  pid_t id = 0;
  File in, out, complaint;
};

Process start(const std::string& script) {
  Process process{0, 0, File(std::tmpfile()), File(std::tmpfile()), File(std::tmpfile())};
  if (!process.in || !process.out || !process.complaint) {
    process.error = errno;
    return process;
  }
  const bool written = std::fwrite(script.data(), 1, script.size(), process.in.get()) == script.size();
  if (!written || std::fflush(process.in.get()) != 0) {
    process.error = errno;
    return process;
  }
  std::rewind(process.in.get());
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_adddup2(&streams, fileno(process.in.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&streams, fileno(process.out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&streams, fileno(process.complaint.get()), STDERR_FILENO);
  posix_spawnattr_t manners;  // it dies of the signals that we ignore, and its group with it
  posix_spawnattr_init(&manners);
  sigset_t ignored;
  sigemptyset(&ignored);
  sigaddset(&ignored, SIGPIPE);
  sigaddset(&ignored, SIGXFSZ);
  posix_spawnattr_setsigdefault(&manners, &ignored);
  posix_spawnattr_setpgroup(&manners, 0);
  posix_spawnattr_setflags(&manners, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  char program[] = "gnuplot", defaults[] = "-d";  // -d: not what the user's own start-up file says
  char* const arguments[] = {program, defaults, nullptr};
  process.error = posix_spawnp(&process.id, program, &streams, &manners, arguments, environ);
  posix_spawn_file_actions_destroy(&streams);
  posix_spawnattr_destroy(&manners);
  return process;
}

std::string content(std::FILE* file) {
  std::string text;
  std::rewind(file);
  char buffer[65536];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, file)) > 0;) text.append(buffer, n);
  return text;
}

struct Ended {
  std::string picture;
  std::string fault;  // empty: none
};

// The line of gnuplot's message that says what is wrong: others repeat the command and point into it.
std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

// A full disk cuts a picture short, and gnuplot does not mind.
bool is_whole(const std::string& picture) {
  return picture.ends_with("</svg>\n") || picture.ends_with("</svg>\n\n") || picture.ends_with("IEND\xae\x42\x60\x82");
}

/// \param limit seconds, \param clock since all were started
Ended wait(const Process& process, const Clock& clock, double limit) {
  if (process.error != 0) return {"", fmt::format("gnuplot cannot be started: {}", std::strerror(process.error))};
  int status = 0;
  for (pid_t ended; (ended = waitpid(process.id, &status, WNOHANG)) == 0 || (ended < 0 && errno == EINTR);) {
    if (clock.seconds() >= limit) {
      kill(-process.id, SIGKILL);  // with what it may have started
      while (waitpid(process.id, &status, 0) < 0 && errno == EINTR) {
      }
      return {"", fmt::format("gnuplot did not end within {:g} s", limit)};
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (WIFSIGNALED(status)) return {"", fmt::format("gnuplot was ended: {}", strsignal(WTERMSIG(status)))};
  std::string picture = content(process.out.get());
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || picture.empty())
    return {"", "gnuplot failed: " + last_line(content(process.complaint.get()))};
  if (!is_whole(picture)) return {"", "gnuplot failed: the picture is cut short"};
  return {std::move(picture), ""};
}

Process start(const Picture& picture, const char* terminal) {
  return start(
      fmt::format("set encoding utf8\nset terminal {} size {},{} enhanced font 'sans-serif,14' "
                  "background '#ffffff'\n{}",
                  terminal, picture.width, picture.height, picture.script));
}

}  // namespace

Drawings draw(const std::vector<Picture>& pictures, bool png, std::chrono::seconds limit) {
  const Clock clock;
  std::vector<Process> svgs, pngs;
  for (const Picture& picture : pictures) {
    svgs.push_back(start(picture, "svg"));
    if (png) pngs.push_back(start(picture, "pngcairo"));
  }
  Drawings drawings;
  if (!svgs.empty() && svgs[0].error == ENOENT) drawings.missing = {"pictures: gnuplot is not installed"};
  if (!drawings.missing.empty()) return drawings;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const auto seconds = static_cast<double>(limit.count());
    Ended svg = wait(svgs[i], clock, seconds), bitmap = png ? wait(pngs[i], clock, seconds) : Ended{};
    if (svg.fault.empty())
      drawings.drawn.push_back(
          {pictures[i].name, pictures[i].caption, std::move(svg.picture), std::move(bitmap.picture), pictures[i].wide});
    for (const auto& [ending, fault] : {std::pair{".svg", svg.fault}, std::pair{".png", bitmap.fault}})
      if (!fault.empty()) drawings.missing.push_back(pictures[i].name + ending + ": " + fault);
  }
  return drawings;
}

std::string quoted(const std::string& text) {
  std::string result = "'";  // single: in double quotes gnuplot runs what stands between backquotes as a command
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return result + "'";
}

}  // namespace bracket::apps
