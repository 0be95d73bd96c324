// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>

#include "tests/support/folder.h"

namespace bracket::apps::tests {

/// How a command ended and what it said.
struct Ended {
  int status;
  std::string out;
  std::string err;
};

/// An empty directory of its own for each test, in which commands are run.
class Command : public testing::Test {
  bracket::tests::Folder folder_;

 protected:
  /// Runs a shell command in the directory; "bracket" in it stands for the built program.
  Ended shell(const std::string& command) const;

  /// Runs the program with `arguments` in the directory and sends it `signal` once the file `name` there has `lines`
  /// lines. The status is minus the signal where that ended it.
  Ended signalled(const std::string& arguments, const std::string& name, int lines, int signal) const;
  void write(const std::string& name, const std::string& content) const { folder_.write(name, content); }
  std::string read(const std::string& name) const;  ///< \pre there is such a file

  const std::filesystem::path& directory = folder_.path();
};

/// A bound as it is printed: the numbers of the line of the answer that begins with this name.
/// \pre there is such a line, with an interval
std::pair<double, double> told_of(const std::string& name, const std::string& out);

/// A text whose lines were broken to fit a terminal, with these lines whole.
std::string unbroken(const std::string& text);

/// How many columns the widest line of a text takes.
std::size_t widest(const std::string& text);

/// Arguments that make a scene be refined without end.
extern const char* const endlessly;

/// Two blocks pressed together on the left half of the top, pulled apart on the right, on few cells (docs/theory.md
/// §9.2).
extern const char* const two_blocks;

/// Half a beam in bending, on a shear-free wall, without contact: σ_xx = y, else zero, u quadratic. Both formulations
/// hold the exact solution.
extern const char* const bending;

}  // namespace bracket::apps::tests
