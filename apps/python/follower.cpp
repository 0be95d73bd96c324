// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "apps/python/module.h"

namespace bracket::python {

namespace py = pybind11;

namespace {

void raise_signals() {
  const py::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace

template <int dim> bounds::Observer<dim> Follower<dim>::observer() {
  return {.stage = [](const std::string&) { raise_signals(); },
          .level = [this](const bounds::Outcome<dim>& so_far) { tell(so_far); },
          .stop = stop_.get_token()};
}

template <int dim> void Follower<dim>::tell(const bounds::Outcome<dim>& so_far) {
  raise_signals();
  const py::gil_scoped_acquire gil;
  if (progress_.is_none()) return;
  const py::object answer = progress_(std::make_shared<Result<dim>>(Result<dim>{scene_, so_far}));
  if (answer.is(py::bool_(false))) stop_.request_stop();
}

template class Follower<2>;
template class Follower<3>;

std::string notebook_html(const std::string& lines, const std::function<std::string()>& svg) {
  const auto escaped = py::module_::import("html").attr("escape");
  std::string html = fmt::format("<pre>{}</pre>", escaped(lines).cast<std::string>());
  const std::string picture = svg();
  if (picture.empty()) return html;
  // A picture of its own, whose names and styles stay within it.
  const auto encoded = py::module_::import("base64").attr("b64encode")(py::bytes(picture)).attr("decode")();
  return html + fmt::format("<img alt=\"The first picture of the report\" src=\"data:image/svg+xml;base64,{}\">",
                            encoded.cast<std::string>());
}

}  // namespace bracket::python
