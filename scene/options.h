// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

/// What can be chosen in a scene, and what it is called in scene files, messages and reports.
namespace bracket::scene {

enum class Plane { strain, stress };
enum class ConditionKind { fixed, sliding, traction, pressure };
enum class Strategy { none, uniform, adaptive };
enum class Dual { hybrid, uzawa, local };
enum class Law { frictionless, bonded, bilateral, winkler, tresca, coulomb };
enum class QuantityKind { displacement, body, rotation, force, opening, reaction, stress, energy, slip };
enum class StressComponent { xx, yy, xy, mean, zz, yz, xz };
enum class ForceComponent { normal, shear };

/// The names of an option's values, in their order.
template <class Option> inline constexpr std::array<const char*, 0> option_names{};
template <> inline constexpr std::array option_names<Plane>{"strain", "stress"};
template <> inline constexpr std::array option_names<ConditionKind>{"fixed", "sliding", "traction", "pressure"};
template <> inline constexpr std::array option_names<Strategy>{"none", "uniform", "adaptive"};
template <> inline constexpr std::array option_names<Dual>{"hybrid", "uzawa", "local"};
template <>
inline constexpr std::array option_names<Law>{"frictionless", "bonded", "bilateral", "winkler", "tresca", "coulomb"};
template <>
inline constexpr std::array option_names<QuantityKind>{"displacement", "body",   "rotation", "force", "opening",
                                                       "reaction",     "stress", "energy",   "slip"};
template <> inline constexpr std::array option_names<StressComponent>{"xx", "yy", "xy", "mean", "zz", "yz", "xz"};
template <> inline constexpr std::array option_names<ForceComponent>{"normal", "shear"};

template <class Option> std::string name(Option option) {
  return option_names<Option>[static_cast<std::size_t>(option)];
}

}  // namespace bracket::scene
