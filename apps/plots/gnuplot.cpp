// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

#include "apps/plots/picture.h"

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
  char program[] = "gnuplot", defaults[] = "-d";  // -d: not what the user's own start-up file says
  char* const arguments[] = {program, defaults, nullptr};
  process.error = posix_spawnp(&process.id, program, &streams, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&streams);
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

Ended wait(const Process& process) {
  if (process.error != 0) return {"", fmt::format("gnuplot cannot be started: {}", std::strerror(process.error))};
  int status = 0;
  while (waitpid(process.id, &status, 0) < 0 && errno == EINTR) {
  }
  std::string picture = content(process.out.get());
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || picture.empty())
    return {"", "gnuplot failed: " + last_line(content(process.complaint.get()))};
  return {std::move(picture), ""};
}

Process start(const Picture& picture, const char* terminal) {
  return start(
      fmt::format("set encoding utf8\nset terminal {} size {},{} enhanced font 'sans-serif,14' "
                  "background '#ffffff'\n{}",
                  terminal, picture.width, picture.height, picture.script));
}

}  // namespace

Drawings draw(const std::vector<Picture>& pictures, bool png) {
  std::vector<Process> svgs, pngs;
  for (const Picture& picture : pictures) {
    svgs.push_back(start(picture, "svg"));
    if (png) pngs.push_back(start(picture, "pngcairo"));
  }
  Drawings drawings;
  if (!svgs.empty() && svgs[0].error == ENOENT) drawings.missing = {"pictures: gnuplot is not installed"};
  if (!drawings.missing.empty()) return drawings;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    Ended svg = wait(svgs[i]), bitmap = png ? wait(pngs[i]) : Ended{};
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
