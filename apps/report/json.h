// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "apps/report/report.h"

namespace bracket::apps {

std::string name(scene::Status status);  ///< as JSON has it

/// What every file of results begins with: schema, program and, where there is one, the scene.
nlohmann::ordered_json heading();
template <int dim> nlohmann::ordered_json heading(const scene::Scene<dim>& scene);

/// In space the sizes of cells are volumes, angles those between faces, and there is the worst shape.
template <int dim> nlohmann::ordered_json quality_json(const scene::Mesh<dim>& mesh);
nlohmann::ordered_json oscillation_json(const scene::Oscillation& oscillation);

/// As files hold it. Names may hold any bytes; what is not UTF-8 is replaced, rather than the report refused.
std::string dump(const nlohmann::ordered_json& json);

/// A level as report.json and study.json tell it.
nlohmann::ordered_json level_json(const bounds::Level& level, const LevelSeconds& around);

}  // namespace bracket::apps
