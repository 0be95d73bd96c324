// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/commands/watch.h"

#include <utility>

namespace bracket::apps {

template <int dim>
bounds::Observer<dim> Watch::observer(std::string label,
                                      std::type_identity_t<std::function<void(const bounds::Outcome<dim>&)>> level) {
  return {.stage =
              [this, label = std::move(label)](const std::string& stage) {
                show(label + stage);
                stop_if_interrupted();
              },
          .level =
              [this, level = std::move(level)](const bounds::Outcome<dim>& so_far) {
                level(so_far);
                stop_if_interrupted();
              },
          .stop = stop_.get_token()};
}

template bounds::Observer<2> Watch::observer(std::string, std::function<void(const bounds::Outcome<2>&)>);
template bounds::Observer<3> Watch::observer(std::string, std::function<void(const bounds::Outcome<3>&)>);

// A handler of signals can request nothing itself, so it is asked wherever the run lets us.
void Watch::stop_if_interrupted() {
  if (interrupted()) stop_.request_stop();
}

}  // namespace bracket::apps
