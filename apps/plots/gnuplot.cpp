// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

#include "apps/plots/picture.h"
#include "apps/report/html.h"
#include "scene/process.h"

namespace bracket::apps {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;  // without a name: it goes with its last descriptor

/// gnuplot at work, from file to file: with pipes it could wait for us while we wait for it.
struct Plot {
  scene::Process process;
  File in, out, complaint;
};

Plot start(const std::string& script) {
  Plot plot{{}, File(std::tmpfile()), File(std::tmpfile()), File(std::tmpfile())};
  if (!plot.in || !plot.out || !plot.complaint) {
    plot.process.error = errno;
    return plot;
  }
  const bool written = std::fwrite(script.data(), 1, script.size(), plot.in.get()) == script.size();
  if (!written || std::fflush(plot.in.get()) != 0) {
    plot.process.error = errno;
    return plot;
  }
  std::rewind(plot.in.get());
  // -d: not what the user's own start-up file says. In a group of its own, as it starts programs itself.
  plot.process = scene::start({"gnuplot", "-d"}, fileno(plot.in.get()), fileno(plot.out.get()),
                              fileno(plot.complaint.get()), true);
  return plot;
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

/// \param end when it has to have ended, `limit` after all were started
Ended wait(const Plot& plot, std::chrono::steady_clock::time_point end, std::chrono::seconds limit) {
  const scene::Process& process = plot.process;
  if (process.error != 0) return {"", fmt::format("gnuplot cannot be started: {}", std::strerror(process.error))};
  const std::optional<int> status = scene::status_of(process, end);
  if (!status) return {"", fmt::format("gnuplot did not end within {} s", limit.count())};
  if (WIFSIGNALED(*status)) return {"", fmt::format("gnuplot was ended: {}", strsignal(WTERMSIG(*status)))};
  std::string picture = content(plot.out.get());
  if (!WIFEXITED(*status) || WEXITSTATUS(*status) != 0 || picture.empty())
    return {"", "gnuplot failed: " + last_line(content(plot.complaint.get()))};
  if (!is_whole(picture)) return {"", "gnuplot failed: the picture is cut short"};
  return {std::move(picture), ""};
}

// A picture for whoever does not see it, and without what a pointer over it would be told of gnuplot's own.
std::string described(std::string svg, const std::string& caption) {
  for (std::size_t from = 0; (from = svg.find("<title>", from)) != std::string::npos;)
    svg.erase(from, svg.find("</title>", from) + 8 - from);
  return svg.insert(svg.find("<svg") + 4, " role=\"img\" aria-label=\"" + escaped(caption) + "\"");
}

Plot start(const Picture& picture, const char* terminal) {
  return start(
      fmt::format("set encoding utf8\nset terminal {} size {},{} enhanced font 'sans-serif,16' "
                  "background '#ffffff'\n{}",
                  terminal, picture.width, picture.height, picture.script));
}

}  // namespace

Drawings draw(const std::vector<Picture>& pictures, bool png, std::chrono::seconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  std::vector<Plot> svgs, pngs;
  for (const Picture& picture : pictures) {
    svgs.push_back(start(picture, "svg"));
    if (png) pngs.push_back(start(picture, "pngcairo"));
  }
  Drawings drawings;
  if (!svgs.empty() && svgs[0].process.error == ENOENT) drawings.missing = {"pictures: gnuplot is not installed"};
  if (!drawings.missing.empty()) return drawings;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    Ended svg = wait(svgs[i], end, limit), bitmap = png ? wait(pngs[i], end, limit) : Ended{};
    if (svg.fault.empty())
      drawings.drawn.push_back({pictures[i].name, pictures[i].caption,
                                described(std::move(svg.picture), pictures[i].caption), std::move(bitmap.picture),
                                pictures[i].wide});
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
