// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <type_traits>

#include "apps/commands/interrupt.h"
#include "apps/commands/progress.h"
#include "bounds/bounds.h"

namespace bracket::apps {

/// What passes between a command that solves and whoever waits for it: a line of progress that way, Ctrl-C this way.
class Watch {
 public:
  /// \param wanted whether a terminal gets progress
  explicit Watch(bool wanted = true) : progress_(wanted) {}

  void show(const std::string& stage) const { progress_.show(stage); }
  void clear() const { progress_.clear(); }  ///< before something else is printed
  bool interrupted() const { return interrupt_.requested(); }

  /// An observer that shows the stages of a run, each behind `label`, and ends the run after the level in which Ctrl-C
  /// was pressed.
  /// \param level told as each level is done
  /// \pre the watch outlives the run
  template <int dim = 2>
  bounds::Observer<dim> observer(std::string label,
                                 std::type_identity_t<std::function<void(const bounds::Outcome<dim>&)>> level);

 private:
  void stop_if_interrupted();

  Interrupt interrupt_;
  Progress progress_;
  std::stop_source stop_;
};

}  // namespace bracket::apps
