// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "scene/mesh/abaqus_cards.h"
#include "scene/mesh/raw_mesh.h"

/// The model of an Abaqus input file: an instance of each part, and the whole.
namespace bracket::scene {

/// Where an instance of a part lies: rotated after it was moved.
struct AbaqusPlacement {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();

  Eigen::Vector3d operator()(const Eigen::Vector3d& x) const { return centre + rotation * (x + translation - centre); }
};
/// Of the data of *INSTANCE. \throw Error (mesh): not numbers
AbaqusPlacement placement_of(const AbaqusCard& instance);

struct AbaqusSet {
  std::string name;
  bool internal = false;  ///< made by a program for its own use
  int rank = 2;           ///< of its name for bodies: 0 it has a section, 1 it was named with its elements
  std::vector<int> nodes, cells, lines;  ///< places in the raw mesh
};
using AbaqusSets = std::map<std::string, AbaqusSet>;  ///< by names in capitals

/// Labels and names hold within an instance, or for the model as a whole.
struct AbaqusScope {
  using Tag = RawMesh::Tag;
  std::string name;  ///< of the instance
  std::map<Tag, int> nodes, cells, lines;
  std::map<Tag, std::string> others;  ///< types of elements that are not read
  std::map<int, bool> shell;          ///< of each cell
  AbaqusSets node_sets, element_sets, surfaces;
};

struct AbaqusModel {
  RawMesh raw;
  std::vector<AbaqusScope> scopes = {{}};  ///< the model's, then those of instances
  std::vector<RawMesh::Node> as_written;   ///< nodes before they were placed, for their digits

  AbaqusScope& scope(const std::string& instance, const AbaqusCard::Line& line);  ///< \throw Error (mesh): unknown
};

/// The nodes and elements of a card, if it is of such, into a scope of the model.
void add_geometry(AbaqusModel& model, std::size_t scope, const AbaqusCard& card, const AbaqusPlacement& place);
/// The node set, element set, surface or section of a card, if it is one.
void add_set(AbaqusModel& model, std::size_t scope, const AbaqusCard& card);

AbaqusScope::Tag label(std::string_view field, const AbaqusCard::Line& line);
double coordinate(std::string_view field, const AbaqusCard::Line& line);

}  // namespace bracket::scene
